// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/airspace/search.hpp"

#include <algorithm>
#include <limits>

#include "core/airspace/pull.hpp"

namespace arcbid {

bool Search::Open::operator<(const Open& other) const {
  return length_m != other.length_m ? length_m > other.length_m : node > other.node;
}

Search::Search(const FreeGrid& grid, const Roadmap& roadmap)
    : grid_(grid), roadmap_(roadmap), pulled_(roadmap.size()) {}

void Search::expect(std::vector<std::uint32_t> last_linked) {
  last_linked_ = std::move(last_linked);
}

/// Nothing is searched before somebody asks for what is not in sight.
void Search::start(const std::vector<LinkedDoor>& doors, std::uint32_t number) {
  doors_ = &doors;
  number_ = number;
  ran_ = false;
}

double Search::before_m(const Step& step) const {
  return step.kind == Step::Kind::node ? reached_[step.a].length_m
                                       : (*doors_)[step.a].door.length_m;
}

const Vec3& Search::place(const Step& step) const {
  return step.kind == Step::Kind::node ? roadmap_.node(step.a) : (*doors_)[step.a].door.at();
}

void Search::offer(std::uint32_t node, double length_m, const Step& from) {
  Reached& reached = reached_[node];
  if (reached.settled || (reached.from.kind != Step::Kind::none && length_m >= reached.length_m))
    return;
  reached.length_m = length_m;
  reached.from = from;
  open_.push_back({length_m, node});
  std::push_heap(open_.begin(), open_.end());
}

/// Who was thought to see the node may not: then it is reached from the best neighbour.
void Search::settle(std::uint32_t node) {
  Reached& own = reached_[node];
  own.settled = true;
  if (own.from.kind == Step::Kind::link || grid_.sees(place(own.from), roadmap_.node(node))) return;
  own.length_m = std::numeric_limits<double>::infinity();
  for (const Roadmap::Edge& edge : roadmap_.edges(node)) {
    const Reached& neighbour = reached_[edge.to];
    if (!neighbour.settled || edge.to == node) continue;
    const double length_m = neighbour.length_m + edge.length_m;
    if (length_m >= own.length_m) continue;
    own.length_m = length_m;
    own.from = {Step::Kind::node, edge.to, 0};
  }
}

void Search::run() {
  ran_ = true;
  reached_.assign(roadmap_.size(), {});
  open_.clear();
  for (const std::uint32_t node : has_pulled_) pulled_[node].clear();
  has_pulled_.clear();
  const auto counts = [this](std::uint32_t last) { return last > number_ + 1; };
  auto missing = std::count_if(last_linked_.begin(), last_linked_.end(), counts);
  for (std::uint32_t d = 0; d < doors_->size(); ++d) {
    const LinkedDoor& door = (*doors_)[d];
    for (std::uint32_t k = 0; k < door.links.size(); ++k) {
      const Roadmap::Link& link = door.links[k];
      const Step::Kind kind = link.between.empty() ? Step::Kind::door : Step::Kind::link;
      offer(link.node, door.door.length_m + link.length_m, {kind, d, k});
    }
  }
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end());
    const std::uint32_t node = open_.back().node;
    open_.pop_back();
    if (reached_[node].settled) continue;
    settle(node);
    if (!last_linked_.empty() && counts(last_linked_[node]) && --missing == 0) return;
    const Reached& here = reached_[node];
    const bool bends = here.from.kind == Step::Kind::link;
    const Step from = bends ? Step{Step::Kind::node, node, 0} : here.from;
    const double length_m = before_m(from);
    const Vec3& at = place(from);
    for (const Roadmap::Edge& edge : roadmap_.edges(node))
      if (!reached_[edge.to].settled)
        offer(edge.to, length_m + (roadmap_.node(edge.to) - at).norm(), from);
  }
}

void Search::try_straight(const LinkedDoor& to, std::size_t door, std::optional<End>& best) {
  for (std::uint32_t d = 0; d < doors_->size(); ++d) {
    const Door& own = (*doors_)[d].door;
    const double length_m = own.length_m + (to.door.at() - own.at()).norm() + to.door.length_m;
    if (best && length_m >= best->length_m) continue;
    if (grid_.sees(own.at(), to.door.at()))
      best = End{length_m, door, {Step::Kind::door, d, 0}, nullptr};
  }
}

/// Each node that the place is linked to, or better the one it is reached from, if that one sees
/// the place.
void Search::try_links(const LinkedDoor& to, std::size_t door, std::optional<End>& best) {
  asked_.clear();
  const auto seen_from = [&](const Step& step) {
    for (const auto& [asked, sees] : asked_)
      if (asked == step) return sees;
    const bool sees = grid_.sees(place(step), to.door.at());
    asked_.emplace_back(step, sees);
    return sees;
  };
  for (const Roadmap::Link& link : to.links) {
    const Reached& node = reached_[link.node];
    if (!node.settled) continue;
    if (link.between.empty() && node.from.kind != Step::Kind::link) {
      Step from = node.from;
      if (from.kind == Step::Kind::door) from.b = 0;
      const double length_m =
          before_m(from) + (to.door.at() - place(from)).norm() + to.door.length_m;
      if (best && length_m >= best->length_m) continue;
      if (seen_from(from)) {
        best = End{length_m, door, from, nullptr};
        continue;
      }
    }
    const double length_m = node.length_m + link.length_m + to.door.length_m;
    if (best && length_m >= best->length_m) continue;
    best = End{length_m, door, {Step::Kind::node, link.node, 0}, &link.between};
  }
}

std::optional<Search::End> Search::best_end(const std::vector<LinkedDoor>& doors) {
  std::optional<End> best;
  for (std::size_t d = 0; d < doors.size(); ++d) try_straight(doors[d], d, best);
  // No way is shorter than the straight one between two free places.
  const bool through_doors = doors.size() > 1 || doors_->size() > 1;
  if (best && !through_doors) return best;
  if (!ran_) run();
  for (std::size_t d = 0; d < doors.size(); ++d) try_links(doors[d], d, best);
  return best;
}

/// From the start's door to a step's place.
std::vector<Vec3> Search::up_to(const Step& step) {
  if (step.kind == Step::Kind::node) return pulled(step.a);
  const LinkedDoor& door = (*doors_)[step.a];
  std::vector<Vec3> way{door.door.at()};
  if (step.kind == Step::Kind::link) {
    const auto& between = door.links[step.b].between;
    way.insert(way.end(), between.begin(), between.end());
  }
  return way;
}

/// The way to a node, its string pulled: many ways have their beginning in common.
const std::vector<Vec3>& Search::pulled(std::uint32_t node) {
  if (!pulled_[node].empty()) return pulled_[node];
  std::vector<Vec3> way = up_to(reached_[node].from);
  way.push_back(roadmap_.node(node));
  pull_end(grid_, way);
  has_pulled_.push_back(node);
  return pulled_[node] = std::move(way);
}

std::optional<std::vector<Vec3>> Search::way(const std::vector<LinkedDoor>& doors) {
  const std::optional<End> end = best_end(doors);
  if (!end) return std::nullopt;
  const LinkedDoor& to = doors[end->door];
  std::vector<Vec3> free = up_to(end->from);
  if (end->between) free.insert(free.end(), end->between->rbegin(), end->between->rend());
  free.push_back(to.door.at());
  if (end->between && !end->between->empty()) shorten(grid_, free);
  pull_end(grid_, free);
  Step first = end->from;
  while (first.kind == Step::Kind::node) first = reached_[first.a].from;
  std::vector<Vec3> way = (*doors_)[first.a].door.way;
  way.insert(way.end(), free.begin() + 1, free.end());
  way.insert(way.end(), to.door.way.rbegin() + 1, to.door.way.rend());
  return way;
}

}  // namespace arcbid
