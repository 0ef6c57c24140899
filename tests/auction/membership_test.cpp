// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auction/membership.hpp"

#include <gtest/gtest.h>

namespace arcbid::testing {
namespace {

constexpr TimeNs lease = 100, born = 1000;
constexpr std::size_t self = 1, other = 2;

TEST(Membership, GivesEverybodyALeaseFromTheBeginning) {
  const Membership membership(3, self, born);
  EXPECT_FALSE(membership.silent(other, born + lease, lease));
  EXPECT_TRUE(membership.silent(other, born + lease + 1, lease));
}

TEST(Membership, NeverCountsItselfAsSilent) {
  const Membership membership(3, self, born);
  EXPECT_FALSE(membership.silent(self, born + 1000 * lease, lease));
  EXPECT_GT(membership.deadline(self, lease), born + 1000 * lease);
}

TEST(Membership, NamesTheFirstMomentOfSilence) {
  Membership membership(3, self, born);
  membership.heard(other, {5, 1}, born + 30);
  const TimeNs deadline = membership.deadline(other, lease);
  EXPECT_FALSE(membership.silent(other, deadline - 1, lease));
  EXPECT_TRUE(membership.silent(other, deadline, lease));
}

TEST(Membership, RenewsTheLeaseOnlyForALaterHeartbeat) {
  Membership membership(3, self, born);
  membership.heard(other, {5, 7}, born + 10);
  membership.heard(other, {5, 7}, born + 90);   // the same, relayed late
  membership.heard(other, {5, 6}, born + 90);   // an older one
  membership.heard(other, {4, 99}, born + 90);  // of an earlier life
  EXPECT_TRUE(membership.silent(other, born + 111, lease));
  membership.heard(other, {5, 8}, born + 95);
  EXPECT_FALSE(membership.silent(other, born + 195, lease));
}

TEST(Membership, CountsANewLifeFromItsFirstHeartbeat) {
  Membership membership(3, self, born);
  membership.heard(other, {5, 700}, born);
  membership.heard(other, {6, 1}, born + 90);
  EXPECT_FALSE(membership.silent(other, born + 190, lease));
  EXPECT_EQ(membership.heartbeats()[other], (Heartbeat{6, 1}));
}

TEST(Membership, RestartsAllLeasesWithoutForgettingHeartbeats) {
  Membership membership(3, self, born);
  membership.heard(other, {5, 7}, born);
  membership.restart_leases(born + 500);
  EXPECT_FALSE(membership.silent(0, born + 600, lease));
  EXPECT_FALSE(membership.silent(other, born + 600, lease));
  EXPECT_TRUE(membership.silent(other, born + 601, lease));
  EXPECT_EQ(membership.heartbeats()[other], (Heartbeat{5, 7}));
}

}  // namespace
}  // namespace arcbid::testing
