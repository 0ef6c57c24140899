// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/run/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace arcbid {
namespace {

constexpr const char* name = "running";
constexpr mode_t readable = 0644;

}  // namespace

RunLock::RunLock(const std::filesystem::path& run) : file_(run / name) {
  std::error_code none;
  std::filesystem::create_directories(run, none);
  fd_ = open(file_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, readable);
  if (fd_ >= 0) flock(fd_, LOCK_EX);  // whoever asks holds it for a moment only
}

RunLock::~RunLock() {
  if (fd_ < 0) return;
  std::error_code none;
  std::filesystem::remove(file_, none);
  close(fd_);
}

bool goes_on(const std::filesystem::path& run) {
  std::error_code none;
  if (std::filesystem::exists(run / "result.json", none)) return false;
  const int fd = open((run / name).c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool is_held = flock(fd, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(fd);
  return is_held;
}

}  // namespace arcbid
