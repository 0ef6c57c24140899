// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/record/stored_schema.hpp"

#include <gmock/gmock.h>

#include "core/base/error.hpp"
#include "tests/record/other_build.hpp"

namespace arcbid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string problem_of(const std::string& schema) {
  try {
    const StoredSchema stored(schema);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> differences(const std::string& schema) {
  return StoredSchema(schema).differences(StoredSchema(schema_of<Step>()), "Step");
}

TEST(StoredSchema, IsRefusedInOneLineWhereItIsNone) {
  EXPECT_EQ(problem_of(schema_of<Step>()), "");
  EXPECT_THAT(problem_of(""), HasSubstr("no fields"));
  EXPECT_THAT(problem_of("int32 a\nwstring b\n"), HasSubstr("\"wstring\" is not understood"));
  EXPECT_THAT(problem_of("int32\n"), HasSubstr("\"int32\" is not understood"));
  EXPECT_THAT(problem_of("int32 a b\n"), HasSubstr("\"int32 a b\" is not understood"));
  EXPECT_THAT(problem_of(std::string("int32 a\n\0\0\0", 11)), HasSubstr("\"???\""));
  EXPECT_THAT(problem_of("arcbid_msgs/A a\n"), HasSubstr("\"arcbid_msgs/A a\""));
  EXPECT_THAT(problem_of("m/A a\n===\nMSG: m/A\n"), HasSubstr("m/A has no fields"));
  for (const char* type : {"int32[", "int32[0]", "int32[<=]", "int32[x]", "int32[5000000000]"})
    EXPECT_THAT(problem_of(std::string(type) + " a\n"), HasSubstr("not understood")) << type;
}

/// m/A0 holds `each` m/A1, and so on; the last one a number.
std::string nested(int levels, int each) {
  std::string schema = "m/A0 a\n";
  for (int n = 0; n < levels; ++n) {
    schema += fmt::format("===\nMSG: m/A{}\n", n);
    for (int f = 0; f < each; ++f) schema += fmt::format("m/A{} f{}\n", n + 1, f);
  }
  return schema + fmt::format("===\nMSG: m/A{}\nint32 a\n", levels);
}

TEST(StoredSchema, IsNotReadForEver) {
  EXPECT_THAT(problem_of("m/A a\n===\nMSG: m/A\nm/A[] a\n"), HasSubstr("in themselves"));
  EXPECT_THAT(problem_of(nested(100'000, 1)), HasSubstr("nested too deep"));
  EXPECT_EQ(problem_of(nested(25, 20)), "");
}

TEST(StoredSchema, SaysFieldByFieldWhatIsOtherwise) {
  const std::string own = schema_of<Step>();
  EXPECT_THAT(differences(with(own, "Header", "uint64 task_digest", "")),
              ElementsAre("Header.task_digest is not there"));
  EXPECT_THAT(differences(with(own, "Claim", "float64 bid", "float64 bid\nstring note")),
              ElementsAre("Claim.note is not known here"));
  EXPECT_THAT(differences(with(own, "Header", "uint64 sequence", "uint32 sequence")),
              ElementsAre("Header.sequence is uint32, here uint64"));
  EXPECT_THAT(differences(with(own, "Header", "uint64 sequence", "string sequence")),
              ElementsAre("Header.sequence is string, here uint64, and is left out"));
  EXPECT_THAT(differences(with(with(own, "Claim", "uint32 task", ""), "Claim", "float64 bid",
                               "float64 bid\nuint32 task")),
              ElementsAre("Claim has its fields in another order"));
  EXPECT_THAT(differences(with(own, "", "arcbid_msgs/Update update", "")),
              ElementsAre("Step.update is not there"));
}

/// Laid out by hand: nothing that writes records had a part in it.
TEST(NamedReader, FillsWhatItKnowsByName) {
  const StoredSchema schema(
      "int64 now_ns\nm/Extra[] extra\nuint16 agent\nstring[2] words\n"
      "====\nMSG: m/Extra\nuint8 a\nfloat64 b\n");
  std::string room(200, '\0');
  eprosima::fastcdr::FastBuffer buffer(room.data(), room.size());
  eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS,
                             eprosima::fastcdr::Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  cdr << std::int64_t{-5} << std::uint32_t{2} << std::uint8_t{1} << 0.5 << std::uint8_t{2} << 1.5;
  cdr << std::uint16_t{300} << std::string("one") << std::string("two");
  const std::string bytes = room.substr(0, cdr.getSerializedDataLength());
  const Birth birth = decode<Birth>(bytes, &schema);
  EXPECT_EQ(birth.now_ns, -5);
  EXPECT_EQ(birth.agent, AgentId{300});
  EXPECT_EQ(birth.incarnation, 0u) << "which is not there";
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_THROW(decode<Birth>(bytes.substr(0, n), &schema), InputError) << n;
}

Step with_a_status() {
  Step step;
  StatusMessage status;
  status.header = {{3}, 1'700'000'000'003, 300, ~std::uint64_t{0}, 12};
  status.phase = Phase::routed;
  status.view_hash = 77;
  status.ready = {{1}, {2}};
  status.heartbeats = {{{2}, {5, 6}}};
  step.event = {-5, status};
  step.update.decision = DecisionMade{3, true, {99, true, 3}, Claims{{{{4}, -0.1}}}, {{{4}, true}}};
  step.update.agreed = Agreement{8, 9, {{1}}, {{AgentId{1}, -0.5}, {}}, {{{4}, true}}, {}, {}};
  step.update.refused = "why not";
  step.update.wake_ns = -7;
  return step;
}

Step read_by(const std::string& schema, const Step& step = with_a_status()) {
  const StoredSchema stored(schema);
  return decode<Step>(OtherBuild::encode(step, stored), &stored);
}

TEST(NamedReader, IsTheUsualReaderWhereTheSchemaIsThisBuilds) {
  const StoredSchema own(schema_of<Step>());
  const std::string bytes = encode(with_a_status());
  EXPECT_EQ(OtherBuild::encode(with_a_status(), own), bytes);
  EXPECT_EQ(encode(decode<Step>(bytes, &own)), bytes);
}

TEST(NamedReader, LeavesOutWhatIsNotThereAndPassesOverWhatIsNotKnown) {
  std::string schema = with(schema_of<Step>(), "Update", "int64 wake_ns", "");
  schema = with(schema, "Claim", "uint32 task", "arcbid_msgs/Held[<=2] held\nuint32 task\nbool b");
  schema = with(schema, "StatusMessage", "arcbid_msgs/Header header",
                "string[3] words\narcbid_msgs/Header header\nint8[] bytes");
  Step expected = with_a_status();
  expected.update.wake_ns = 0;
  EXPECT_EQ(encode(read_by(schema)), encode(expected));
}

TEST(NamedReader, ConvertsNumbersAndGoesByNoOrder) {
  std::string schema = with(schema_of<Step>(), "Header", "uint64 sequence", "int16 sequence");
  schema = with(schema, "Heartbeat", "uint64 counter", "uint8 counter");
  schema = with(schema, "Belief", "float64 bid", "");
  schema = with(schema, "Belief", "int64 winner", "float32 bid\nint8 winner");
  schema = with(schema, "StatusMessage", "uint8 phase", "int64 phase");
  schema = with(schema, "", "arcbid_msgs/Event event", "");
  schema = with(schema, "", "arcbid_msgs/Update update",
                "arcbid_msgs/Update update\narcbid_msgs/Event event");
  EXPECT_EQ(encode(read_by(schema)), encode(with_a_status()));
}

TEST(NamedReader, LeavesAFieldOfAnotherKindAloneAndReadsTheRest) {
  std::string schema =
      with(schema_of<Step>(), "StatusMessage", "uint64 view_hash", "string view_hash");
  schema = with(schema, "StatusMessage", "uint32[] ready", "string[] ready");
  schema = with(schema, "Update", "string[<=1] refused", "float64[<=1] refused");
  Step expected = with_a_status();
  auto& status = std::get<StatusMessage>(expected.event.what);
  status.view_hash = 0;
  status.ready.clear();
  expected.update.refused.reset();
  EXPECT_EQ(encode(read_by(schema)), encode(expected));
}

TEST(NamedReader, RefusesWhatCannotBeKept) {
  const auto problem = [](const std::string& schema, const Step& step) -> std::string {
    try {
      read_by(schema, step);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  Step step = with_a_status();
  std::get<StatusMessage>(step.event.what).phase = static_cast<Phase>(9);
  EXPECT_THAT(problem(with(schema_of<Step>(), "StatusMessage", "uint8 phase", "int32 phase"), step),
              HasSubstr("field phase: 9, legal: 0 to 4"));
  step = with_a_status();
  step.update.wake_ns = 0;
  step.event.now_ns = -1;
  EXPECT_EQ(problem(with(schema_of<Step>(), "Event", "int64 now_ns", "int32 now_ns"), step), "");
  std::get<StatusMessage>(step.event.what).round = ~std::uint32_t{0};
  EXPECT_THAT(problem(with(schema_of<Step>(), "StatusMessage", "uint32 round", "int8 round"), step),
              HasSubstr("field round: -1, legal: 0 to 4294967295"));
  // An event of a kind that came and went.
  const std::string other =
      with(schema_of<Step>(), "Event", "arcbid_msgs/StatusMessage[<=1] status",
           "arcbid_msgs/StatusMessage[<=1] gossip");
  EXPECT_THAT(problem(other, step), HasSubstr("Event: 0 alternatives of a choice"));
}

TEST(NamedReader, MakesUpNoKindWhereAllHaveOtherNames) {
  std::string schema = schema_of<Step>();
  for (const auto& [type, name] : {std::pair{"Tick", "tick"},
                                   {"BidMessage", "bid"},
                                   {"RelayMessage", "relay"},
                                   {"StatusMessage", "status"},
                                   {"RoutePublished", "route_published"}})
    schema = with(schema, "Event", fmt::format("arcbid_msgs/{}[<=1] {}", type, name),
                  fmt::format("arcbid_msgs/{}[<=1] old_{}", type, name));
  try {
    read_by(schema);
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("Event: 0 alternatives of a choice that are known here"));
  }
}

TEST(NamedReader, LeavesAPlaceThatIsNotThereAtTheOrigin) {
  Mission mission;
  mission.arcs = {{{0}, ArcKind::outline, {{{1, 2, 3}, {0, 0, 1}}, {{4, 5, 6}, {0, 0, 1}}}}};
  const StoredSchema stored(with(schema_of<Mission>(), "Waypoint", "float64[3] look", ""));
  const Mission read = decode<Mission>(OtherBuild::encode(mission, stored), &stored);
  for (const Waypoint& waypoint : read.arcs[0].waypoints) EXPECT_EQ(waypoint.look, Vec3::Zero());
  EXPECT_EQ(read.arcs[0].waypoints[1].position_m, mission.arcs[0].waypoints[1].position_m);
}

TEST(NamedReader, SurvivesEveryTruncationAndEveryChangedByte) {
  const std::string text =
      with(with(schema_of<Step>(), "Claim", "float64 bid", "float32 bid\nstring[] notes"), "Header",
           "uint64 sequence", "uint16 sequence");
  const StoredSchema schema(text);
  const std::string bytes = OtherBuild::encode(with_a_status(), schema);
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_THROW(decode<Step>(std::string_view(bytes).substr(0, n), &schema), InputError) << n;
  for (std::size_t n = 0; n < bytes.size(); ++n)
    for (const char bit : {'\x01', '\x80'}) {
      std::string damaged = bytes;
      damaged[n] = static_cast<char>(damaged[n] ^ bit);
      try {
        decode<Step>(damaged, &schema);
      } catch (const InputError&) {
      }
    }
}

/// What it was left with by the record before is gone.
TEST(NamedReader, ReadsIntoARecordThatIsThere) {
  const StoredSchema schema(with(schema_of<Step>(), "Update", "int64 wake_ns", ""));
  Step step = with_a_status();
  decode_into(step, OtherBuild::encode(Step{{1, Tick{2}}, {}}, schema), &schema);
  EXPECT_EQ(encode(step), encode(Step{{1, Tick{2}}, {}}));
}

}  // namespace
}  // namespace arcbid::testing
