// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "sim/checker/json_field.hpp"
#include "sim/view/base64.hpp"
#include "sim/view/sample_file.hpp"
#include "sim/view/view_data.hpp"

namespace arcbid {
namespace {

using checker::DamagedFile;
using checker::JsonField;
using nlohmann::json;

/// As many as the structure's own points at most.
constexpr std::uint64_t most_samples = 200'000;

double amount(const JsonField& field) {
  const double value = field.number();
  if (value < 0) field.refuse("0 or more");
  return value;
}

json nearest_of(const JsonField& nearest) {
  if (nearest.is_null()) return nullptr;
  json at_m = json::array();
  for (const JsonField& axis : nearest.at("at_m").elements()) at_m.push_back(axis.number());
  if (at_m.size() != 3) nearest.at("at_m").refuse("three numbers");
  return {{"distance_m", nearest.at("distance_m").number()},
          {"leg", nearest.at("leg").id()},
          {"at_m", std::move(at_m)}};
}

json clearance_of(const JsonField& agents) {
  json out = json::array();
  for (const JsonField& agent : agents.elements())
    out.push_back(
        {{"agent", agent.at("agent").id()}, {"nearest", nearest_of(agent.at("nearest"))}});
  return out;
}

json figures_of(const std::filesystem::path& file) {
  const json raw = checker::parse_file(file);
  const JsonField certificate(raw, "");
  if (const JsonField schema = certificate.at("schema"); schema.id() != 1) schema.refuse("1");
  json out;
  for (const char* count :
       {"surface_samples", "visible_samples", "covered_samples", "covered_visible_samples"})
    out[count] = certificate.at(count).id();
  for (const char* measure : {"coverage_of_visible", "coverage_of_total", "spacing_m", "flown_m",
                              "metres_per_m2", "safety_m", "tolerance_m", "below_floor_m"})
    out[measure] = amount(certificate.at(measure));
  const auto least_m = certificate.at("min_clearance_m").number_or_null();
  out["min_clearance_m"] = least_m ? json(*least_m) : json(nullptr);
  out["uncovered"] = json::array();
  for (const JsonField& one : certificate.at("uncovered").elements())
    out["uncovered"].push_back(
        {{"reason", one.at("reason").text()}, {"count", one.at("count").id()}});
  out["clearance"] = clearance_of(certificate.at("clearance"));
  return out;
}

template <class T>
json packed(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

json samples_of(const std::filesystem::path& file, const json& figures) {
  const ShownSamples samples = read_samples(file, most_samples);
  if (samples.total != figures["surface_samples"])
    throw DamagedFile(fmt::format("{} samples, must be {} as in certificate.json", samples.total,
                                  figures["surface_samples"].get<std::uint64_t>()));
  return {{"total", samples.total},
          {"classes", samples.fates},
          {"stretches", samples.bins},
          {"positions", packed(samples.positions_m)},
          {"normals", packed(samples.normals)},
          {"class", packed(samples.fate)},
          {"seen_by", packed(samples.seen_by)}};
}

/// What a parser says of a damaged file may hold its bytes, which must not get into JSON.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

}  // namespace

json coverage_data(const std::filesystem::path& run) {
  const auto certificate = run / "certificate.json", samples = run / "certificate_samples.bin";
  if (!std::filesystem::exists(certificate) && !std::filesystem::exists(samples)) return nullptr;
  json out = json::object();
  const char* file = "certificate.json";
  try {
    out = figures_of(certificate);
    file = "certificate_samples.bin";
    out["samples"] = samples_of(samples, out);
  } catch (const DamagedFile& damaged) {
    out["problem"] = one_line(fmt::format("{}: {}", file, damaged.what()));
  }
  return out;
}

}  // namespace arcbid
