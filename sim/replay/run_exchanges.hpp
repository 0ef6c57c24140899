// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "sim/replay/playback.hpp"

namespace arcbid {

/// Who flies what after the exchanges that followed agreements of a run. They are not on record:
/// they follow from what was agreed on, and are worked out again, once for each agreement.
class RunExchanges {
 public:
  /// `run` must outlive this.
  explicit RunExchanges(const RunArchive& run);

  /// By task; null: nothing was exchanged.
  const std::vector<AgentId>* owners(const Agreement& agreement);

 private:
  std::vector<AgentId> worked_out(const Agreement& agreement) const;

  const RunArchive& run_;
  std::shared_ptr<const Transit> transit_;
  std::map<std::uint64_t, std::vector<AgentId>> owners_;  // by view hash; empty: none
};

/// The newest agreement on record.
std::optional<Agreement> last_agreement(const RunArchive& run, const Playback& playback);

}  // namespace arcbid
