// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/source.hpp"

#include <fstream>
#include <system_error>

namespace arcbid::readers {
namespace {

/// File names may hold UTF-8; bytes of unknown meaning may not reach a terminal.
enum class Keep : bool { ascii, utf8 };

std::string printable(std::string_view text, Keep keep) {
  std::string out(text);
  for (char& c : out) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || (byte > 0x7f && keep == Keep::ascii)) c = '?';
  }
  return out;
}

}  // namespace

std::string load(const std::filesystem::path& file) {
  const std::string name = display_name(file);
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(name + ": no such file");
  if (std::filesystem::is_directory(status)) {
    throw InputError(name + ": is a directory: name the structure file inside it");
  }
  if (!std::filesystem::is_regular_file(status)) throw InputError(name + ": is not a regular file");
  const auto size = std::filesystem::file_size(file, error);
  if (!error && size == 0) throw InputError(name + ": the file is empty");
  std::ifstream in(file, std::ios::binary);
  if (error || !in) throw InputError(name + ": cannot be opened for reading");
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::string display_name(const std::filesystem::path& file) {
  return printable(file.string(), Keep::utf8);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  return fmt::format("'{}'{}", printable(text.substr(0, kLongest), Keep::ascii),
                     text.size() > kLongest ? "..." : "");
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t from_end = 3; from_end < digits.size(); from_end += 4) {
    digits.insert(digits.size() - from_end, 1, ',');
  }
  return digits;
}

std::string counted(std::uint64_t number, std::string_view singular) {
  return fmt::format("{} {}{}", grouped(number), singular, number == 1 ? "" : "s");
}

}  // namespace arcbid::readers
