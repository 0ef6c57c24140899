// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/io/config/keys.hpp"

namespace arcbid::yaml {

template <class Owner, class T>
Key<Owner> key(const std::string& name, T Owner::*member, const Kind<T>& kind,
               const std::string& meaning) {
  return {name, kind.legal, meaning,
          [=](const Place& place, Owner& owner, Report& report) {
            kind.read(place, owner.*member, report);
          },
          [=](const Owner& owner) { return kind.print(owner.*member); }};
}

template <class Owner>
Key<Owner> required(Key<Owner> k) {
  k.required = true;
  return k;
}

template <class Owner>
using Keys = std::vector<Key<Owner>>;

/// Adds to `keys` those of a section, which is a member of the owner.
template <class Owner, class Section>
void add_section(Keys<Owner>& keys, const std::string& name, Section Owner::*member,
                 const Keys<Section>& section) {
  for (const Key<Section>& k : section)
    keys.push_back({name + "." + k.name, k.legal, k.meaning,
                    [=](const Place& place, Owner& owner, Report& report) {
                      k.read(place, owner.*member, report);
                    },
                    [=](const Owner& owner) { return k.print(owner.*member); }, k.required,
                    k.is_first});
}

}  // namespace arcbid::yaml
