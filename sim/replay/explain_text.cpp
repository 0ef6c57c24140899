// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/replay/explain_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace arcbid {
namespace {

constexpr double plain_margin = 5e-4;  // what three digits behind the point can still show

/// Two bids so that their difference is seen.
std::string figure(double bid, double beside) {
  const bool close = bid != beside && std::abs(bid - beside) < plain_margin;
  return close ? fmt::format("{}", bid) : fmt::format("{:.3f}", bid);
}
std::string margin(double a, double b) {
  const double by = std::abs(a - b);
  return by != 0 && by < plain_margin ? fmt::format("{:.3g}", by) : fmt::format("{:.3f}", by);
}
std::string learnt_by(const std::optional<Source>& source) {
  return source ? fmt::format("; learnt by {}", describe(*source)) : "";
}

std::string bid(const Explanation& told, const Reason& reason) {
  std::string out = fmt::format("round {}: bids {:.3f}", told.round, told.bid);
  if (reason.bid_before && *reason.bid_before != told.bid)
    out = fmt::format("round {}: bids {} instead of {}", told.round,
                      figure(told.bid, *reason.bid_before), figure(*reason.bid_before, told.bid));
  out += fmt::format(", place {} of its bundle", told.place);
  if (!told.rival.winner) return out + "; it knows of no other bid";
  return out + fmt::format("; the best other bid that it knows of is agent {}'s {}: {} less",
                           told.rival.winner->value, figure(told.rival.bid, told.bid),
                           margin(told.bid, told.rival.bid));
}

std::string outbid(const Explanation& told, const Reason& reason) {
  const std::string head =
      fmt::format("round {}: drops it (place {} of its bundle)", told.round, told.place);
  if (!told.rival.winner) return fmt::format("{}: {}{}", head, reason.rule, learnt_by(told.source));
  return fmt::format("{}: agent {} bids {}, it {}, margin {}: {}{}", head, told.rival.winner->value,
                     figure(told.rival.bid, told.bid), figure(told.bid, told.rival.bid),
                     margin(told.rival.bid, told.bid), reason.rule, learnt_by(told.source));
}

std::string released(const Explanation& told, const Reason& reason) {
  const std::string head = fmt::format("round {}: releases it (place {} of its bundle, bid {:.3f})",
                                       told.round, told.place, told.bid);
  const std::string other = fmt::format("task {}, place {}", reason.other.value, reason.place);
  const std::string by = reason.by ? fmt::format("agent {}", reason.by->value) : "nobody";
  switch (reason.cause) {
    case Reason::Cause::earlier_lost:
      return fmt::format("{}: an earlier entry, {}, was lost to {} ({}){}", head, other, by,
                         reason.rule, learnt_by(told.source));
    case Reason::Cause::came_free:
      return fmt::format("{}: {} could be taken now, which was {}'s{}", head, other, by,
                         learnt_by(told.source));
    case Reason::Cause::death:
      return fmt::format("{}: {} became free when {} died{}", head, other, by,
                         learnt_by(told.source));
    case Reason::Cause::none:
      break;
  }
  return head + ": the bundle was built anew";
}

std::string death(const Explanation& told) {
  if (!told.source)
    return fmt::format("declares agent {} dead, silent for its lease: the task is free again",
                       told.rival.winner->value);
  return fmt::format("hears that agent {} is dead: the task is free again{}",
                     told.rival.winner->value, learnt_by(told.source));
}

std::string owner(const Explanation& told) {
  const std::string out = fmt::format("has it at the end, for {:.3f}", told.bid);
  if (!told.rival.winner) return out + "; nobody dropped it for another's bid";
  return out + fmt::format("; agent {} was the last to drop it, with a bid of {}: margin {}",
                           told.rival.winner->value, figure(told.rival.bid, told.bid),
                           margin(told.bid, told.rival.bid));
}

std::string exchanged(const Explanation& told) {
  return fmt::format(
      "flies it: agent {} won it, and it changed hands in the exchanges after the auction, which "
      "shorten the longest flight",
      told.rival.winner->value);
}

}  // namespace

std::string_view name_of(Explanation::Kind kind) {
  constexpr std::array<std::string_view, 6> names{"bid",   "outbid", "released",
                                                  "death", "owner",  "exchanged"};
  return names[static_cast<std::size_t>(kind)];
}

std::string describe(const Source& source) {
  return fmt::format("{} {}/{}/{}", source.is_relay ? "relay" : "bid", source.id.sender.value,
                     source.id.incarnation, source.id.sequence);
}

std::string text_of(const Explanation& told, const Reason& reason) {
  switch (told.kind) {
    case Explanation::Kind::bid:
      return bid(told, reason);
    case Explanation::Kind::outbid:
      return outbid(told, reason);
    case Explanation::Kind::released:
      return released(told, reason);
    case Explanation::Kind::death:
      return death(told);
    case Explanation::Kind::exchanged:
      return exchanged(told);
    case Explanation::Kind::owner:
      break;
  }
  return owner(told);
}

}  // namespace arcbid
