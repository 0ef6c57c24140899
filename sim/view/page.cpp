// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/page.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <fstream>

#include "core/base/error.hpp"
#include "sim/view/base64.hpp"

namespace arcbid {
namespace {

constexpr std::string_view place = "<!--arcbid-data-->";

}  // namespace

std::string viewer_page(const std::filesystem::path& programs) {
  const auto share = programs.parent_path() / "share";
  for (const auto& file : {share / "viewer.html", share / "arcbid" / "viewer.html"}) {
    std::ifstream in(file, std::ios::binary);
    if (!in) continue;
    std::string page(std::istreambuf_iterator<char>(in), {});
    if (page.find(place) == std::string::npos)
      throw InputError(
          fmt::format("{}: is no viewer page: it has no place for a run", file.string()));
    return page;
  }
  throw InputError(fmt::format(
      "{}: the viewer was not built: node and npm were missing, or npm had no network; install "
      "nodejs and npm, and build again",
      (share / "viewer.html").string()));
}

std::string report_page(std::string page, const std::string& data) {
  const std::string element = "<script id=\"arcbid-data\" type=\"application/gzip-base64\">" +
                              base64(gzip(data)) + "</script>";
  return page.replace(page.find(place), place.size(), element);
}

std::string gzip(std::string_view text) {
  constexpr int gzip_window = 15 + 16;
  constexpr int memory_level = 8;
  z_stream stream = {};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw RunError("zlib: out of memory");
  std::string out(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int end = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  check(end == Z_STREAM_END, "the bound of zlib holds");
  return out;
}

}  // namespace arcbid
