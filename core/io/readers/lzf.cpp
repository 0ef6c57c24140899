// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/lzf.hpp"

#include <cstring>

namespace arcbid::readers {

bool lzf_decompress(std::string_view in, std::span<char> out) {
  std::size_t read = 0, written = 0;
  const auto byte = [&] { return static_cast<unsigned char>(in[read++]); };
  while (read < in.size()) {
    const unsigned control = byte();
    if (control < 32) {  // a run of control + 1 literal bytes
      const std::size_t length = control + 1;
      if (length > in.size() - read || length > out.size() - written) return false;
      std::memcpy(out.data() + written, in.data() + read, length);
      read += length;
      written += length;
      continue;
    }
    std::size_t length = control >> 5;  // a copy of earlier output; 7 means one more length byte
    if (in.size() - read < (length == 7 ? 2u : 1u)) return false;
    if (length == 7) length += byte();
    length += 2;
    const std::size_t distance = ((control & 31u) << 8) + byte() + 1;
    if (distance > written || length > out.size() - written) return false;
    // Byte by byte: source and target overlap when the distance is shorter than the length.
    for (std::size_t i = 0; i < length; ++i, ++written) out[written] = out[written - distance];
  }
  return written == out.size();
}

}  // namespace arcbid::readers
