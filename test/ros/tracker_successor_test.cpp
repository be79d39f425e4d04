#include "nodes/pose_fitting/tracker_successor.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace markerless_mocap {
namespace {

/// Finds the person in its third frame set.
class SlowTracker : public BodyTracker {
 public:
  BodyPose update(const TrackerInput&) override { return next(); }
  BodyPose next() {
    BodyPose pose;
    pose.status = ++frames_ < 3 ? PoseStatus::kLost : PoseStatus::kTracked;
    return pose;
  }
  void reset() override {}
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  int frames_ = 0;
  std::shared_ptr<const TrackedBody> body_;
};

BodyPose updated(BodyTracker& tracker) {
  return static_cast<SlowTracker&>(tracker).next();
}

std::unique_ptr<BodyTracker> slowTracker() {
  return std::make_unique<SlowTracker>();
}

std::shared_ptr<const CameraRig> aRig() {
  return std::make_shared<const CameraRig>();
}

/// Looks until there is a result.
std::unique_ptr<BodyTracker> lookUntilFound(TrackerSuccessor* successor,
                                            const std::shared_ptr<const CameraRig>& rig,
                                            const TrackerSuccessor::Make& make) {
  for (int i = 0; i < 3000; ++i) {
    if (auto tracker = successor->look(rig, make, updated)) return tracker;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return nullptr;
}

TEST(TrackerSuccessor, IsHandedOverWhenItHasFoundThePerson) {
  TrackerSuccessor successor;
  const auto rig = aRig();
  EXPECT_EQ(successor.look(rig, slowTracker, updated), nullptr);
  const auto tracker = lookUntilFound(&successor, rig, slowTracker);
  ASSERT_NE(tracker, nullptr);
  EXPECT_EQ(updated(*tracker).status, PoseStatus::kTracked) << "it goes on from there";
}

TEST(TrackerSuccessor, IsMadeOnceForEachRig) {
  TrackerSuccessor successor;
  int made = 0;
  const auto make = [&] {
    ++made;
    return slowTracker();
  };
  const auto first = aRig(), second = aRig();
  successor.look(first, make, updated);
  EXPECT_NE(lookUntilFound(&successor, second, make), nullptr);
  EXPECT_EQ(made, 2);
  successor.look(first, make, updated);
  EXPECT_EQ(successor.takeOf(second), nullptr) << "that of another rig";
  successor.look(second, make, updated);
  EXPECT_NE(successor.takeOf(second), nullptr) << "as far as it is";
  EXPECT_EQ(made, 4);
}

TEST(TrackerSuccessor, WhatFailsIsTriedAgain) {
  TrackerSuccessor successor;
  int calls = 0;
  const auto make = [&]() -> std::unique_ptr<BodyTracker> {
    if (++calls < 3) throw std::invalid_argument("no such rig");
    return slowTracker();
  };
  EXPECT_NE(lookUntilFound(&successor, aRig(), make), nullptr);
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace markerless_mocap
