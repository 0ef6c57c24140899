// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <string>
#include <string_view>

namespace arcbid {

inline std::string base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  using Base64 = base64_from_binary<transform_width<const char*, 6, 8>>;
  std::string out(Base64(bytes.data()), Base64(bytes.data() + bytes.size()));
  out.append((3 - bytes.size() % 3) % 3, '=');
  return out;
}

}  // namespace arcbid
