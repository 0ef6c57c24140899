// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/dissemination.hpp"

#include <algorithm>
#include <utility>

#include "core/base/digest.hpp"

namespace arcbid {

Dissemination::Dissemination(std::size_t members, std::size_t self, Timing timing)
    : self_(self),
      timing_(timing),
      stamps_(members),
      known_(members),
      learnt_ns_(members),
      is_awaited_(members),
      said_ns_(members) {}

/// Who says something new at every tick must be passed on too: where the statement before this one
/// still waits for that, patience does not begin anew.
void Dissemination::learnt(std::size_t member, TimeNs now) {
  if (said_ns_[member] || !is_awaited_[member]) learnt_ns_[member] = now;
  said_ns_[member].reset();
}

void Dissemination::forget(std::size_t member) {
  known_[member].clear();
}

void Dissemination::holds(std::size_t member, const Heartbeat& stamp, bool whole,
                          const std::vector<Holding>& holdings) {
  if (stamp <= stamps_[member]) return;
  const bool new_life = stamp.incarnation != stamps_[member].incarnation;
  stamps_[member] = stamp;
  if (whole || new_life) known_[member].assign(known_.size(), {});
  for (const Holding& holding : holdings) known_[member][holding.author] = holding.key;
}

bool Dissemination::lacks(std::size_t reader, std::size_t author, const View& view) const {
  if (reader == self_ || known_[reader].empty()) return false;
  return known_[reader][author] < view.key(author);
}

bool Dissemination::wanted(std::size_t author, const View& view) const {
  if (!view.heard(author)) return false;
  for (std::size_t k = 0; k < known_.size(); ++k)
    if (k != author && lacks(k, author, view)) return true;
  // A tombstone must reach even the agent it buries: it may be alive after all, and must say so.
  return author != self_ && view.dead(author) && !known_[author].empty() &&
         known_[author][author] < view.key(author) && !said_ns_[author];
}

/// From the last try, or else from when the first statement since then was learnt.
TimeNs Dissemination::wait_ns(std::size_t author, const View& view) const {
  const bool first = !said_ns_[author];
  if (author == self_) return first ? 0 : timing_.resend_ns;
  if (view.dead(author) && first) return 0;  // nobody but relays speaks for the dead
  const auto patience = static_cast<std::uint64_t>(std::max<TimeNs>(timing_.patience_ns, 1));
  const std::uint64_t spread =
      Digest().add(std::uint64_t{self_}).add(std::uint64_t{author}).value() % patience;
  return timing_.patience_ns + static_cast<TimeNs>(spread);
}

std::vector<std::size_t> Dissemination::due(const View& view, TimeNs now) {
  std::vector<std::size_t> send;
  for (std::size_t author = 0; author < known_.size(); ++author) {
    const bool news = author == self_ && !said_ns_[author] && view.heard(author);
    is_awaited_[author] = wanted(author, view);
    if (!news && !is_awaited_[author]) continue;
    if (now - said_ns_[author].value_or(learnt_ns_[author]) < wait_ns(author, view)) continue;
    said_ns_[author] = now;
    send.push_back(author);
  }
  return send;
}

bool Dissemination::is_up_to_date(std::size_t member, const View& view) const {
  if (known_[member].empty()) return false;
  for (std::size_t author = 0; author < known_.size(); ++author)
    if (lacks(member, author, view)) return false;
  return true;
}

bool Dissemination::anyone_lacks(const View& view) const {
  for (std::size_t author = 0; author < known_.size(); ++author)
    if (wanted(author, view)) return true;
  return false;
}

}  // namespace arcbid
