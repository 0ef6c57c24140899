// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/examination.hpp"

#include <fmt/format.h>

#include <charconv>

#include "core/base/error.hpp"
#include "core/io/run/agent_log.hpp"
#include "core/io/run/log_schemas.hpp"

namespace arcbid {
namespace {

using nlohmann::json;

void lose(LogReport& log, RunLogReader::Lost lost) {
  if (!log.lost.empty()) {
    RunLogReader::Lost& before = log.lost.back();
    if (before.to_seq && *before.to_seq + 1 == lost.from_seq && before.why == lost.why) {
      before.to_seq = lost.to_seq;
      return;
    }
  }
  log.lost.push_back(std::move(lost));
}

/// Numbers above 2^53 are hexadecimal text.
std::uint64_t number_in(const json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  std::uint64_t out = 0;
  if (const auto* text = value.get_ptr<const std::string*>())
    std::from_chars(text->data(), text->data() + text->size(), out, 16);
  return out;
}

/// Reads one log through.
class Examination {
 public:
  Examination(LogReport& log, std::size_t number, Evidence& evidence)
      : log_(log), number_(number), evidence_(evidence) {}

  void read() {
    log_.wal = wal_state(log_.file);
    std::error_code none;
    if (!std::filesystem::exists(log_.file, none)) {
      log_.not_read = "there is only its write-ahead log";
      return;
    }
    try {
      const RunLogReader reader(log_.file);
      const LogSchemas schemas(reader);
      log_.other_schema = schemas.other();
      log_.unread_schema = schemas.unread();
      const json process = reader.meta("process");
      if (process.is_object()) log_.pid = number_in(process.value("pid", json()));
      reader.read_intact([&](const auto& record) { return take(record, schemas); },
                         [this](const auto& lost) { lose(log_, lost); });
      log_.complaints = reader.complaints();
    } catch (const InputError& error) {
      log_.not_read = error.what();
    }
  }

 private:
  bool take(const RunLogReader::Record& record, const LogSchemas& schemas) {
    try {
      // By a schema that is none, nothing can be said of what is in it.
      if (!schemas.is_unread(record.kind)) understand(record, schemas.of(record.kind));
    } catch (const InputError& error) {
      lose(log_, {record.seq, record.seq, fmt::format("{}: {}", record.kind, error.what())});
      return true;
    }
    if (log_.records++ == 0) log_.first_seq = record.seq, log_.first_ns = record.t_ns;
    log_.last_seq = record.seq;
    log_.last_ns = record.t_ns;
    return true;
  }

  void understand(const RunLogReader::Record& record, const StoredSchema* stored) {
    if (record.kind == log_kind::step)
      return understand(decode<Step>(record.body, stored), record.t_ns);
    if (record.kind == log_kind::mission) return void(decode<Mission>(record.body, stored));
    if (record.kind == log_kind::birth) return void(decode<Birth>(record.body, stored));
    if (record.kind == log_kind::route) return void(decode<PlannedRoute>(record.body, stored));
    if (record.kind == log_kind::heard_status)
      return hear(decode<StatusMessage>(record.body, stored).header, record.t_ns);
    const json body = json::parse(record.body, nullptr, false);
    if (body.is_discarded()) throw InputError("is not JSON");
    if (record.kind == log_kind::end) log_.ended_by = end_in(body);
    if (record.kind == "sent_malformed") say_malformed(body);
  }

  static std::string end_in(const json& body) {
    for (const char* key : {"by", "reason"})
      if (body.is_object() && body.contains(key) && body[key].is_string()) return body[key];
    return "itself";
  }

  void understand(const Step& step, TimeNs t_ns) {
    const auto say = [this](const auto& messages) {
      for (const auto& message : messages) {
        const Header& h = message.header;
        evidence_.sent(number_, {h.sender, h.incarnation, h.sequence});
      }
    };
    say(step.update.bids), say(step.update.relays), say(step.update.statuses);
    if (step.update.refused) return;
    std::visit(
        [&](const auto& what) {
          if constexpr (requires { what.header; }) hear(what.header, t_ns);
        },
        step.event.what);
  }

  /// Before it had the mission, an agent asked for it, and kept no record of that.
  void hear(const Header& header, TimeNs t_ns) {
    if (header.mission_digest != 0)
      evidence_.heard({header.sender, header.incarnation, header.sequence}, t_ns);
  }

  /// What a fault schedule made it say.
  void say_malformed(const json& body) {
    const json header =
        body.is_object() ? body.value("/message/header"_json_pointer, json()) : json();
    if (!header.is_object()) return;
    evidence_.sent(number_, {AgentId{log_.agent}, number_in(header.value("incarnation", json())),
                             number_in(header.value("sequence", json()))});
  }

  LogReport& log_;
  std::size_t number_;
  Evidence& evidence_;
};

}  // namespace

void examine_log(LogReport& log, std::size_t number, Evidence& evidence) {
  Examination(log, number, evidence).read();
}

}  // namespace arcbid
