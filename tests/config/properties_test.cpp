// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <sstream>

#include "core/base/error.hpp"
#include "core/io/config.hpp"

namespace arcbid {
namespace {

/// A number in [low, high] with as many digits as a double has.
double number(double low, double high) {
  const auto share = static_cast<double>(*rc::gen::inRange<std::uint64_t>(0, 1ULL << 53));
  return std::min(high, low + (high - low) * share / static_cast<double>(1ULL << 53));
}

TimeNs time_ns(TimeNs low_ms, TimeNs high_ms) {
  return *rc::gen::inRange(low_ms * 1'000'000, high_ms * 1'000'000 + 1);
}

std::string title() {
  static const std::string characters = "ab Z9_-.:#'\"{}[]&*!|>%@`,?\xc3\xbc";
  std::string text = "n";
  for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
    const char c = characters[*rc::gen::inRange<std::size_t>(0, characters.size() - 2)];
    text += c;
  }
  return *rc::gen::arbitrary<bool>() ? text : text + "\xc3\xbc";
}

std::optional<double> endurance_s() {
  return *rc::gen::arbitrary<bool>() ? std::optional(number(1, 1e6)) : std::nullopt;
}

Payload payload() {
  return *rc::gen::element(Payload::any, Payload::lidar, Payload::camera);
}

std::vector<Uav> uavs() {
  std::vector<Uav> fleet;
  std::uint32_t id = 0;
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i)
    fleet.push_back({AgentId{id += *rc::gen::inRange(1u, 900u)},
                     Vec3(number(-1e6, 1e6), number(-1, 1), number(0, 100)), number(0.1, 30),
                     endurance_s(), payload()});
  return fleet;
}

/// Any legal config, every field of it at random.
Config legal_config() {
  Config c;
  c.name = title();
  c.structure.unit = *rc::gen::element<std::string>("m", "cm", "mm", "ft", "us-ft", "in");
  c.structure.up = *rc::gen::element('x', 'y', 'z');
  if (*rc::gen::arbitrary<bool>())
    c.structure.file = std::filesystem::path(ARCBID_SOURCE_DIR) / "configs/demo.yaml";
  ParametricBridge& p = c.structure.parametric;
  p.kind = *rc::gen::element(BridgeKind::girder, BridgeKind::arch, BridgeKind::towers);
  p.length_m = number(100, 5000);
  p.width_m = number(1, 200);
  p.deck_height_m = number(41, 500);
  p.deck_thickness_m = number(0.1, 20);
  p.piers = *rc::gen::inRange(1u, 50u);
  p.pier_width_m = number(0.1, 2);
  p.girders = *rc::gen::inRange(0u, 51u);
  p.girder_depth_m = number(0.1, 20);
  p.tower_height_m = number(500, 1000);
  c.coverage.spacing_m = number(0.2, 100);
  c.coverage.standoff_m = number(50, 100);
  c.coverage.safety_m = number(0.1, 45);
  c.coverage.sensor.range_m = number(101, 200);
  c.coverage.sensor.lowest_look_deg = number(-90, 0);
  c.coverage.ground_clearance_m = number(0, 100);
  if (*rc::gen::arbitrary<bool>()) c.coverage.ground_m = number(-1e5, 1e5);
  c.coverage.rows = *rc::gen::element(RowSide::short_side, RowSide::long_side);
  c.coverage.seed = *rc::gen::arbitrary<std::uint32_t>();
  c.fleet = {*rc::gen::inRange(1u, 65u),
             *rc::gen::inRange(1u, 65u),
             number(0.1, 30),
             endurance_s(),
             payload(),
             uavs()};
  if (!c.fleet.uavs.empty()) c.fleet.agents = static_cast<std::uint32_t>(c.fleet.uavs.size());
  c.auction.policy =
      *rc::gen::element(PolicyKind::claims, PolicyKind::claims_keep, PolicyKind::cbba,
                        PolicyKind::cbba_rebuild, PolicyKind::acbba);
  c.auction.score = *rc::gen::element(ScoreKind::minimax, ScoreKind::minisum,
                                      ScoreKind::discounted_insert_warped);
  c.auction.discount_per_s = number(1e-6, 10);
  if (*rc::gen::arbitrary<bool>()) c.auction.split_m = number(0.1, 10000);
  c.auction.max_tasks = *rc::gen::inRange(1u, 100001u);
  c.auction.bundle_limit = *rc::gen::inRange(0u, 100001u);
  c.auction.trades = *rc::gen::element(TradesKind::off, TradesKind::cheap, TradesKind::full);
  c.auction.audit_bids = *rc::gen::arbitrary<bool>();
  c.auction.tick_ns = time_ns(1, 10000);
  c.auction.lease_ns = time_ns(30000, 600000);
  c.auction.barrier_ns = time_ns(0, 600000);
  c.tour = {*rc::gen::element(TourSolver::crsom, TourSolver::crsom_ls),
            *rc::gen::arbitrary<std::uint32_t>(), *rc::gen::inRange(1u, 100001u),
            *rc::gen::inRange(0u, 1000001u)};
  c.network.transport = *rc::gen::element(TransportKind::loopback, TransportKind::discovery_server);
  if (*rc::gen::arbitrary<bool>()) c.network.domain = *rc::gen::inRange(0u, 233u);
  c.network.server_port = *rc::gen::inRange<std::uint16_t>(1, 65535);
  c.network.reliable_bids = *rc::gen::arbitrary<bool>();
  c.timeout_s = number(1, 86400);
  return c;
}

TEST(ConfigProperty, PrintedConfigsReadBackTheSame) {
  EXPECT_TRUE(rc::check("parse(to_yaml(c)) == c", [] {
    const Config c = legal_config();
    validate(c);
    const Config back = parse_config(to_yaml(c), "printed.yaml");
    RC_ASSERT(to_yaml(back) == to_yaml(c));
    RC_ASSERT(back.name == c.name);
    RC_ASSERT(back.coverage.spacing_m == c.coverage.spacing_m);
    RC_ASSERT(back.auction.tick_ns == c.auction.tick_ns);
    RC_ASSERT(back.auction.split_m == c.auction.split_m);
    RC_ASSERT(back.auction.trades == c.auction.trades);
    RC_ASSERT(back.fleet.uavs.size() == c.fleet.uavs.size());
  }));
}

/// Cuts, repeats, and overwrites pieces of `text`.
std::string mutated(std::string text) {
  static const std::vector<std::string> pieces = {
      "\n",   "  ",    "\t",           ":",       ": ",   "- ", "[",   "]", "{",    "}",   "\"",
      "'",    "#",     "&a ",          "*a",      "!!",   "? ", "|\n", ">", "---",  "~",   ".nan",
      "1e99", "-1",    "\xff",         "%",       "<<: ", "\r", ",",   "@", "null", "yes", "...",
      "0x",   "\\x00", "\xef\xbb\xbf", "\xc2\x85"};
  for (int n = *rc::gen::inRange(1, 8); n > 0; --n) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    const auto length = *rc::gen::inRange<std::size_t>(0, 40);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text.insert(at, *rc::gen::elementOf(pieces));
        break;
      default:
        text.replace(at, 1, 1, static_cast<char>(*rc::gen::inRange(0, 256)));
    }
  }
  return text;
}

TEST(ConfigProperty, DamagedFilesAreReadOrRefused) {
  std::ifstream in(std::filesystem::path(ARCBID_SOURCE_DIR) / "configs/discovery_server.yaml");
  std::ostringstream text;
  text << in.rdbuf();
  int accepted = 0, refused = 0;
  EXPECT_TRUE(rc::check("config or InputError", [&] {
    for (int i = 0; i < 20; ++i) try {
        const Config c = parse_config(mutated(text.str()), "damaged.yaml");
        validate(c);
        RC_ASSERT(to_yaml(parse_config(to_yaml(c), "damaged.yaml")) == to_yaml(c));
        ++accepted;
      } catch (const InputError& e) {
        RC_ASSERT(std::string(e.what()).starts_with("damaged.yaml"));
        ++refused;
      }
  }));
  EXPECT_GT(accepted, 10);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace arcbid
