// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/export/mcap_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <variant>

#include "core/base/error.hpp"
#include "core/io/build/build.hpp"
#include "core/io/run/agent_log.hpp"
#include "core/io/structure_reader.hpp"
#include "sim/export/scene.hpp"
#include "sim/export/statements.hpp"
#include "sim/mcap/ros_topics.hpp"

namespace arcbid {
namespace {

using ros::Durability;

constexpr TimeNs pose_interval_ns = 500'000'000;

/// MCAP counts from 0 on.
std::uint64_t stamp(TimeNs t_ns) {
  return static_cast<std::uint64_t>(std::max<TimeNs>(t_ns, 0));
}

class Exporter {
 public:
  Exporter(const RunArchive& run, const Structure* structure, const std::filesystem::path& file)
      : run_(run),
        structure_(structure),
        playback_(run),
        scene_(*run.mission, run.tasks),
        writer_(file, {.library = fmt::format("arcbid {}", build_version())}),
        topics_(writer_),
        homes_(topics_.topic<ros::MarkerArray>("/homes", Durability::transient_local)),
        arcs_(topics_.topic<ros::MarkerArray>("/arcs", Durability::transient_local)),
        events_(topics_.topic<ros::String>("/events", Durability::volatile_topic)) {
    for (const Uav& uav : run.mission->fleet) add_topics(uav.id);
    for (const LifeLog& life : run.lives)
      for (PlannedRoute& planned : life.routes())
        routes_[{life.agent(), planned.view_hash}] = std::move(planned.route);
    prepare_flights();
  }

  void write() {
    attach();
    const auto& moments = playback_.moments();
    const TimeNs begin_ns = moments.empty() ? 0 : moments.front().t_ns;
    topics_.write(homes_, stamp(begin_ns), scene_.homes(begin_ns));
    if (structure_) write_structure(begin_ns);
    const std::vector<Belief> nobody(run_.tasks.tasks.size());
    topics_.write(arcs_, stamp(begin_ns), scene_.arcs(begin_ns, nobody));
    const std::vector<Ownership> owners = ownerships(run_, playback_);
    auto next = owners.begin();
    const auto write_owners = [&](std::size_t moments_passed) {
      for (; next != owners.end() && next->moments <= moments_passed; ++next)
        topics_.write(arcs_, stamp(next->t_ns), scene_.arcs(next->t_ns, next->owners));
    };
    for_each_step(run_, moments, [&](const RunStep& at) {
      fly_until(at.t_ns);
      take(at);
      write_owners(at.number + 1);
    });
    fly_until(std::numeric_limits<TimeNs>::max());
    writer_.close();
  }

 private:
  struct AgentTopics {
    mcap::ChannelId step, bid, relay, status;
    ros::Topic<ros::Path> route;
    ros::Topic<ros::PoseStamped> pose;
    ros::Topic<ros::Float64> tasks_held;
  };

  void add_topics(AgentId agent) {
    const std::string name = fmt::format("/agent_{}", agent.value);
    of_.emplace(
        agent,
        AgentTopics{ours<Step>(name + "/step"), ours<BidMessage>(name + "/sent/bid"),
                    ours<RelayMessage>(name + "/sent/relay"),
                    ours<StatusMessage>(name + "/sent/status"),
                    topics_.topic<ros::Path>(name + "/route", Durability::transient_local),
                    topics_.topic<ros::PoseStamped>(name + "/pose", Durability::volatile_topic),
                    topics_.topic<ros::Float64>(name + "/tasks_held", Durability::volatile_topic)});
  }
  template <class Record>
  mcap::ChannelId ours(const std::string& topic) {
    return topics_.topic_of(fmt::format("arcbid_msgs/msg/{}", name_of_record<Record>()),
                            schema_of<Record>(), topic, Durability::volatile_topic);
  }

  void attach() {
    const auto attach = [this](const char* name, const char* type) {
      std::ifstream in(run_.directory / name, std::ios::binary);
      if (!in) return;
      writer_.attachment(name, type, std::string(std::istreambuf_iterator<char>(in), {}));
    };
    attach("result.json", "application/json");
    attach("config.yaml", "application/yaml");
    attach("faults.yaml", "application/yaml");
  }

  void write_structure(TimeNs t_ns) {
    auto cloud = topics_.topic<ros::PointCloud2>("/structure", Durability::transient_local);
    topics_.write(cloud, stamp(t_ns), Scene::cloud(t_ns, *structure_));
    if (!structure_->is_mesh()) return;
    auto mesh = topics_.topic<ros::MarkerArray>("/structure_mesh", Durability::transient_local);
    topics_.write(mesh, stamp(t_ns), Scene::mesh(t_ns, *structure_));
  }

  void take(const RunStep& at) {
    AgentTopics& topics = of_.at(at.life.agent());
    const std::uint64_t log_ns = stamp(at.t_ns), own_ns = stamp(at.mark.t_ns);
    const Update& update = at.step.update;
    // All lives share a topic, and a topic has one schema.
    const bool is_own = !at.life.schemas().of(log_kind::step);
    writer_.write(topics.step, static_cast<std::uint32_t>(at.mark.seq), log_ns, own_ns,
                  is_own ? at.bytes : std::string_view(encode(at.step)));
    const auto sent = [&](mcap::ChannelId channel, const auto& messages) {
      for (const auto& message : messages)
        writer_.write(channel, static_cast<std::uint32_t>(message.header.sequence), log_ns, own_ns,
                      encode(message));
    };
    sent(topics.bid, update.bids);
    sent(topics.relay, update.relays);
    sent(topics.status, update.statuses);
    if (update.decision)
      topics_.write(topics.tasks_held, log_ns,
                    ros::Float64{static_cast<double>(update.decision->path.size())});
    for (const auto& [what, detail] : happenings(update))
      topics_.write(events_, log_ns,
                    ros::String{fmt::format("agent {}: {}{}{}", at.life.agent().value, what,
                                            detail.empty() ? "" : " ", detail)});
    if (const auto* published = std::get_if<RoutePublished>(&at.step.event.what))
      write_route(at, published->view_hash);
  }

  void write_route(const RunStep& at, std::uint64_t view_hash) {
    const auto route = routes_.find({at.life.agent(), view_hash});
    if (route == routes_.end()) return;
    topics_.write(of_.at(at.life.agent()).route, stamp(at.t_ns),
                  Scene::path(at.t_ns, route->second));
  }

  /// All who have a route of the last agreement take off when it was proven, and fly on paper.
  void prepare_flights() {
    const auto& moments = playback_.moments();
    const auto last = std::find_if(moments.rbegin(), moments.rend(), [this](const Moment& m) {
      return run_.lives[m.life].marks()[m.mark].agreed;
    });
    if (last == moments.rend()) return;
    pose_ns_ = take_off_ns_ = last->t_ns;
    const std::uint64_t view = run_.lives[last->life].step(last->mark).update.agreed->view_hash;
    for (const auto& [of, route] : routes_)
      if (of.second == view && !route.legs.empty()) flights_.emplace(of.first, Flight(route));
  }

  void fly_until(TimeNs t_ns) {
    for (; !flights_.empty() && pose_ns_ < t_ns; pose_ns_ += pose_interval_ns) {
      const double at_s = static_cast<double>(pose_ns_ - take_off_ns_) / 1e9;
      for (const auto& [agent, flight] : flights_)
        topics_.write(of_.at(agent).pose, stamp(pose_ns_),
                      ros::PoseStamped{{stamp(pose_ns_), "map"}, flight.pose(at_s)});
      // Whoever is home by now has said so.
      std::erase_if(flights_, [at_s](const auto& f) { return f.second.time_s() <= at_s; });
    }
  }

  const RunArchive& run_;
  const Structure* const structure_;  // may be missing
  const Playback playback_;
  const Scene scene_;
  mcap::McapWriter writer_;
  ros::RosTopics topics_;
  ros::Topic<ros::MarkerArray> homes_, arcs_;
  ros::Topic<ros::String> events_;
  std::map<AgentId, AgentTopics> of_;
  std::map<std::pair<AgentId, std::uint64_t>, Route> routes_;  // by agreement
  std::map<AgentId, Flight> flights_;                          // of those that are not yet home
  TimeNs take_off_ns_ = 0, pose_ns_ = 0;                       // and of the next poses
};

/// As the coordinator left it for whoever looks, or why there is none.
std::variant<Structure, std::string> structure_of(const RunArchive& run) {
  const auto file = run.directory / "structure.ply";
  if (!std::filesystem::exists(file)) return fmt::format("{}: is not there", file.string());
  try {
    return read_structure(file, {}).structure;
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

std::vector<std::string> export_mcap(const RunArchive& run, const std::filesystem::path& file) {
  const auto structure = structure_of(run);
  Exporter(run, std::get_if<Structure>(&structure), file).write();
  const auto* missing = std::get_if<std::string>(&structure);
  return missing ? std::vector{*missing} : std::vector<std::string>{};
}

}  // namespace arcbid
