// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace arcbid {

/// A record's schema as a log has it, understood: what SchemaWriter writes, in this build or in
/// another. Records of other builds are read by it.
class StoredSchema {
 public:
  enum class Base : std::uint8_t {
    boolean,
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64,
    string,
    record
  };
  enum class Shape : std::uint8_t { one, array, sequence };
  struct Record;
  struct Type {
    std::string text;  ///< as it is written: "arcbid_msgs/Claim[]"
    Base base = Base::record;
    Shape shape = Shape::one;
    std::uint32_t count = 1;         ///< of an array
    const Record* record = nullptr;  ///< what it is made of, if Base::record
  };
  struct Field {
    Type type;
    std::string name;
  };
  /// Never empty, and never a part of itself: each takes bytes, and there is an end to reading it.
  struct Record {
    std::vector<Field> fields;
  };

  /// Throws InputError: one line that names the line of the schema.
  explicit StoredSchema(std::string_view text);

  const Record& record() const { return *root_; }
  /// A type by itself; of what a record is made is not known then.
  static Type type_in(std::string_view text);
  /// Whether a value of type `stored` can be kept in a field of type `here`. A number that is too
  /// large is another matter.
  static bool fits(const Type& stored, const Type& here);
  /// Field by field what is otherwise than in `here`, the schema of this build's record `name`.
  std::vector<std::string> differences(const StoredSchema& here, std::string_view name) const;

 private:
  void resolve(Type& type, const std::string& line) const;

  std::map<std::string, std::unique_ptr<Record>, std::less<>> parts_;
  std::unique_ptr<Record> root_;
};

}  // namespace arcbid
