// SPDX-License-Identifier: GPL-3.0-or-later
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>

#include "core/io/config/keys.hpp"

namespace arcbid::yaml {
namespace {

/// The words that may stand in `section` ("" or "fleet."), in the order of the table.
template <class Owner>
std::vector<std::string> words_of(const std::string& section, const std::vector<Key<Owner>>& keys) {
  std::vector<std::string> words;
  for (const Key<Owner>& k : keys) {
    if (!k.name.starts_with(section)) continue;
    const std::string word =
        k.name.substr(section.size(), k.name.find('.', section.size()) - section.size());
    if (words.empty() || words.back() != word) words.push_back(word);
  }
  return words;
}

/// What an unknown word might have meant: a neighbour misspelt, a key of another section, or any.
template <class Owner>
std::string hint(const std::string& word, const std::string& section,
                 const std::vector<Key<Owner>>& keys) {
  const std::vector<std::string> words = words_of(section, keys);
  if (const std::string near = did_you_mean(word, words); !near.empty()) return near;
  for (const Key<Owner>& k : keys)
    if (k.name.ends_with("." + word)) return fmt::format("; did you mean {}?", k.name);
  return fmt::format("; legal: {}", fmt::join(words, ", "));
}

/// The entries of a mapping as they stand, those first that set what the others change. Copied
/// only: to assign to a node changes the file's.
template <class Owner>
std::vector<std::pair<YAML::Node, YAML::Node>> in_order(const YAML::Node& mapping,
                                                        const std::string& section,
                                                        const std::vector<Key<Owner>>& keys) {
  const auto is_first = [&](const YAML::Node& word) {
    return std::any_of(keys.begin(), keys.end(), [&](const Key<Owner>& k) {
      return k.is_first && word.IsScalar() && k.name == section + word.Scalar();
    });
  };
  std::vector<std::pair<YAML::Node, YAML::Node>> entries;
  for (const bool first : {true, false})
    for (const auto& entry : mapping)
      if (is_first(entry.first) == first) entries.emplace_back(entry.first, entry.second);
  return entries;
}

template <class Owner>
void read_section(const Place& place, const std::string& section,
                  const std::vector<Key<Owner>>& keys, Owner& owner, Report& report) {
  if (place.node.IsNull()) return;  // a section whose keys are all commented out
  if (!place.node.IsMap()) {
    const std::string given = place.node.IsScalar() ? shown(place.node) : "a list";
    report.problem(place.at, place.path, given + " is not a mapping (lines of `key: value`)");
    return;
  }
  std::map<std::string, int> first_line;
  for (const auto& entry : in_order(place.node, section, keys)) {
    const YAML::Mark at = entry.first.Mark();
    if (!entry.first.IsScalar()) {
      report.problem(at, place.path, "a key must be a word");
      continue;
    }
    const std::string word = entry.first.Scalar();
    const std::string path = place.path.empty() ? word : place.path + "." + word;
    const auto [first, is_new] = first_line.emplace(word, at.line + 1);
    if (!is_new) {
      report.problem(at, path, fmt::format("given twice; first in line {}", first->second));
      continue;
    }
    const Place value{entry.second, entry.second.IsNull() ? at : entry.second.Mark(), path};
    const std::string name = section + word;
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const Key<Owner>& k) { return k.name == name; });
    const bool is_section = std::any_of(keys.begin(), keys.end(), [&](const Key<Owner>& k) {
      return k.name.starts_with(name + ".");
    });
    if (found != keys.end()) {
      report.found(path, value.at);
      found->read(value, owner, report);
    } else if (is_section) {
      report.found(path, value.at);
      read_section(value, name + ".", keys, owner, report);
    } else {
      report.problem(at, path, "unknown key" + hint(word, section, keys));
    }
  }
}

}  // namespace

template <class Owner>
void read_mapping(const Place& place, const std::vector<Key<Owner>>& keys, Owner& owner,
                  Report& report) {
  read_section(place, "", keys, owner, report);
  for (const Key<Owner>& k : keys)
    if (const std::string path = place.path + "." + k.name; k.required && !report.has(path))
      report.problem(place.at, path, "missing; legal: " + k.legal);
}

template void read_mapping(const Place&, const std::vector<Key<Config>>&, Config&, Report&);
template void read_mapping(const Place&, const std::vector<Key<Uav>>&, Uav&, Report&);

}  // namespace arcbid::yaml
