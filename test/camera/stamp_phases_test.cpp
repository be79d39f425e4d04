#include "markerless_mocap/camera/stamp_phases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "markerless_mocap/camera/frame_set_assembler.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kMs = 1000000;

using Assembler = FrameSetAssembler<int>;
using FrameSets = std::vector<Assembler::FrameSet>;

AssemblerOptions optionsWith(OutOfStep rule) {
  AssemblerOptions options;
  options.min_streams = 1;
  options.out_of_step = rule;
  return options;
}

struct Arrival {
  int64_t stamp_ns;
  size_t stream;
};

/// \param phases_ms, intervals_ms by stream
std::vector<Arrival> arrivals(const std::vector<double>& phases_ms,
                              const std::vector<double>& intervals_ms, int images) {
  std::vector<Arrival> out;
  for (size_t i = 0; i < phases_ms.size(); ++i)
    for (int k = 0; k < images; ++k)
      out.push_back({std::llround(kMs * (1000.0 + phases_ms[i] + k * intervals_ms[i])), i});
  std::stable_sort(out.begin(), out.end(),
                   [](const Arrival& a, const Arrival& b) { return a.stamp_ns < b.stamp_ns; });
  return out;
}

std::vector<Arrival> arrivals(const std::vector<double>& phases_ms, int images) {
  return arrivals(phases_ms, std::vector<double>(phases_ms.size(), 40.0), images);
}

FrameSets joinedBy(Assembler& assembler, const std::vector<Arrival>& all) {
  FrameSets out;
  for (const Arrival& arrival : all)
    for (auto& frame_set : assembler.add(arrival.stream, arrival.stamp_ns, 1))
      out.push_back(std::move(frame_set));
  return out;
}

bool isComplete(const Assembler::FrameSet& frame_set) {
  return std::count(frame_set.present.begin(), frame_set.present.end(), false) == 0;
}

size_t countComplete(const FrameSets& sets) {
  return size_t(std::count_if(sets.begin(), sets.end(), isComplete));
}

double spanMs(const Assembler::FrameSet& frame_set) {
  const auto [low, high] =
      std::minmax_element(frame_set.stamps_ns.begin(), frame_set.stamps_ns.end());
  return double(*high - *low) / double(kMs);
}

// 30 of 40 ms hold all stamps; half of the other 10 is the margin.
TEST(StampPhases, ToleranceIsThePartWithAllStampsAndHalfOfTheRest) {
  StampPhases phases(4, OutOfStep::kJoin, 5 * kMs);
  for (const Arrival& a : arrivals({0, 10, 20, 30}, 12)) phases.add(a.stream, a.stamp_ns);
  EXPECT_NEAR(double(phases.tolerance_ns()), 35.0 * kMs, 0.01 * kMs);
  phases.reset();
  EXPECT_EQ(phases.tolerance_ns(), 5 * kMs);
}

TEST(StampPhases, FramesThatAreMissingAndScatterChangeNothing) {
  StampPhases phases(3, OutOfStep::kJoin, 5 * kMs);
  int k = 0;
  for (const Arrival& a : arrivals({0, 10, 25}, 20)) {
    if (++k % 7 == 0) continue;
    phases.add(a.stream, a.stamp_ns + (k % 3 - 1) * kMs);
  }
  EXPECT_NEAR(double(phases.tolerance_ns()), 32.5 * kMs, 1.5 * kMs);
}

TEST(StampPhases, StreamsOfDifferentRatesAreNotJudged) {
  StampPhases phases(2, OutOfStep::kJoin, 5 * kMs);
  for (const Arrival& a : arrivals({0, 10}, {40, 25}, 12)) phases.add(a.stream, a.stamp_ns);
  EXPECT_EQ(phases.tolerance_ns(), 5 * kMs);
}

TEST(FrameSetAssemblerOutOfStep, CamerasThatRunFreelyAreJoined) {
  Assembler assembler(4, optionsWith(OutOfStep::kJoinIfNever));
  const FrameSets sets = joinedBy(assembler, arrivals({3, 13, 24, 30}, 100));
  EXPECT_GE(countComplete(sets), 89u);
  EXPECT_TRUE(isComplete(sets.back()));
}

// The longest pause divides one frame set from the next, whoever sent first.
TEST(FrameSetAssemblerOutOfStep, FrameSetsAreAsShortAsTheyCanBe) {
  Assembler assembler(3, optionsWith(OutOfStep::kJoinIfNever));
  const FrameSets sets = joinedBy(assembler, arrivals({0, 8, 34}, 100));
  EXPECT_GE(countComplete(sets), 88u);
  for (const auto& frame_set : sets)
    if (isComplete(frame_set)) {
      EXPECT_NEAR(spanMs(frame_set), 14.0, 0.01);
    }
}

TEST(FrameSetAssemblerOutOfStep, NothingIsLostIfTheFirstStampsAreForeseen) {
  Assembler assembler(4, optionsWith(OutOfStep::kJoin));
  const auto all = arrivals({0, 10, 20, 30}, 50);
  for (size_t i = 0; i < 40; ++i) assembler.foresee(all[i].stream, all[i].stamp_ns);
  EXPECT_EQ(countComplete(joinedBy(assembler, all)), 50u);
  EXPECT_THROW(assembler.foresee(4, 0), std::invalid_argument);
}

TEST(FrameSetAssemblerOutOfStep, OneAmongManyInStepHasWrongStampsAndIsLeftOut) {
  const auto all = arrivals({0, 1, 17, 2}, 60);
  Assembler assembler(4, optionsWith(OutOfStep::kJoinIfNever));
  for (const auto& frame_set : joinedBy(assembler, all))
    EXPECT_NE(frame_set.present[0], frame_set.present[2]);
  Assembler believing(4, optionsWith(OutOfStep::kJoin));
  EXPECT_GE(countComplete(joinedBy(believing, all)), 48u);
}

TEST(FrameSetAssemblerOutOfStep, CamerasThatWereInStepHaveWrongStampsLater) {
  Assembler assembler(4, optionsWith(OutOfStep::kJoinIfNever));
  EXPECT_EQ(countComplete(joinedBy(assembler, arrivals({0, 1, 2, 3}, 60))), 60u);
  auto later = arrivals({0, 10, 20, 30}, 60);
  for (Arrival& arrival : later) arrival.stamp_ns += 60 * 40 * kMs;
  EXPECT_EQ(countComplete(joinedBy(assembler, later)), 0u);
}

// In 40 s one has sent an image more than the other, and they have been in step and out of it.
TEST(FrameSetAssemblerOutOfStep, CamerasWhoseRatesDifferALittleAreJoinedThroughout) {
  Assembler assembler(2, optionsWith(OutOfStep::kJoin));
  const FrameSets sets = joinedBy(assembler, arrivals({1, 9}, {40.0, 40.04}, 1000));
  EXPECT_GE(countComplete(sets), 985u);
  for (const auto& frame_set : sets)
    if (isComplete(frame_set)) {
      EXPECT_LT(spanMs(frame_set), 31.0);
    }
}

// Offsets of clocks mean that clocks may drift, which is followed only where cameras are in step.
TEST(FrameSetAssemblerOutOfStep, OffsetsDoNotMakeCamerasThatRunFreelySimultaneous) {
  AssemblerOptions options = optionsWith(OutOfStep::kJoinIfNever);
  options.offsets = {0.0, 0.02, 0.0};
  options.max_drift = 0.1;
  Assembler assembler(3, options);
  const FrameSets sets = joinedBy(assembler, arrivals({0, 28, 22}, 300));  // 0, 8, 22 with offsets
  EXPECT_GE(countComplete(sets), 290u);
  EXPECT_NEAR(spanMs(sets.back()), 22.0, 0.01);
}

// At 5 images per second frame sets of cameras out of step last longer than the deadline.
TEST(FrameSetAssemblerOutOfStep, SlowCamerasAreWaitedFor) {
  Assembler assembler(3, optionsWith(OutOfStep::kJoin));
  const FrameSets sets = joinedBy(assembler, arrivals({0, 60, 130}, {200, 200, 200}, 50));
  EXPECT_GE(countComplete(sets), 39u);
}

}  // namespace
}  // namespace markerless_mocap
