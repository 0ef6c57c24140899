// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <map>

#include "core/io/config/keys.hpp"

namespace arcbid::yaml {

template <class Owner>
using Keys = std::vector<Key<Owner>>;

/// A key whose value is `get(owner)`: a pointer to a member, or a function to a reference.
template <class Owner, class T, class Get>
Key<Owner> field(const std::string& name, Get get, const Kind<T>& kind, const std::string& meaning,
                 bool required = false) {
  return {name,
          kind.legal,
          meaning,
          [=](const Place& place, Owner& owner, Report& report) {
            kind.read(place, std::invoke(get, owner), report);
          },
          [=](const Owner& owner) { return kind.print(std::invoke(get, owner)); },
          required};
}

template <class Owner>
std::vector<std::string> names_of(const Keys<Owner>& keys) {
  std::vector<std::string> names;
  for (const Key<Owner>& key : keys) names.push_back(key.name);
  return names;
}

/// The words of a mapping with their values; a word that is none or stands twice is reported.
std::vector<std::pair<std::string, Place>> entries_of(const Place& place, Report& report);

/// Reads a mapping: unknown, repeated and malformed keys are reported, required ones demanded.
/// Found keys are noted in the report. Without a value: all defaults.
template <class Owner>
void read_fields(const Place& place, const Keys<Owner>& keys, Owner& owner, Report& report) {
  for (const auto& [word, value] : entries_of(place, report)) {
    const auto key =
        std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.name == word; });
    if (key != keys.end()) {
      key->read(value, owner, report);
      continue;
    }
    const std::string near = did_you_mean(word, names_of(keys));
    report.problem(
        value.at, value.path,
        "unknown key" +
            (near.empty() ? fmt::format("; legal: {}", fmt::join(names_of(keys), ", ")) : near));
  }
  for (const Key<Owner>& key : keys)
    if (const std::string path = fmt::format("{}.{}", place.path, key.name);
        key.required && !report.has(path))
      report.problem(place.at, path, "missing; legal: " + key.legal);
}

/// "loss: 0.3" for every field that differs from its default, or is required.
template <class Owner>
std::vector<std::string> printed_fields(const Keys<Owner>& keys, const Owner& owner) {
  std::vector<std::string> fields;
  for (const Key<Owner>& key : keys) {
    const std::string value = key.print(owner);
    if (value.empty() || (!key.required && value == key.print(Owner{}))) continue;
    fields.push_back(fmt::format("{}:{}{}", key.name, value.starts_with('\n') ? "" : " ", value));
  }
  return fields;
}

template <class Owner>
std::string print_fields(const Keys<Owner>& keys, const Owner& owner) {
  return fmt::format("{{{}}}", fmt::join(printed_fields(keys, owner), ", "));
}

/// A mapping with these keys.
template <class T>
Kind<T> mapping(const Keys<T>& keys) {
  return {fmt::format("a mapping of {}", fmt::join(names_of(keys), ", ")),
          [=](const Place& place, T& value, Report& report) {
            read_fields(place, keys, value, report);
          },
          [=](const T& value) { return print_fields(keys, value); }};
}

/// A value that may be absent.
template <class T>
Kind<std::optional<T>> optional_of(const Kind<T>& kind) {
  return {kind.legal,
          [=](const Place& place, std::optional<T>& value, Report& report) {
            kind.read(place, value.emplace(), report);
          },
          [=](const std::optional<T>& value) { return value ? kind.print(*value) : ""; }};
}

/// How a list is printed: [a, b], or a line each.
enum class Layout { flow, block };

/// A list of up to `most` values. Without a value: an empty one.
template <class T>
Kind<std::vector<T>> list_of(const Kind<T>& kind, std::size_t most, const std::string& values,
                             Layout layout = Layout::flow) {
  const std::string legal = fmt::format("a list of up to {} {}", most, values);
  return {legal,
          [=](const Place& place, std::vector<T>& list, Report& report) {
            if (place.node.IsNull()) return;
            if (!place.node.IsSequence()) {
              if (is_scalar(place, legal, report))
                report.problem(place.at, place.path,
                               fmt::format("{} is not {}", shown(place.node), legal));
              return;
            }
            if (place.node.size() > most) {
              report.problem(place.at, place.path,
                             fmt::format("a list of {} is not {}", place.node.size(), legal));
              return;
            }
            for (std::size_t i = 0; i < place.node.size(); ++i) {
              const YAML::Node node = place.node[i];
              const std::string path = fmt::format("{}[{}]", place.path, i);
              report.found(path, node.Mark());
              kind.read({node, node.Mark(), path}, list.emplace_back(), report);
            }
          },
          [=](const std::vector<T>& list) {
            std::vector<std::string> texts;
            for (const T& value : list) texts.push_back(kind.print(value));
            if (texts.empty() || layout == Layout::flow)
              return fmt::format("[{}]", fmt::join(texts, ", "));
            return fmt::format("\n  - {}", fmt::join(texts, "\n  - "));
          }};
}

}  // namespace arcbid::yaml
