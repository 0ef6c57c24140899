// SPDX-License-Identifier: GPL-3.0-or-later
#include "agent/shared_transit.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/base/digest.hpp"
#include "core/io/run/run_files.hpp"
#include "core/route/make_transit.hpp"

namespace arcbid {
namespace {

/// Of the lengths and of the mission that they belong to.
std::uint64_t seal(const Mission& mission, const std::vector<double>& table) {
  Digest d;
  d.add(digest(mission));
  for (const double length_m : table) d.add(length_m);
  return d.value();
}

/// Empty: there is none, or it is another mission's or damaged.
std::vector<double> stored(const std::filesystem::path& file, const Mission& mission) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::uint64_t sealed = 0;
  if (bytes.size() < sizeof sealed || (bytes.size() - sizeof sealed) % sizeof(double) != 0)
    return {};
  std::memcpy(&sealed, bytes.data(), sizeof sealed);
  std::vector<double> table((bytes.size() - sizeof sealed) / sizeof(double));
  std::memcpy(table.data(), bytes.data() + sizeof sealed, bytes.size() - sizeof sealed);
  return seal(mission, table) == sealed ? table : std::vector<double>{};
}

void store(const std::filesystem::path& file, const Mission& mission,
           const std::vector<double>& table) {
  const std::uint64_t sealed = seal(mission, table);
  std::string bytes(sizeof sealed + table.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), &sealed, sizeof sealed);
  std::memcpy(bytes.data() + sizeof sealed, table.data(), table.size() * sizeof(double));
  write_whole(file, bytes);
}

/// Held while one works. The kernel lets go of it however that one ends.
class Turn {
 public:
  explicit Turn(const std::filesystem::path& file)
      : fd_(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    if (fd_ >= 0) ::flock(fd_, LOCK_EX);
  }
  ~Turn() {
    if (fd_ >= 0) ::close(fd_);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  int fd_;
};

}  // namespace

std::shared_ptr<const Transit> shared_transit(const Mission& mission,
                                              const std::filesystem::path& run) {
  if (mission.airspace.empty()) return make_transit(mission);
  const auto file = run / "transit.bin";
  const Turn turn(run / "transit.lock");
  std::vector<double> known = stored(file, mission);
  const bool is_known = !known.empty();
  auto transit = make_obstacle_transit(mission, std::move(known));
  if (!is_known) {
    try {
      store(file, mission, transit->table());
    } catch (const std::exception&) {
      // A full disk costs the others their time, not the run.
    }
  }
  return transit;
}

}  // namespace arcbid
