// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "sim/replay/playback.hpp"

namespace arcbid {

/// One step of a run, whole.
struct RunStep {
  std::size_t number = 0;  ///< of the moment, in causal order
  TimeNs t_ns = 0;         ///< of the moment: never earlier than its cause
  const LifeLog& life;
  const Mark& mark;
  const Step& step;
  std::string_view bytes;  ///< as they are on record
};

/// All steps of a run in causal order, each log read once from front to back.
void for_each_step(const RunArchive& run, const std::vector<Moment>& moments,
                   const std::function<void(const RunStep&)>& take);

/// Who owns what, from a moment on.
struct Ownership {
  std::size_t moments = 0;  ///< how many had passed
  TimeNs t_ns = 0;
  std::vector<Belief> owners;  ///< an entry for each task
};

/// Playback::owners whenever they change, from nobody on.
std::vector<Ownership> ownerships(const RunArchive& run, const Playback& playback);

}  // namespace arcbid
