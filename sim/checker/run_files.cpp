// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/checker/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/checker/json_field.hpp"

namespace arcbid::checker {

namespace {

void require_schema(const JsonField& document) {
  if (document.at("schema").id() != 1) document.at("schema").refuse("1");
}

Point read_point(const JsonField& field) {
  const auto parts = field.elements();
  if (parts.size() != 3) field.refuse("an array of 3 numbers");
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

Path read_path(const JsonField& field) {
  Path path;
  for (const JsonField& waypoint : field.elements()) {
    const auto parts = waypoint.elements();
    if (parts.size() != 6) waypoint.refuse("an array of 6 numbers: x, y, z, look x, y, z");
    path.push_back({{parts[0].number(), parts[1].number(), parts[2].number()},
                    {parts[3].number(), parts[4].number(), parts[5].number()}});
  }
  if (path.size() < 2) field.refuse("at least two waypoints");
  return path;
}

FleetAgent read_fleet_agent(const JsonField& field) {
  FleetAgent agent{read_point(field.at("home_m")), field.at("speed_mps").number(), {}, "any"};
  if (agent.speed_mps <= 0) field.at("speed_mps").refuse("above 0");
  if (const auto endurance = field.find("endurance_s")) {
    agent.endurance_s = endurance->number_or_null();
    if (agent.endurance_s && *agent.endurance_s <= 0) endurance->refuse("above 0, or null");
  }
  if (const auto payload = field.find("payload")) agent.payload = payload->text();
  return agent;
}

PublishedArc read_arc(const JsonField& field) {
  PublishedArc arc{read_path(field.at("waypoints")), "any", 0};
  if (const auto payload = field.find("payload")) arc.payload = payload->text();
  arc.length_m = length_m(arc.waypoints);
  if (!same_length(field.at("length_m").number(), arc.length_m))
    field.at("length_m").refuse(fmt::format("{:.4f}", arc.length_m).c_str());
  return arc;
}

TaskRow read_task(const JsonField& field) {
  const auto won_by = field.find("won_by");
  return {.task = field.at("task").id(),
          .arc = field.at("arc").id(),
          .from_m = field.at("from_m").number(),
          .to_m = field.at("to_m").number(),
          .owner = field.at("owner").id_or_null(),
          .won_by = (won_by ? *won_by : field.at("owner")).id_or_null(),
          .bid = field.at("bid").number_or_null()};
}

Left read_left(const JsonField& field) {
  return {.arc = field.at("arc").id(),
          .from_m = field.at("from_m").number(),
          .to_m = field.at("to_m").number(),
          .why = field.at("why").text(),
          .needs = field.at("needs").text(),
          .agent = field.at("agent").id_or_null(),
          .needed_s = field.at("needed_s").number(),
          .endurance_s = field.at("endurance_s").number(),
          .limit = field.at("limit").id(),
          .text = field.at("text").text()};
}

Leg read_leg(const JsonField& field) {
  Leg leg;
  const std::string kind = field.at("kind").text();
  if (kind == "arc") {
    leg.arc = field.at("arc").id();
    leg.from_m = field.at("from_m").number();
    leg.to_m = field.at("to_m").number();
  } else if (kind != "transit") {
    field.at("kind").refuse("\"arc\" or \"transit\"");
  }
  leg.waypoints = read_path(field.at("waypoints"));
  return leg;
}

}  // namespace

Published read_published(const std::filesystem::path& file) {
  const nlohmann::json json = parse_file(file);
  const JsonField document(json, "");
  require_schema(document);
  Published published;
  published.mission = document.at("mission").at("id").text();
  if (const auto transits = document.find("transits"))
    published.transits_are_straight = transits->text() == "straight";
  for (const JsonField& field : document.at("fleet").elements())
    if (!published.fleet.emplace(field.at("agent").id(), read_fleet_agent(field)).second)
      field.at("agent").refuse("an id of its own");
  for (const JsonField& field : document.at("arcs").elements())
    if (!published.arcs.emplace(field.at("arc").id(), read_arc(field)).second)
      field.at("arc").refuse("an id of its own");
  return published;
}

Delivered read_delivered(const std::filesystem::path& file) {
  const nlohmann::json json = parse_file(file);
  const JsonField document(json, "");
  require_schema(document);
  Delivered delivered;
  delivered.agent = document.at("agent").id();
  if (file.filename() != fmt::format("agent_{}.json", delivered.agent))
    document.at("agent").refuse("the id in the file's name");
  delivered.mission = document.at("mission").text();
  const JsonField agreement = document.at("agreement");
  delivered.view_hash = agreement.at("view_hash").text();
  for (const JsonField& field : agreement.at("tasks").elements())
    delivered.tasks.push_back(read_task(field));
  std::ranges::stable_sort(delivered.tasks, {}, &TaskRow::task);
  if (const auto left = agreement.find("no_bidders"))
    for (const JsonField& field : left->elements()) delivered.left.push_back(read_left(field));
  const JsonField route = document.at("route");
  delivered.length_m = route.at("length_m").number();
  delivered.time_s = route.at("time_s").number();
  for (const JsonField& field : route.at("legs").elements())
    delivered.legs.push_back(read_leg(field));
  return delivered;
}

std::vector<std::filesystem::path> route_files(const std::filesystem::path& run) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  std::filesystem::directory_iterator entry(run / "routes", error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    if (entry->path().extension() != ".part") files.push_back(entry->path());
  std::ranges::sort(files);
  return files;
}

}  // namespace arcbid::checker
