// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/wire_size.hpp"

#include <variant>

namespace arcbid {
namespace {

/// CDR aligns every primitive to its own size.
class Cdr {
 public:
  Cdr& boolean() { return add(1); }
  Cdr& word() { return add(4); }       ///< unsigned long, an enumerator, a sequence's length
  Cdr& long_word() { return add(8); }  ///< unsigned long long, double
  std::uint64_t bytes() const { return bytes_; }

 private:
  Cdr& add(std::uint64_t size) {
    bytes_ = (bytes_ + size - 1) / size * size + size;
    return *this;
  }
  std::uint64_t bytes_ = 0;
};

void add_header(Cdr& cdr) {
  cdr.word().long_word().long_word().long_word().long_word();
}

void add_key(Cdr& cdr) {
  cdr.long_word().boolean().word();
}

void add(Cdr& cdr, const Claims& claims) {
  cdr.word();
  for (std::size_t n = 0; n < claims.bundle.size(); ++n) cdr.word().long_word();
}

void add(Cdr& cdr, const Table& table) {
  cdr.word();
  for (std::size_t n = 0; n < table.beliefs.size(); ++n) cdr.boolean().word().long_word();
  cdr.word();
  for (std::size_t n = 0; n < table.timestamps.size(); ++n) cdr.long_word();
}

void add(Cdr& cdr, const Statement& statement) {
  add_key(cdr);
  cdr.word();
  std::visit([&cdr](const auto& body) { add(cdr, body); }, statement.body);
}

}  // namespace

std::uint64_t wire_size(const BidMessage& message) {
  Cdr cdr;
  add_header(cdr);
  add(cdr.word(), message.statement);
  return cdr.bytes();
}

std::uint64_t wire_size(const RelayMessage& message) {
  Cdr cdr;
  add_header(cdr);
  add(cdr.word().word(), message.statement);
  return cdr.bytes();
}

std::uint64_t wire_size(const StatusMessage& message) {
  Cdr cdr;
  add_header(cdr);
  cdr.word().word().word().word().long_word();
  cdr.word();
  for (std::size_t n = 0; n < message.ready.size(); ++n) cdr.word();
  cdr.boolean().word();
  for (std::size_t n = 0; n < message.view.size(); ++n) add_key(cdr.word());
  cdr.word();
  for (std::size_t n = 0; n < message.heartbeats.size(); ++n) cdr.word().long_word().long_word();
  return cdr.bytes();
}

}  // namespace arcbid
