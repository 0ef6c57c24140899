// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/replay/recorded_fleet.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <stdexcept>
#include <utility>

namespace arcbid::testing {
namespace {

constexpr TimeNs ms = 1'000'000;

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "replay.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

RecordedFleet::RecordedFleet(Mission mission, std::filesystem::path directory, std::uint64_t seed,
                             double loss)
    : mission_(std::make_shared<const Mission>(std::move(mission))),
      directory_(std::move(directory)),
      dice_(seed),
      loss_(loss) {
  for (const Uav& uav : mission_->fleet) revive(uav.id);
}

TimeNs RecordedFleet::shown_ns(AgentId agent) const {
  const auto clock = clocks_.find(agent);
  return now_ns_ + (clock == clocks_.end() ? 0 : clock->second);
}

void RecordedFleet::revive(AgentId id) {
  const std::uint64_t incarnation = 1000 + static_cast<std::uint64_t>(now_ns_ / ms) + id.value;
  Member& member = members_[id];
  member.agent = std::make_unique<Agent>(id, incarnation, mission_,
                                         std::make_shared<const StraightTransit>(), now_ns_);
  member.log = std::make_unique<AgentLog>(
      directory_ / "logs" / fmt::format("agent_{}.{}.sqlite", id.value, incarnation),
      AgentLog::Life{id, incarnation, 1}, [](const std::string&) {});
  member.log->birth(shown_ns(id), {id, incarnation, now_ns_}, *mission_);
  member.agreement.reset();
  member.wake_ns = now_ns_;
}

template <class Message>
void RecordedFleet::broadcast(AgentId from, const Message& message) {
  for (const auto& [to, member] : members_) {
    if (to == from || dice_.unit() < loss_) continue;
    const TimeNs at = now_ns_ + ms + static_cast<TimeNs>(dice_.unit() * 4 * ms);
    queue_.emplace(std::pair(at, order_++), Delivery{to, {at, message}});
  }
}

void RecordedFleet::step(AgentId id, Event event) {
  Member& member = members_.at(id);
  Step step{std::move(event), {}};
  step.update = member.agent->step(step.event);
  member.log->step(shown_ns(id), step);
  member.log->commit_if_due(shown_ns(id));
  ++steps_;
  if (keeps_winners_) winners_[id].push_back(member.agent->winners());
  const Update& update = step.update;
  member.wake_ns = update.wake_ns;
  if (update.agreement_lost) member.agreement.reset();
  for (const auto& bid : update.bids) broadcast(id, bid);
  for (const auto& relay : update.relays) broadcast(id, relay);
  for (const auto& status : update.statuses) broadcast(id, status);
  if (update.agreed) member.agreement = update.agreed;
}

void RecordedFleet::step_once() {
  TimeNs next = queue_.empty() ? INT64_MAX : queue_.begin()->first.first;
  std::optional<AgentId> waking;
  for (const auto& [id, member] : members_)
    if (member.wake_ns < next) {
      next = member.wake_ns;
      waking = id;
    }
  now_ns_ = std::max(now_ns_, next);
  if (waking)
    return step(*waking, {now_ns_, Tick{static_cast<std::uint32_t>(mission_->fleet.size() - 1)}});
  const Delivery delivery = queue_.begin()->second;
  queue_.erase(queue_.begin());
  if (members_.contains(delivery.to)) step(delivery.to, delivery.event);
}

bool RecordedFleet::agreed() const {
  std::optional<std::uint64_t> hash;
  for (const auto& [id, member] : members_) {
    if (!member.agreement || member.agreement->members.size() != members_.size()) return false;
    if (hash && *hash != member.agreement->view_hash) return false;
    hash = member.agreement->view_hash;
  }
  return hash.has_value();
}

bool RecordedFleet::run(TimeNs limit_ns) {
  const TimeNs end_ns = now_ns_ + limit_ns;
  while (now_ns_ < end_ns && !agreed()) step_once();
  return agreed();
}

void RecordedFleet::run_for(TimeNs span_ns) {
  const TimeNs end_ns = now_ns_ + span_ns;
  while (now_ns_ < end_ns) step_once();
}

void RecordedFleet::end() {
  for (const auto& [id, member] : members_)
    member.log->write(shown_ns(id), log_kind::end, {{"by", "coordinator"}});
  members_.clear();
}

}  // namespace arcbid::testing
