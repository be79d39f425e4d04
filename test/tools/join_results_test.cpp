#include "tools/join_results/join_results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame = 100000000;  // ns

/// Frames from one index to another, ten a second, with one joint `x` metres away in each, or lost.
ResultRecord record(int first, int last, const std::function<std::optional<double>(int)>& x) {
  ResultRecord record;
  record.joints.names = {"l_wrist"};
  for (int i = first; i <= last; ++i) {
    ResultFrame frame;
    frame.stamp_ns = i * kFrame;
    frame.status = x(i) ? FrameStatus::kTracked : FrameStatus::kLost;
    record.frames.push_back(frame);
    if (x(i)) record.joints.add(frame.stamp_ns, Eigen::Vector3d(*x(i), 0, 0));
  }
  return record;
}

std::function<std::optional<double>(int)> at(double x) {
  return [x](int) { return x; };
}

std::string refusal(const ResultRecord& earlier, const ResultRecord& later) {
  return errorTextOf<Disagreement>([&] { findSeam(earlier, later, 0.005); });
}

TEST(Seam, LiesBeforeTheEndOfTheEarlierPart) {
  const Seam seam = findSeam(record(1, 60, at(0)), record(40, 90, at(0.004)), 0.005);
  EXPECT_EQ(seam.stamp_ns, 57 * kFrame);
  EXPECT_EQ(seam.frame_sets, 11);
  EXPECT_NEAR(seam.largest_distance_m, 0.004, 1e-12);
}

TEST(Seam, BeginningOfTheLaterPartMayDiffer) {
  const ResultRecord later =
      record(40, 90, [](int i) -> std::optional<double> { return i < 45 ? 0.3 : 0.0; });
  EXPECT_EQ(findSeam(record(1, 60, at(0)), later, 0.005).stamp_ns, 57 * kFrame);
}

TEST(Seam, NobodyInBothPartsIsAgreement) {
  const auto nobody = [](int) { return std::optional<double>(); };
  const Seam seam = findSeam(record(1, 60, nobody), record(40, 90, nobody), 0.005);
  EXPECT_EQ(seam.largest_distance_m, 0.0);
}

TEST(Seam, WhoIsFoundAfterTheEndOfTheEarlierPartMayHaveEarlierPosesInTheLaterOne) {
  const auto leaves = [](int i) -> std::optional<double> {
    return i < 30 ? std::optional<double>(0.0) : std::nullopt;
  };
  const auto comes_again = [&](int i) { return i < 50 ? leaves(i) : 0.0; };
  const Seam seam = findSeam(record(1, 60, leaves), record(20, 90, comes_again), 0.005);
  EXPECT_EQ(seam.stamp_ns, 49 * kFrame);
}

TEST(Seam, DistantJointsAreTold) {
  EXPECT_EQ(refusal(record(1, 60, at(0)), record(40, 90, at(0.006))),
            "0.00 s before the end of their overlap, their joints are 6.0 mm apart");
}

TEST(Seam, OneFrameThatDiffersInTheLastSecondIsEnough) {
  const auto once = [](int i) -> std::optional<double> { return i == 50 ? 0.02 : 0.0; };
  EXPECT_EQ(refusal(record(1, 60, at(0)), record(40, 90, once)),
            "0.70 s before the end of their overlap, their joints are 20.0 mm apart");
}

TEST(Seam, PoseOfOnePartAloneIsTold) {
  const auto lost = [](int) { return std::optional<double>(); };
  EXPECT_EQ(refusal(record(1, 60, at(0)), record(40, 90, lost)),
            "0.00 s before the end of their overlap, only the earlier one has a pose");
}

TEST(Seam, JointsThatNobodyKnowsAreNoAgreement) {
  EXPECT_EQ(refusal(record(1, 60, at(NAN)), record(40, 90, at(0))),
            "0.00 s before the end of their overlap, they have no joint in common");
}

TEST(Seam, ShortOrMissingOverlapIsTold) {
  EXPECT_EQ(refusal(record(1, 60, at(0)), record(52, 90, at(0))),
            "their overlap of 0.50 s is too short");
  EXPECT_EQ(refusal(record(1, 60, at(0)), record(61, 90, at(0))),
            "they have no frame sets in common");
}

}  // namespace
}  // namespace markerless_mocap
