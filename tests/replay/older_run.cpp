// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/replay/older_run.hpp"

#include "core/io/run/agent_log.hpp"
#include "core/io/run/log_files.hpp"
#include "core/io/run/run_log_reader.hpp"
#include "tests/record/other_build.hpp"

namespace arcbid::testing {
namespace {

namespace fs = std::filesystem;

std::string older(const RunLogReader::Record& record, const StoredSchema& schema) {
  const auto again = [&]<class Record>(std::type_identity<Record>) {
    return OtherBuild::encode(decode<Record>(record.body), schema);
  };
  if (record.kind == log_kind::step) return again(std::type_identity<Step>());
  if (record.kind == log_kind::mission) return again(std::type_identity<Mission>());
  if (record.kind == log_kind::birth) return again(std::type_identity<Birth>());
  return again(std::type_identity<PlannedRoute>());
}

}  // namespace

void make_older(const fs::path& run,
                const std::function<std::string(const std::string&, std::string)>& change) {
  for (const fs::path& file : agents_logs(run)) {
    const fs::path was = file.string() + ".was";
    for (const char* part : {"", "-wal", "-shm"})
      if (fs::exists(file.string() + part)) fs::rename(file.string() + part, was.string() + part);
    {
      const RunLogReader in(was);
      RunLog out(file);
      for (const auto& [key, value] : in.meta()) out.meta(key, value);
      out.meta("build", {{"version", "0.0.9"}, {"commit", "01dbeef"}});
      std::map<std::string, StoredSchema, std::less<>> schemas;
      for (const RecordKind& kind : in.kinds()) {
        const std::string schema = kind.encoding == "cdr" ? change(kind.name, kind.schema) : "";
        out.kind({kind.name, kind.encoding, schema});
        if (!schema.empty()) schemas.emplace(kind.name, StoredSchema(schema));
      }
      in.read([&](const RunLogReader::Record& record) {
        const auto schema = schemas.find(record.kind);
        out.append_as(
            record.seq, record.t_ns, out.kind({std::string(record.kind), "", ""}),
            schema == schemas.end() ? std::string(record.body) : older(record, schema->second));
        return true;
      });
    }
    for (const char* part : {"", "-wal", "-shm"}) fs::remove(was.string() + part);
  }
}

std::string otherwise(const std::string& kind, std::string schema) {
  if (kind == "step") {
    schema = with(schema, "Header", "uint64 task_digest", "");
    schema = with(schema, "Header", "uint64 sequence", "uint32 sequence");
    schema = with(schema, "Claim", "uint32 task", "");
    schema = with(schema, "Claim", "float64 bid", "float64 bid\nstring note\nuint32 task");
  }
  if (kind == "mission") schema = with(schema, "AuctionSettings", "bool audit_bids", "");
  if (kind == "birth") schema = with(schema, "", "uint32 agent", "uint16[] spare\nuint8 agent");
  if (kind == "route") schema = with(schema, "Route", "float64 crsom_m", "");
  return schema;
}

std::string otherwise_but_whole(const std::string& kind, std::string schema) {
  if (kind == "step") {
    schema = with(schema, "Header", "uint64 sequence", "uint32 sequence");
    schema = with(schema, "Claim", "uint32 task", "");
    schema = with(schema, "Claim", "float64 bid", "float64 bid\nstring note\nuint32 task");
  }
  if (kind == "mission")
    schema = with(schema, "AuctionSettings", "uint32 max_tasks", "int64[] spare\nuint64 max_tasks");
  if (kind == "birth") schema = with(schema, "", "uint32 agent", "uint8 agent");
  if (kind == "route") schema = with(schema, "Route", "float64 crsom_m", "bool b\nfloat64 crsom_m");
  return schema;
}

}  // namespace arcbid::testing
