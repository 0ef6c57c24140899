// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace arcbid {

/// The proof of agreement. An agent is ready for a view V when it holds exactly V, its decision on
/// V is finished, and its own entry in V is the result. S is the set of members known to have been
/// ready for the V of hash H; any change of V empties it. Once S covers all living members the
/// allocation is final until something outside the auction changes: readiness is a fact about the
/// past, so no loss, delay or reordering can falsify it. Members are roster positions.
class Readiness {
 public:
  Readiness(std::size_t members, std::size_t self) : self_(self), set_(members), last_(members) {}

  void view_changed() {
    ready_ = false;
    set_.assign(set_.size(), false);
  }

  /// The decision on the view of `hash` is finished. Counts what was heard about that hash earlier.
  void decided(std::uint64_t hash) {
    ready_ = true;
    hash_ = hash;
    set_[self_] = true;
    for (const Heard& heard : last_)
      if (heard.hash == hash) add(heard.set);
  }

  /// `member` says: `set` have been ready for `hash`. Returns whether S grew.
  bool heard(std::size_t member, std::uint64_t hash, std::vector<bool> set) {
    const bool grew = ready_ && hash == hash_ && add(set);
    last_[member] = {hash, std::move(set)};
    return grew;
  }

  bool ready() const { return ready_; }
  const std::vector<bool>& set() const { return set_; }

 private:
  struct Heard {
    std::uint64_t hash = 0;
    std::vector<bool> set;
  };
  bool add(const std::vector<bool>& set) {
    bool grew = false;
    for (std::size_t k = 0; k < set.size(); ++k) {
      grew = grew || (set[k] && !set_[k]);
      set_[k] = set_[k] || set[k];
    }
    return grew;
  }

  std::size_t self_;
  bool ready_ = false;
  std::uint64_t hash_ = 0;
  std::vector<bool> set_;
  std::vector<Heard> last_;
};

}  // namespace arcbid
