// SPDX-License-Identifier: GPL-3.0-or-later
// Records to CDR and back, by their fields. What CDR has no word for: an optional is a sequence of
// none or one, a choice one such sequence for each alternative, "nobody" is -1. Cdr: Fast CDR's.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <type_traits>

#include "core/base/error.hpp"
#include "core/io/record/fields.hpp"

namespace arcbid {

template <class T>
concept Number = std::is_arithmetic_v<T> && !std::same_as<T, bool>;
template <class T>
concept IsId = std::same_as<T, AgentId> || std::same_as<T, TaskId> || std::same_as<T, ArcId>;

/// The highest value of a bool or an enum.
template <class T>
constexpr std::uint8_t most_of() {
  if constexpr (std::same_as<T, bool>) return 1;
  if constexpr (std::same_as<T, Phase>) return static_cast<std::uint8_t>(Phase::routed);
  if constexpr (std::same_as<T, ArcKind>) return static_cast<std::uint8_t>(ArcKind::gap);
  if constexpr (std::same_as<T, PolicyKind>) return policy_names.size() - 1;
  if constexpr (std::same_as<T, ScoreKind>) return score_names.size() - 1;
  if constexpr (std::same_as<T, TradesKind>) return trades_names.size() - 1;
  if constexpr (std::same_as<T, Payload>) return payload_names.size() - 1;
  if constexpr (std::same_as<T, NoBidderReason>) return no_bidder_reason_names.size() - 1;
  if constexpr (std::same_as<T, TourSolver>) return tour_solver_names.size() - 1;
}

template <class Cdr>
class CdrWriter {
 public:
  explicit CdrWriter(Cdr& cdr) : cdr_(cdr) {}

  template <class T>
  void operator()(std::string_view, const T& value) {
    put(value);
  }
  template <std::size_t n, class... Ts>
  void choice(const std::array<std::string_view, n>&, const std::variant<Ts...>& chosen) {
    static_assert(n == sizeof...(Ts));
    (put_if(std::get_if<Ts>(&chosen)), ...);
  }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (Number<T>)
      cdr_ << value;
    else if constexpr (std::same_as<T, bool> || std::is_enum_v<T>)
      cdr_ << static_cast<std::uint8_t>(value);
    else if constexpr (IsId<T>)
      cdr_ << value.value;
    else if constexpr (std::same_as<T, std::string>)
      cdr_ << value;
    else if constexpr (std::same_as<T, Vec3>)
      cdr_ << value.x() << value.y() << value.z();
    else
      fields(*this, value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    cdr_ << static_cast<std::uint32_t>(values.size());
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    if constexpr (IsId<T>)
      cdr_ << (value ? std::int64_t{value->value} : std::int64_t{-1});
    else
      put_if(value ? &*value : nullptr);
  }
  template <class T>
  void put_if(const T* value) {
    cdr_ << static_cast<std::uint32_t>(value != nullptr);
    if (value != nullptr) put(*value);
  }

  Cdr& cdr_;
};

template <class Cdr>
class CdrReader {
 public:
  /// `bytes`: all that there is to read; no count can be larger.
  CdrReader(Cdr& cdr, std::size_t bytes) : cdr_(cdr), bytes_(bytes) {}

  template <class T>
  void operator()(std::string_view field, T& value) {
    field_ = field;
    get(value);
  }
  template <std::size_t n, class... Ts>
  void choice(const std::array<std::string_view, n>& names, std::variant<Ts...>& chosen) {
    field_ = names[0];
    int found = 0;
    const auto try_one = [&]<class T>(std::type_identity<T>) {
      std::uint32_t count = 0;
      cdr_ >> count;
      if (count > 1) refuse(fmt::format("{} entries, legal: none or one", count));
      if (count == 0) return;
      // What is there already keeps its room.
      if (!std::holds_alternative<T>(chosen)) chosen.template emplace<T>();
      get(std::get<T>(chosen));
      ++found;
    };
    (try_one(std::type_identity<Ts>{}), ...);
    if (found != 1) refuse(fmt::format("{} alternatives of a choice, legal: one", found));
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("field {}: {}", field_, why));
  }
  template <class T>
  void get(T& value) {
    if constexpr (Number<T>)
      cdr_ >> value;
    else if constexpr (std::same_as<T, bool> || std::is_enum_v<T>)
      get_small(value);
    else if constexpr (IsId<T>)
      cdr_ >> value.value;
    else if constexpr (std::same_as<T, std::string>)
      cdr_ >> value;
    else if constexpr (std::same_as<T, Vec3>)
      cdr_ >> value.x() >> value.y() >> value.z();
    else
      fields(*this, value);
  }
  template <class T>
  void get_small(T& value) {
    std::uint8_t byte = 0;
    cdr_ >> byte;
    if (byte > most_of<T>()) refuse(fmt::format("{}, legal: 0 to {}", byte, most_of<T>()));
    value = static_cast<T>(byte);
  }
  template <class T>
  void get(std::vector<T>& values) {
    std::uint32_t size = 0;
    cdr_ >> size;
    if (size > bytes_) refuse(fmt::format("{} entries in {} bytes", size, bytes_));
    values.clear();
    values.reserve(size);
    for (std::uint32_t n = 0; n < size; ++n) get(values.emplace_back());
  }
  template <class T>
  void get(std::optional<T>& value) {
    value.reset();
    if constexpr (IsId<T>) {
      std::int64_t id = 0;
      cdr_ >> id;
      if (id < -1 || id > std::numeric_limits<std::uint32_t>::max())
        refuse(fmt::format("{} is no id, nor -1", id));
      if (id >= 0) value = T{static_cast<std::uint32_t>(id)};
    } else {
      std::uint32_t count = 0;
      cdr_ >> count;
      if (count > 1) refuse(fmt::format("{} entries, legal: none or one", count));
      if (count == 1) get(value.emplace());
    }
  }

  Cdr& cdr_;
  std::size_t bytes_;
  std::string_view field_;
};

}  // namespace arcbid
