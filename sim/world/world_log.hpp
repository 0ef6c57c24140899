// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "core/io/run/agent_log.hpp"
#include "core/route/route.hpp"
#include "sim/world/run.hpp"

namespace arcbid {

/// Leaves a world on record as live processes leave a run: a log for each life, the arcs, and how
/// it ended. Everything that reads run directories reads it too; times are the world's.
class WorldLog final : public WorldObserver {
 public:
  /// Throws InputError when `directory` can't be made or is not empty.
  WorldLog(const WorldSpec& spec, std::filesystem::path directory);
  ~WorldLog() override;

  void born(std::uint32_t life, AgentId agent, std::uint64_t incarnation, TimeNs now_ns,
            TimeNs clock_ns) override;
  void stepped(std::uint32_t life, TimeNs now_ns, const Event& event,
               const Update& update) override;
  void met_fate(std::uint32_t life, TimeNs now_ns, const Header& header, const Fate& fate) override;
  void outlived(std::uint32_t number, TimeNs now_ns) override;
  /// How it ended; the last thing.
  void write_result(const WorldResult& result);

 private:
  struct Life;
  void plan(Life& life, TimeNs now_ns) const;
  nlohmann::json acts_until(TimeNs end_ns) const;

  const WorldSpec& spec_;
  const std::shared_ptr<const Transit> transit_;
  const std::filesystem::path directory_;
  std::map<std::uint32_t, std::unique_ptr<Life>> lives_;
};

}  // namespace arcbid
