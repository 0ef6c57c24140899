// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/server.hpp"

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/error.hpp"
#include "sim/view/page.hpp"
#include "sim/view/view_data.hpp"
// Last: the system headers that it takes in define names that Eigen uses.
#include <httplib.h>

namespace arcbid {
namespace {

using namespace std::chrono_literals;

constexpr const char* host = "127.0.0.1";
constexpr auto look_interval = 250ms;
constexpr int keep_alive_looks = 20;  // without news, so that a reader that is gone is noticed

/// Changes whenever a log does, and when the run ends: by sizes and times of all files in the run's
/// folder of logs.
std::uint64_t stamp_of(const std::filesystem::path& run, bool is_live) {
  std::uint64_t stamp = is_live ? 1 : 2;
  std::error_code gone;
  for (const auto& entry : std::filesystem::directory_iterator(run / "logs", gone)) {
    stamp = stamp * 1099511628211u + entry.file_size(gone);
    const auto changed = entry.last_write_time(gone).time_since_epoch().count();
    stamp = stamp * 1099511628211u + static_cast<std::uint64_t>(changed);
  }
  return stamp;
}

}  // namespace

struct ViewServer::Impl {
  std::filesystem::path run;
  std::string page;
  std::function<bool()> is_live;
  httplib::Server server;
  int port = 0;
  std::atomic<bool> stopping = false;
  std::mutex mutex;  // guards what follows
  std::uint64_t stamp = 0;
  std::string data;  // gzip
  std::thread thread;

  /// A run that has only begun has nothing to show yet: an empty object.
  std::string fresh_data() {
    const std::scoped_lock lock(mutex);
    const bool live = is_live();
    const std::uint64_t now = stamp_of(run, live);
    if (now == stamp && !data.empty()) return data;
    try {
      RunArchive archive = open_run(run);
      archive.is_live = live;
      data = gzip(view_data(archive).dump());
    } catch (const InputError&) {
      data = gzip(fmt::format("{{\"schema\": 1, \"live\": {}}}", live));
    }
    stamp = now;
    return data;
  }

  void start(std::uint16_t wanted) {
    server.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
          if (is_ours(request)) return httplib::Server::HandlerResponse::Unhandled;
          response.status = 403;
          return httplib::Server::HandlerResponse::Handled;
        });
    server.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      response.set_content(page, "text/html; charset=utf-8");
    });
    if (wanted == 0)
      port = server.bind_to_any_port(host);
    else if (server.bind_to_port(host, wanted))
      port = wanted;
    if (port <= 0)
      throw InputError(fmt::format("--port {}: is taken; legal: a free one, or 0 for any", wanted));
    thread = std::thread([this] { server.listen_after_bind(); });
    while (!server.is_running()) std::this_thread::sleep_for(1ms);  // stop() before that is lost
  }

  /// Only pages of this server may ask: a name that somebody else made lead here is none of it.
  bool is_ours(const httplib::Request& request) const {
    const std::string here = fmt::format("{}:{}", host, port),
                      name = fmt::format("localhost:{}", port);
    const std::string asked = request.get_header_value("Host");
    if (asked != here && asked != name) return false;
    return !request.has_header("Origin") || request.get_header_value("Origin") == "http://" + asked;
  }

  void serve_updates(httplib::Response& response) {
    response.set_header("Cache-Control", "no-store");
    auto told = std::make_shared<std::uint64_t>(0);
    auto version = std::make_shared<int>(0);
    response.set_chunked_content_provider(
        "text/event-stream", [this, told, version](std::size_t, httplib::DataSink& sink) {
          for (int looks = 0; looks < keep_alive_looks && !stopping; ++looks) {
            const bool live = is_live();
            const std::uint64_t now = stamp_of(run, live);
            if (now != *told) {
              *told = now;
              return say(sink, ++*version, live);
            }
            std::this_thread::sleep_for(look_interval);
          }
          const std::string_view idle = ": nothing new\n\n";
          return !stopping && sink.write(idle.data(), idle.size());
        });
  }
  static bool say(httplib::DataSink& sink, int version, bool live) {
    const std::string line =
        fmt::format("data: {{\"version\": {}, \"ended\": {}}}\n\n", version, !live);
    return sink.write(line.data(), line.size());
  }
};

ViewServer::ViewServer(std::filesystem::path run, const std::filesystem::path& programs,
                       std::uint16_t port, std::function<bool()> is_live)
    : impl_(std::make_unique<Impl>()) {
  Impl& self = *impl_;
  self.run = std::move(run);
  self.page = viewer_page(programs);
  self.is_live = std::move(is_live);
  self.server.Get("/data", [&self](const httplib::Request&, httplib::Response& response) {
    response.set_header("Content-Encoding", "gzip");
    response.set_header("Cache-Control", "no-store");
    response.set_content(self.fresh_data(), "application/json");
  });
  self.server.Get("/updates", [&self](const httplib::Request&, httplib::Response& response) {
    self.serve_updates(response);
  });
  self.start(port);
}

ViewServer::ViewServer(std::string page, std::uint16_t port) : impl_(std::make_unique<Impl>()) {
  impl_->page = std::move(page);
  impl_->start(port);
}

ViewServer::~ViewServer() {
  impl_->stopping = true;
  impl_->server.stop();
  if (impl_->thread.joinable()) impl_->thread.join();
}

std::string ViewServer::address() const {
  return fmt::format("http://{}:{}/", host, impl_->port);
}

}  // namespace arcbid
