// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/settings_file.hpp"

#include "core/io/faults/document.hpp"
#include "core/io/faults/kinds.hpp"

namespace arcbid {
namespace {

using yaml::field;
using yaml::Keys;
using yaml::Kind;
using yaml::Place;
using yaml::Report;

constexpr const char* what = "a config of worlds";

/// [least, most].
template <class T>
Kind<Range<T>> range_of(const Kind<T>& kind) {
  const std::string legal = fmt::format("[least, most], each {}", kind.legal);
  return {legal,
          [=](const Place& place, Range<T>& range, Report& report) {
            if (!place.node.IsSequence() || place.node.size() != 2)
              return report.problem(place.at, place.path, "is not " + legal);
            kind.read({place.node[0], place.node[0].Mark(), place.path}, range.least, report);
            kind.read({place.node[1], place.node[1].Mark(), place.path}, range.most, report);
            if (range.most < range.least)
              report.problem(
                  place.at, place.path,
                  fmt::format("{} is above {}", kind.print(range.least), kind.print(range.most)));
          },
          [=](const Range<T>& range) {
            return fmt::format("[{}, {}]", kind.print(range.least), kind.print(range.most));
          }};
}

template <class E, std::size_t n>
Kind<std::vector<E>> some_of(const std::array<std::string_view, n>& names) {
  Kind<std::vector<E>> kind = yaml::list_of(yaml::choice(yaml::enumerators<E>(names)), 100,
                                            fmt::format("of {}", fmt::join(names, ", ")));
  kind.read = [read = kind.read](const Place& place, std::vector<E>& list, Report& report) {
    list.clear();  // what the file says stands instead of the default
    read(place, list, report);
  };
  return kind;
}

/// Odds of every fault by its name.
Keys<std::array<double, world_fault_names.size()>> odds_keys() {
  Keys<std::array<double, world_fault_names.size()>> keys;
  for (std::size_t f = 0; f < world_fault_names.size(); ++f)
    keys.push_back(field<std::array<double, world_fault_names.size()>>(
        std::string(world_fault_names[f]), [f](auto& odds) -> auto& { return odds[f]; },
        yaml::number<double>(0, 1), "Odds that a world has this fault."));
  return keys;
}

Keys<WorldSettings> auction_keys() {
  using W = WorldSettings;
  return {
      field<W>("agents", &W::agents, range_of(yaml::number<std::uint32_t>(1, 64)), "Fleet size."),
      field<W>("tasks", &W::tasks, range_of(yaml::number<std::uint32_t>(1, 1000)),
               "Tasks after the split."),
      field<W>("policies", &W::policies, some_of<PolicyKind>(policy_names), "One is drawn."),
      field<W>("scores", &W::scores, some_of<ScoreKind>(score_names), "One is drawn."),
      field<W>("trades", &W::trades, some_of<TradesKind>(trades_names),
               "Exchanges after agreement; one is drawn."),
      field<W>("topologies", &W::topologies, some_of<TopologyKind>(topology_names),
               "One is drawn; geometric: who is near enough to whom."),
      field<W>("layouts", &W::layouts, some_of<Layout>(layout_names),
               "How arcs and homes lie; on a grid gains tie again and again."),
      field<W>("bundle_limit", &W::bundle_limit, yaml::number<double>(0, 1),
               "Odds that an agent may take only so many tasks."),
      field<W>("endurance", &W::endurance, yaml::number<double>(0, 1),
               "Odds that most UAVs, each its own, last only so long."),
      field<W>("payloads", &W::payloads, yaml::number<double>(0, 1),
               "Odds that UAVs carry, and arcs need, different payloads."),
      field<W>("tick_ms", &W::tick_ns, yaml::milliseconds(1, 10000),
               "Longest time that a round waits for those who do not speak."),
      field<W>("lease_ms", &W::lease_ns, range_of(yaml::milliseconds(50, 60000)),
               "Silence after which an agent counts as dead."),
  };
}

Keys<WorldSettings> settings_keys() {
  using W = WorldSettings;
  Keys<W> keys = auction_keys();
  const Keys<W> more = {
      field<W>("latency_ms", &W::latency_ns, range_of(yaml::milliseconds(0, 10000)),
               "Of every message, whatever goes wrong."),
      field<W>("until_s", &W::until_ns, yaml::seconds(0.1, 3600), "Faults are off from here on."),
      field<W>("loss", &W::loss, range_of(yaml::number<double>(0, 1)),
               "Of the faults loss and burst."),
      field<W>("price", &W::price, yaml::boolean(),
               "Run every world without its faults too, and compare."),
      field<W>("odds", &W::odds, yaml::mapping(odds_keys()), "Odds of every fault; absent: 0."),
  };
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

}  // namespace

WorldSettings parse_worlds(const std::string& text, const std::filesystem::path& file) {
  const YAML::Node root = yaml::parse_document(text, file.string(), what);
  WorldSettings settings;
  settings.name = file.stem().string();
  Report report(file.string());
  yaml::read_fields({root, root.Mark(), ""}, settings_keys(), settings, report);
  const bool choices = !settings.policies.empty() && !settings.scores.empty() &&
                       !settings.trades.empty() && !settings.topologies.empty() &&
                       !settings.layouts.empty();
  if (!choices)
    report.problem(root.Mark(), "",
                   "policies, scores, trades, topologies and layouts must not be empty");
  report.throw_if_any();
  return settings;
}

WorldSettings load_worlds(const std::filesystem::path& file) {
  return parse_worlds(yaml::read_text(file, what), file);
}

std::string worlds_reference() {
  std::string out = "| key | legal | default | meaning |\n|---|---|---|---|\n";
  for (const auto& key : settings_keys()) {
    const bool odds = key.name == "odds";
    out +=
        fmt::format("| `{}` | {} | {} | {} |\n", key.name,
                    odds ? fmt::format("a mapping of fault to odds in [0, 1]: {}",
                                       fmt::join(world_fault_names, ", "))
                         : key.legal,
                    odds ? "none" : fmt::format("`{}`", key.print(WorldSettings{})), key.meaning);
  }
  return out;
}

}  // namespace arcbid
