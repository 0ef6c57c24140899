// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/auction/agent.hpp"
#include "core/route/route.hpp"

namespace arcbid {

/// One call of Agent::step: what the core consumed and what it produced. A log that holds these in
/// their order, after the Birth and the Mission, is all a replay needs.
struct Step {
  Event event;
  Update update;
};

/// Agent's constructor was called.
struct Birth {
  AgentId agent;
  std::uint64_t incarnation = 0;
  TimeNs now_ns = 0;  ///< by the agent's own clock
};

/// A tour was planned for the agreement `view_hash`.
struct PlannedRoute {
  std::uint64_t view_hash = 0;
  Route route;
};

/// Records as bytes: CDR, little-endian, with its encapsulation header, so that tools which speak
/// ROS 2 can read them. Equal records have equal bytes, and the bytes read back to the same bits.
std::string encode(const Step& record);
std::string encode(const Update& record);
std::string encode(const Birth& record);
std::string encode(const PlannedRoute& record);
std::string encode(const Mission& record);
std::string encode(const BidMessage& record);
std::string encode(const RelayMessage& record);
std::string encode(const StatusMessage& record);
std::string encode(const DecisionMade& record);
std::string encode(const Agreement& record);

class StoredSchema;

/// Reads back what encode() wrote; with `stored`, what another build wrote by that schema: by the
/// fields' names, what it does not have by default. Throws InputError, one line without a file's
/// name, for anything else.
template <class Record>
Record decode(std::string_view bytes, const StoredSchema* stored = nullptr);
template <>
Step decode(std::string_view bytes, const StoredSchema* stored);
template <>
Birth decode(std::string_view bytes, const StoredSchema* stored);
template <>
PlannedRoute decode(std::string_view bytes, const StoredSchema* stored);
template <>
Mission decode(std::string_view bytes, const StoredSchema* stored);
template <>
StatusMessage decode(std::string_view bytes, const StoredSchema* stored);
template <>
BidMessage decode(std::string_view bytes, const StoredSchema* stored);

/// The same into a record that is there, whose room is used again: for millions of them.
void decode_into(Step& record, std::string_view bytes, const StoredSchema* stored = nullptr);

/// The definition of a record in ROS 2's message language, those of what it is made of after it.
/// Instances exist for all of the above.
template <class Record>
std::string schema_of();
/// Its name there, without the package.
template <class Record>
std::string_view name_of_record();

/// For people: every field by its name, doubles exact, digests and lives in hexadecimal.
nlohmann::json to_json(const Step& record);
nlohmann::json to_json(const Update& record);
nlohmann::json to_json(const Mission& record);
nlohmann::json to_json(const BidMessage& record);
nlohmann::json to_json(const RelayMessage& record);
nlohmann::json to_json(const StatusMessage& record);

}  // namespace arcbid
