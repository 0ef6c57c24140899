// SPDX-License-Identifier: GPL-3.0-or-later
// view_fixture DIR: a recorded world as the page is given it (data.json), and what the core itself
// believed at some of its times (expect.json).
#include <fstream>

#include "core/auction/agent.hpp"
#include "sim/view/view_data.hpp"
#include "tests/view/recorded_world.hpp"

namespace {

using namespace arcbid;
using nlohmann::json;

void expect_of(const LifeLog& life, json& out) {
  Agent core(life.agent(), life.birth()->incarnation, life.mission(),
             std::make_shared<const StraightTransit>(), life.birth()->now_ns);
  const auto& marks = life.marks();
  life.steps([&](std::size_t mark, const Step& step, std::string_view) {
    core.step(step.event);
    const bool is_last_of_its_time =
        mark + 1 == marks.size() || marks[mark + 1].t_ns != marks[mark].t_ns;
    if (!is_last_of_its_time || mark % 7 != 0) return true;
    json winners = json::array(), bids = json::array();
    for (const Belief& belief : core.winners()) {
      winners.push_back(belief.winner ? json(belief.winner->value) : json(-1));
      bids.push_back(belief.winner ? json(belief.bid) : json(nullptr));
    }
    out.push_back({{"agent", life.agent().value},
                   {"t_s", seconds(marks[mark].t_ns)},
                   {"winners", winners},
                   {"bids", bids}});
    return true;
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path directory = argv[1];
  std::filesystem::remove_all(directory);
  testing::record_world(PolicyKind::claims, 5, directory / "run");
  const RunArchive run = open_run(directory / "run");
  json expect = json::array();
  for (const LifeLog& life : run.lives) expect_of(life, expect);
  std::ofstream(directory / "data.json") << view_data(run).dump();
  std::ofstream(directory / "expect.json") << expect.dump();
  return expect.empty() ? 1 : 0;
}
