// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/export/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/route/route.hpp"
#include "core/route/share.hpp"

namespace arcbid::testing {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> parts{"", "-wal", "-shm"};  // of a log's files

fs::path part(const fs::path& file, const std::string& suffix) {
  return file.string() + suffix;
}

}  // namespace

RecordedRun::RecordedRun(fs::path directory, Mission mission)
    : directory_(std::move(directory)),
      mission_(std::make_shared<const Mission>(std::move(mission))) {
  for (const Uav& uav : mission_->fleet) revive(uav.id);
}

RecordedRun::~RecordedRun() = default;

void RecordedRun::revive(AgentId id) {
  Member& member = members_[id];
  const std::uint64_t incarnation = 1000 * ++member.lives + id.value;
  member.file = directory_ / "logs" / fmt::format("agent_{}.{}.sqlite", id.value, incarnation);
  member.log = std::make_unique<AgentLog>(member.file, AgentLog::Life{id, incarnation, 0},
                                          [](const std::string&) {});
  member.agent = std::make_unique<Agent>(id, incarnation, mission_,
                                         std::make_shared<StraightTransit>(), now_ns_);
  member.log->birth(now_ns_, {id, incarnation, now_ns_}, *mission_);
  member.wake_ns = now_ns_;
}

void RecordedRun::kill(AgentId id) {
  Member& member = members_.at(id);
  for (const std::string& suffix : parts)
    fs::copy_file(part(member.file, suffix), part(member.file, suffix + ".killed"));
  member.agent.reset();
  member.log.reset();
  for (const std::string& suffix : parts)
    fs::rename(part(member.file, suffix + ".killed"), part(member.file, suffix));
}

void RecordedRun::end() {
  for (auto& [id, member] : members_) {
    if (member.log) member.log->write(now_ns_, log_kind::end, {{"by", "coordinator"}});
    member.agent.reset();
    member.log.reset();
  }
}

void RecordedRun::step(AgentId id, Event event) {
  Member& member = members_.at(id);
  Step step{std::move(event), {}};
  step.update = member.agent->step(step.event);
  member.log->step(now_ns_, step);
  watch(id, step);
  member.wake_ns = step.update.wake_ns;
  const auto send = [&](const auto& messages) {
    for (const auto& message : messages) under_way_.push_back({now_ns_ + 2'000'000, id, message});
  };
  send(step.update.bids), send(step.update.relays), send(step.update.statuses);
  if (!step.update.agreed) return;
  const auto uav = std::find_if(mission_->fleet.begin(), mission_->fleet.end(),
                                [id](const Uav& u) { return u.id == id; });
  const auto& agreed = *step.update.agreed;
  const StraightTransit transit;
  const TaskSet& tasks = member.agent->tasks();
  const Share share = share_of(*mission_, tasks, agreed, id, transit);
  member.log->route(now_ns_,
                    {agreed.view_hash, plan_route(*mission_, tasks, share.path, *uav, transit)});
  member.log->commit();
  this->step(id, {now_ns_, RoutePublished{agreed.view_hash}});
}

void RecordedRun::deliver(const Delivery& delivery) {
  for (auto& [id, member] : members_)
    if (id != delivery.from && member.agent) step(id, {now_ns_, delivery.what});
}

void RecordedRun::run_for(TimeNs span_ns) {
  const TimeNs end_ns = now_ns_ + span_ns;
  for (; now_ns_ < end_ns; now_ns_ += 1'000'000) {
    while (!under_way_.empty() && under_way_.front().at_ns <= now_ns_) {
      const Delivery delivery = std::move(under_way_.front());
      under_way_.pop_front();
      deliver(delivery);
    }
    for (auto& [id, member] : members_) {
      if (!member.agent) continue;
      if (member.wake_ns <= now_ns_)
        step(id, {now_ns_, Tick{static_cast<std::uint32_t>(members_.size() - 1)}});
      member.log->commit_if_due(now_ns_);
    }
  }
}

}  // namespace arcbid::testing
