// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/record/stored_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "core/base/error.hpp"

namespace arcbid {
namespace {

using Schema = StoredSchema;

constexpr std::array<std::string_view, 12> base_names{"bool",   "int8",    "uint8",   "int16",
                                                      "uint16", "int32",   "uint32",  "int64",
                                                      "uint64", "float32", "float64", "string"};
constexpr std::string_view message = "MSG: ";

/// A damaged one holds anything.
[[noreturn]] void refuse(std::string_view line) {
  std::string shown(line.substr(0, 80));
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  throw InputError(fmt::format("its line \"{}\" is not understood", shown));
}

bool is_float(Schema::Base base) {
  return base == Schema::Base::float32 || base == Schema::Base::float64;
}
bool is_number(Schema::Base base) {
  return base < Schema::Base::string;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

bool is_name(std::string_view text) {
  constexpr std::string_view legal =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  return !text.empty() && text.find_first_not_of(legal) == std::string_view::npos;
}

/// [], [<=1], [3]
void take_brackets(std::string_view inside, Schema::Type& type) {
  type.shape = Schema::Shape::sequence;
  if (inside.empty()) return;
  if (inside.starts_with("<="))
    inside.remove_prefix(2);
  else
    type.shape = Schema::Shape::array;
  const auto [end, error] =
      std::from_chars(inside.data(), inside.data() + inside.size(), type.count);
  if (error != std::errc() || end != inside.data() + inside.size() || type.count == 0)
    refuse(type.text);
}

/// How many records lie within each other. A limit: reading them takes a call each.
class Nesting {
 public:
  int depth(const Schema::Record& record, int outside = 0) {
    constexpr int most = 32;
    if (outside > most) throw InputError("its types are nested too deep, or in themselves");
    if (const auto known = depths_.find(&record); known != depths_.end()) return known->second;
    int within = 0;
    for (const Schema::Field& field : record.fields)
      if (field.type.record) within = std::max(within, depth(*field.type.record, outside + 1));
    if (outside + within + 1 > most)
      throw InputError("its types are nested too deep, or in themselves");
    return depths_[&record] = within + 1;
  }

 private:
  std::map<const Schema::Record*, int> depths_;
};

const Schema::Field* named(const Schema::Record& record, std::string_view name) {
  const auto at = std::find_if(record.fields.begin(), record.fields.end(),
                               [name](const Schema::Field& field) { return field.name == name; });
  return at == record.fields.end() ? nullptr : &*at;
}

/// Walks a stored record and this build's side by side.
class Comparison {
 public:
  std::vector<std::string> found;

  void compare(const Schema::Record& stored, const Schema::Record& here, std::string_view name) {
    if (!seen_.insert({&stored, &here}).second) return;
    std::size_t last = 0;
    bool in_order = true;
    for (const Schema::Field& field : here.fields) {
      const Schema::Field* other = named(stored, field.name);
      if (!other) {
        found.push_back(fmt::format("{}.{} is not there", name, field.name));
        continue;
      }
      const auto place = static_cast<std::size_t>(other - stored.fields.data());
      in_order = in_order && place >= last;
      last = place;
      compare(*other, field, name);
    }
    for (const Schema::Field& field : stored.fields)
      if (!named(here, field.name))
        found.push_back(fmt::format("{}.{} is not known here", name, field.name));
    if (!in_order) found.push_back(fmt::format("{} has its fields in another order", name));
  }

 private:
  void compare(const Schema::Field& stored, const Schema::Field& here, std::string_view name) {
    const Schema::Type &type = stored.type, &of_here = here.type;
    if (!Schema::fits(type, of_here))
      found.push_back(fmt::format("{}.{} is {}, here {}, and is left out", name, here.name,
                                  type.text, of_here.text));
    else if (type.record)
      compare(*type.record, *of_here.record, bare(of_here.text));
    else if (type.text != of_here.text)
      found.push_back(
          fmt::format("{}.{} is {}, here {}", name, here.name, type.text, of_here.text));
  }
  /// arcbid_msgs/Claim[]: Claim
  static std::string_view bare(std::string_view text) {
    text = text.substr(0, text.find('['));
    return text.substr(text.find('/') + 1);
  }

  std::set<std::pair<const Schema::Record*, const Schema::Record*>> seen_;
};

}  // namespace

StoredSchema::StoredSchema(std::string_view text) : root_(std::make_unique<Record>()) {
  const std::vector<std::string> lines = lines_of(text);
  for (const std::string& line : lines)
    if (line.starts_with(message)) parts_[line.substr(message.size())] = std::make_unique<Record>();
  Record* part = root_.get();
  for (const std::string& line : lines) {
    if (line.starts_with('=')) continue;
    if (line.starts_with(message)) {
      part = parts_.find(line.substr(message.size()))->second.get();
      continue;
    }
    const auto space = line.find(' ');
    if (space == std::string::npos || !is_name(line.substr(space + 1))) refuse(line);
    Field field{type_in(std::string_view(line).substr(0, space)), line.substr(space + 1)};
    resolve(field.type, line);
    part->fields.push_back(std::move(field));
  }
  if (root_->fields.empty()) throw InputError("it has no fields");
  for (const auto& [name, record] : parts_)
    if (record->fields.empty()) throw InputError(fmt::format("its {} has no fields", name));
  Nesting().depth(*root_);
}

void StoredSchema::resolve(Type& type, const std::string& line) const {
  if (type.base != Base::record) return;
  const auto part = parts_.find(std::string_view(type.text).substr(0, type.text.find('[')));
  if (part == parts_.end()) refuse(line);
  type.record = part->second.get();
}

StoredSchema::Type StoredSchema::type_in(std::string_view text) {
  Type type;
  type.text = text;
  const auto bracket = text.find('[');
  if (bracket != std::string_view::npos) {
    if (text.back() != ']') refuse(text);
    take_brackets(text.substr(bracket + 1, text.size() - bracket - 2), type);
    text = text.substr(0, bracket);
  }
  const auto at = std::find(base_names.begin(), base_names.end(), text);
  if (at == base_names.end() && text.find('/') == std::string_view::npos) refuse(type.text);
  type.base = static_cast<Base>(at - base_names.begin());
  return type;
}

bool StoredSchema::fits(const Type& stored, const Type& here) {
  if (stored.shape != here.shape) return false;
  if (stored.shape == Shape::array && stored.count != here.count) return false;
  if (!is_number(stored.base) || !is_number(here.base)) return stored.base == here.base;
  return is_float(here.base) || !is_float(stored.base);
}

std::vector<std::string> StoredSchema::differences(const StoredSchema& here,
                                                   std::string_view name) const {
  Comparison comparison;
  comparison.compare(*root_, *here.root_, name);
  if (comparison.found.empty())
    comparison.found.emplace_back("its types have other names or bounds");
  return std::move(comparison.found);
}

}  // namespace arcbid
