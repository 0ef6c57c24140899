// SPDX-License-Identifier: GPL-3.0-or-later
// Records as another build would have laid them out: by a schema that is like this build's but for
// what a test changes in it.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <string>

#include "core/io/record/cdr.hpp"
#include "core/io/record/fields.hpp"
#include "core/io/record/stored_schema.hpp"

namespace arcbid::testing {

/// `schema` with the first `line` (whole, without its end) behind "MSG: arcbid_msgs/PART" replaced;
/// PART empty: at the top. `by` may be several lines, or none.
std::string with(std::string schema, const std::string& part, const std::string& line,
                 const std::string& by);

/// Writes a record field by field in the order of the schema. What this build does not have is a 7,
/// "old", or two of them.
class OtherBuild {
 public:
  template <class Record>
  static std::string encode(const Record& record, const StoredSchema& schema) {
    std::string room(1 << 16, '\0');
    eprosima::fastcdr::FastBuffer buffer(room.data(), room.size());
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    cdr.serialize_encapsulation();
    OtherBuild(cdr).write(schema.record(), record);
    room.resize(cdr.getSerializedDataLength());
    return room;
  }

 private:
  using Type = StoredSchema::Type;
  using Base = StoredSchema::Base;
  explicit OtherBuild(eprosima::fastcdr::Cdr& cdr) : cdr_(cdr) {}

  struct Finder {
    OtherBuild& out;
    const StoredSchema::Field& field;
    bool found = false;

    template <class T>
    void operator()(std::string_view name, const T& value) {
      if (name != field.name) return;
      found = true;
      out.put(field.type, value);
    }
    template <std::size_t n, class... Ts>
    void choice(const std::array<std::string_view, n>& names, const std::variant<Ts...>& chosen) {
      std::size_t at = 0;
      (alternative(names[at++], std::get_if<Ts>(&chosen)), ...);
    }
    template <class T>
    void alternative(std::string_view name, const T* value) {
      if (name != field.name) return;
      found = true;
      out.cdr_ << static_cast<std::uint32_t>(value != nullptr);
      if (value) out.write(*field.type.record, *value);
    }
  };

  template <class T>
  void write(const StoredSchema::Record& stored, const T& record) {
    for (const StoredSchema::Field& field : stored.fields) {
      Finder finder{*this, field};
      fields(finder, record);
      if (!finder.found) make_up(field.type);
    }
  }
  template <class T>
  void put(const Type& type, const T& value) {
    if constexpr (std::same_as<T, std::string>)
      type.base == Base::string ? void(cdr_ << value) : make_up_one(type);
    else if constexpr (IsId<T>)
      number(type, value.value);
    else if constexpr (std::same_as<T, Vec3>)
      for (int axis = 0; axis < 3; ++axis) number(type, value[axis]);
    else if constexpr (std::is_arithmetic_v<T>)
      number(type, value);
    else if constexpr (std::is_enum_v<T>)
      number(type, static_cast<int>(value));
    else if (type.record)
      write(*type.record, value);
    else
      make_up_one(type);
  }
  template <class T>
  void put(const Type& type, const std::vector<T>& values) {
    cdr_ << static_cast<std::uint32_t>(values.size());
    for (const T& value : values) put(type, value);
  }
  template <class T>
  void put(const Type& type, const std::optional<T>& value) {
    if constexpr (IsId<T>) {
      number(type, value ? std::int64_t{value->value} : -1);
    } else {
      cdr_ << static_cast<std::uint32_t>(value.has_value());
      if (value) put(type, *value);
    }
  }
  template <class T>
  void number(const Type& type, T value) {
    switch (type.base) {
      case Base::int8:
        cdr_ << static_cast<std::int8_t>(value);
        break;
      case Base::boolean:
      case Base::uint8:
        cdr_ << static_cast<std::uint8_t>(value);
        break;
      case Base::int16:
        cdr_ << static_cast<std::int16_t>(value);
        break;
      case Base::uint16:
        cdr_ << static_cast<std::uint16_t>(value);
        break;
      case Base::int32:
        cdr_ << static_cast<std::int32_t>(value);
        break;
      case Base::uint32:
        cdr_ << static_cast<std::uint32_t>(value);
        break;
      case Base::int64:
        cdr_ << static_cast<std::int64_t>(value);
        break;
      case Base::uint64:
        cdr_ << static_cast<std::uint64_t>(value);
        break;
      case Base::float32:
        cdr_ << static_cast<float>(value);
        break;
      case Base::float64:
        cdr_ << static_cast<double>(value);
        break;
      default:
        make_up_one(type);
    }
  }
  void make_up(const Type& type) {
    std::uint32_t left = type.count;
    if (type.shape == StoredSchema::Shape::sequence) cdr_ << (left = 2);
    for (; left > 0; --left) make_up_one(type);
  }
  void make_up_one(const Type& type) {
    if (type.base == Base::string)
      cdr_ << std::string("old");
    else if (type.record)
      for (const StoredSchema::Field& field : type.record->fields) make_up(field.type);
    else
      number(type, 7);
  }

  eprosima::fastcdr::Cdr& cdr_;
};

}  // namespace arcbid::testing
