// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace arcbid {

/// Serves the viewer of one run on this machine, also while the run goes on: the page at /, what it
/// shows at /data, and at /updates a server-sent event whenever there is more to see. Reads the
/// run's logs only; binds 127.0.0.1.
class ViewServer {
 public:
  /// `port` 0: any that is free. `is_live`: whether more is to come; asked by other threads. Throws
  /// InputError when the port is taken, or the viewer was not built.
  ViewServer(std::filesystem::path run, const std::filesystem::path& programs, std::uint16_t port,
             std::function<bool()> is_live);
  /// Serves one page that needs nothing else.
  ViewServer(std::string page, std::uint16_t port);
  ~ViewServer();

  std::string address() const;  ///< where a browser finds it

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace arcbid
