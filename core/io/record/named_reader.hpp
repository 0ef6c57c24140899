// SPDX-License-Identifier: GPL-3.0-or-later
// CDR to records by the fields' names: bytes that another build laid out, by the schema that it
// left with them. What this build does not know is passed over, what the bytes do not have is left
// as it is. Cdr: Fast CDR's.
#pragma once

#include <utility>

#include "core/io/record/cdr.hpp"
#include "core/io/record/schema.hpp"
#include "core/io/record/stored_schema.hpp"

namespace arcbid {

template <class Cdr>
class NamedReader {
  using Base = StoredSchema::Base;
  using Type = StoredSchema::Type;

 public:
  explicit NamedReader(Cdr& cdr) : cdr_(cdr) {}

  template <class T>
  void read(const StoredSchema::Record& stored, T& record) {
    Blank blank;
    fields(blank, record);
    Taker take{*this, nullptr, false, false, 0};
    for (const StoredSchema::Field& field : stored.fields) {
      take.field = &field;
      take.is_taken = false;
      fields(take, record);
      if (!take.is_taken) skip(field.type);
    }
    if (take.is_choice && take.chosen != 1)
      throw InputError(
          fmt::format("{}: {} alternatives of a choice that are known here, legal: one",
                      record_name<T>, take.chosen));
  }

 private:
  /// Eigen leaves vectors as they are: what is not stored would be what was there before.
  struct Blank {
    template <class T>
    void operator()(std::string_view, T& value) {
      if constexpr (std::same_as<T, Vec3>) value.setZero();
    }
    template <std::size_t n, class... Ts>
    void choice(const std::array<std::string_view, n>&, std::variant<Ts...>&) {}
  };

  /// Goes through this build's fields for one that is stored.
  struct Taker {
    NamedReader& reader;
    const StoredSchema::Field* field;
    bool is_taken;
    bool is_choice;  // whether the record here is one, whatever is stored
    int chosen;      // how many of its alternatives are there

    template <class T>
    void operator()(std::string_view name, T& value) {
      if (name != field->name || !StoredSchema::fits(field->type, type_here<T>())) return;
      is_taken = true;
      reader.field_ = name;
      reader.get(field->type, value);
    }
    template <std::size_t n, class... Ts>
    void choice(const std::array<std::string_view, n>& names, std::variant<Ts...>& value) {
      is_choice = true;
      std::size_t at = 0;
      (alternative<Ts>(names[at++], value), ...);
    }
    template <class T, class Choice>
    void alternative(std::string_view name, Choice& value) {
      if (name != field->name || field->type.base != Base::record ||
          field->type.shape != StoredSchema::Shape::sequence)
        return;
      is_taken = true;
      reader.field_ = name;
      if (!reader.is_there()) return;
      ++chosen;
      reader.read(*field->type.record, value.template emplace<T>());
    }
  };

  template <class T>
  static const Type& type_here() {
    static const Type type = StoredSchema::type_in(SchemaWriter::type_of<T>());
    return type;
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("field {}: {}", field_, why));
  }
  std::uint32_t count() {
    std::uint32_t entries = 0;
    cdr_ >> entries;
    return entries;
  }
  bool is_there() {
    const std::uint32_t entries = count();
    if (entries > 1) refuse(fmt::format("{} entries, legal: none or one", entries));
    return entries == 1;
  }

  template <class T>
  void get(const Type& type, T& value) {
    if constexpr (Number<T>)
      value = number<T>(type);
    else if constexpr (std::same_as<T, bool> || std::is_enum_v<T>)
      value = static_cast<T>(number<std::uint8_t>(type, most_of<T>()));
    else if constexpr (IsId<T>)
      value.value = number<std::uint32_t>(type);
    else if constexpr (std::same_as<T, std::string>)
      cdr_ >> value;
    else if constexpr (std::same_as<T, Vec3>)
      for (int axis = 0; axis < 3; ++axis) value[axis] = number<double>(type);
    else
      read(*type.record, value);
  }
  template <class T>
  void get(const Type& type, std::vector<T>& values) {
    values.clear();
    for (std::uint32_t left = count(); left > 0; --left) get(type, values.emplace_back());
  }
  template <class T>
  void get(const Type& type, std::optional<T>& value) {
    value.reset();
    if constexpr (IsId<T>) {
      const auto id = number<std::int64_t>(type, std::numeric_limits<std::uint32_t>::max(), -1);
      if (id >= 0) value = T{static_cast<std::uint32_t>(id)};
    } else if (is_there()) {
      get(type, value.emplace());
    }
  }

  /// A number as it is stored, to a wider or a narrower one; it must be the same.
  template <class T>
  T number(const Type& type, T most = std::numeric_limits<T>::max(),
           T least = std::numeric_limits<T>::lowest()) {
    T out{};
    with_number(type, [&](auto stored) {
      if constexpr (std::integral<T> && std::integral<decltype(stored)>) {
        if (std::cmp_less(stored, least) || std::cmp_greater(stored, most))
          refuse(fmt::format("{}, legal: {} to {}", stored, least, most));
      }
      out = static_cast<T>(stored);
    });
    return out;
  }
  template <class T, class Take>
  void take_number(Take& take) {
    T stored{};
    cdr_ >> stored;
    take(stored);
  }
  template <class Take>
  void with_number(const Type& type, Take take) {
    switch (type.base) {
      case Base::int8:
        return take_number<std::int8_t>(take);
      case Base::boolean:
      case Base::uint8:
        return take_number<std::uint8_t>(take);
      case Base::int16:
        return take_number<std::int16_t>(take);
      case Base::uint16:
        return take_number<std::uint16_t>(take);
      case Base::int32:
        return take_number<std::int32_t>(take);
      case Base::uint32:
        return take_number<std::uint32_t>(take);
      case Base::int64:
        return take_number<std::int64_t>(take);
      case Base::uint64:
        return take_number<std::uint64_t>(take);
      case Base::float32:
        return take_number<float>(take);
      case Base::float64:
        return take_number<double>(take);
      case Base::string:
      case Base::record:
        check(false, "a number was asked for");
    }
  }

  void skip(const Type& type) {
    using Shape = StoredSchema::Shape;
    for (std::uint32_t left = type.shape == Shape::sequence ? count() : type.count; left > 0;
         --left)
      if (type.record) {
        for (const StoredSchema::Field& field : type.record->fields) skip(field.type);
      } else if (type.base == Base::string) {
        cdr_ >> passed_over_;
      } else {
        with_number(type, [](auto) {});
      }
  }

  Cdr& cdr_;
  std::string_view field_;
  std::string passed_over_;
};

}  // namespace arcbid
