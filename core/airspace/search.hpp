// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/airspace/corridors.hpp"
#include "core/airspace/roadmap.hpp"

namespace arcbid {

/// A door and where the roadmap can be joined from it.
struct LinkedDoor {
  Door door;
  std::vector<Roadmap::Link> links;
};

/// Shortest ways from one place to all others, strings pulled on the way: a node's parent is its
/// parent's parent if that one sees it (Lazy Theta*: Nash, Koenig and Tovey 2010). Room to work in
/// is kept from one search to the next.
class Search {
 public:
  /// Keeps references to both.
  Search(const FreeGrid& grid, const Roadmap& roadmap);

  /// Of places that have numbers: which is the last one that has a link to each node, plus one; 0
  /// for none. A search from one of them then ends when it has reached what later ones are linked
  /// to, which changes nothing for these.
  void expect(std::vector<std::uint32_t> last_linked);

  /// From the place that has these doors, and this number if that matters. They must outlive what
  /// is asked afterwards.
  void start(const std::vector<LinkedDoor>& doors, std::uint32_t number = 0);

  /// To the place that has these doors: the way, both ends included, its string pulled between the
  /// doors. None where the two do not hang together.
  std::optional<std::vector<Vec3>> way(const std::vector<LinkedDoor>& doors);

 private:
  /// What a node is reached from: another node, a door, or a link's points between from a door.
  struct Step {
    enum class Kind : std::uint8_t { none, node, door, link } kind = Kind::none;
    std::uint32_t a = 0, b = 0;  // node; door; door and its link
    friend bool operator==(const Step&, const Step&) = default;
  };
  struct Reached {
    double length_m = 0;
    Step from;
    bool settled = false;
  };
  struct Open {
    double length_m;
    std::uint32_t node;
    bool operator<(const Open& other) const;  // so that a heap has the nearest on top
  };
  struct End {
    double length_m;
    std::size_t door;
    Step from;
    const std::vector<Vec3>* between = nullptr;
  };

  void run();
  void settle(std::uint32_t node);
  void offer(std::uint32_t node, double length_m, const Step& from);
  double before_m(const Step& step) const;
  const Vec3& place(const Step& step) const;
  std::optional<End> best_end(const std::vector<LinkedDoor>& doors);
  void try_straight(const LinkedDoor& to, std::size_t door, std::optional<End>& best);
  void try_links(const LinkedDoor& to, std::size_t door, std::optional<End>& best);
  std::vector<Vec3> up_to(const Step& step);
  const std::vector<Vec3>& pulled(std::uint32_t node);

  const FreeGrid& grid_;
  const Roadmap& roadmap_;
  const std::vector<LinkedDoor>* doors_ = nullptr;
  bool ran_ = false;
  std::vector<Reached> reached_;  // by node
  std::vector<Open> open_;
  std::uint32_t number_ = 0;
  std::vector<std::uint32_t> last_linked_;    // by node; empty: every node counts
  std::vector<std::vector<Vec3>> pulled_;     // by node: the way to it; empty: not asked for yet
  std::vector<std::uint32_t> has_pulled_;     // which are not empty
  std::vector<std::pair<Step, bool>> asked_;  // who saw the place that is asked for
};

}  // namespace arcbid
