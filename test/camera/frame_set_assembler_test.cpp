#include "markerless_mocap/camera/frame_set_assembler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "camera/timing_remarks.h"

namespace markerless_mocap {
namespace {

using Assembler = FrameSetAssembler<int>;
using Instants = std::vector<Assembler::FrameSet>;

constexpr int64_t kMs = 1000000;
constexpr int64_t kSecond = 1000 * kMs;

/// Deadline 100 ms, tolerance 5 ms, jump 5 s, at least 2 streams.
Assembler makeAssembler(size_t streams) {
  return Assembler(streams, AssemblerOptions());
}

TEST(FrameSetAssembler, GivesOutWhenTheLastStreamArrives) {
  Assembler assembler = makeAssembler(3);
  EXPECT_TRUE(assembler.add(0, 1 * kSecond, 10).empty());
  EXPECT_TRUE(assembler.add(2, 1 * kSecond + 4 * kMs, 12).empty());
  const Instants out = assembler.add(1, 1 * kSecond - 4 * kMs, 11);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].stamp_ns, 1 * kSecond);
  EXPECT_EQ(out[0].items, (std::vector<int>{10, 11, 12}));
  EXPECT_EQ(assembler.counts().complete, 1u);
}

TEST(FrameSetAssembler, StampsFurtherApartThanToleranceAreTwoInstants) {
  Assembler assembler = makeAssembler(2);
  assembler.add(0, 0, 1);
  EXPECT_TRUE(assembler.add(1, 6 * kMs, 2).empty());
  EXPECT_EQ(assembler.add(1, 5 * kMs, 3).size(), 0u) << "nearest frame set is the one at 6 ms";
  EXPECT_EQ(assembler.counts().duplicate, 1u);
}

TEST(FrameSetAssembler, MissingStreamIsLeftOutAfterTheDeadline) {
  Assembler assembler = makeAssembler(3);
  assembler.add(0, 0, 1);
  assembler.add(1, 0, 2);
  EXPECT_TRUE(assembler.add(0, 100 * kMs, 3).empty()) << "at the deadline it still waits";
  const Instants out = assembler.add(0, 133 * kMs, 4);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].present, (std::vector<bool>{true, true, false}));
  EXPECT_EQ(assembler.counts().incomplete, 1u);
}

TEST(FrameSetAssembler, TooFewStreamsAreAbandoned) {
  Assembler assembler = makeAssembler(3);
  assembler.add(0, 0, 1);
  EXPECT_TRUE(assembler.add(0, 200 * kMs, 2).empty());
  EXPECT_EQ(assembler.counts().abandoned, 1u);
}

TEST(FrameSetAssembler, CompleteInstantClosesOlderOnesInOrder) {
  Assembler assembler = makeAssembler(3);
  assembler.add(0, 0, 1);
  assembler.add(1, 0, 2);
  assembler.add(0, 33 * kMs, 3);
  assembler.add(1, 33 * kMs, 4);
  const Instants out = assembler.add(2, 33 * kMs, 5);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].stamp_ns, 0);
  EXPECT_EQ(out[1].stamp_ns, 33 * kMs);
}

TEST(FrameSetAssembler, StampIsTheMeanOfTheItems) {
  AssemblerOptions options;
  options.tolerance = 0.017;
  Assembler assembler(3, options);
  // Cameras that take turns.
  for (int64_t k = 0; k < 5; ++k) {
    assembler.add(0, k * 33 * kMs, 1);
    assembler.add(1, (33 * k + 11) * kMs, 2);
    const Instants out = assembler.add(2, (33 * k - 5) * kMs, 3);
    ASSERT_EQ(out.size(), 1u) << k;
    EXPECT_EQ(out[0].stamp_ns, (33 * k + 2) * kMs);
    EXPECT_EQ(out[0].stamps_ns[1], (33 * k + 11) * kMs);
  }
  // One of them is missing.
  assembler.add(0, 200 * kMs, 1);
  assembler.add(1, 210 * kMs, 2);
  EXPECT_EQ(assembler.flush().back().stamp_ns, 205 * kMs);
}

TEST(FrameSetAssembler, StampsRiseThoughItemsAreMissing) {
  AssemblerOptions options;
  options.tolerance = 0.01;
  Assembler assembler(8, options);
  assembler.add(0, 10 * kMs, 1);
  for (const size_t stream : {1, 2, 3}) assembler.add(stream, 20 * kMs, 1);
  assembler.add(4, 21 * kMs, 2);
  for (const size_t stream : {5, 6, 7}) assembler.add(stream, 16 * kMs, 2);
  const Instants out = assembler.flush();
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].stamp_ns, 17'500'000);
  EXPECT_EQ(out[1].stamp_ns, 17'500'001);  // their mean is 17.25 ms
}

TEST(FrameSetAssembler, LateAndRepeatedItemsAreCountedAndDropped) {
  Assembler assembler = makeAssembler(3);
  assembler.add(0, 100 * kMs, 1);
  EXPECT_TRUE(assembler.add(0, 100 * kMs, 9).empty());
  assembler.add(1, 100 * kMs, 2);
  EXPECT_EQ(assembler.add(2, 100 * kMs, 3)[0].items[0], 1);
  EXPECT_TRUE(assembler.add(2, 101 * kMs, 9).empty());
  EXPECT_EQ(assembler.counts().duplicate, 2u) << "before and after it was given out";
  EXPECT_TRUE(assembler.add(2, 67 * kMs, 9).empty());
  EXPECT_EQ(assembler.counts().late, 1u);
  EXPECT_TRUE(assembler.flush().empty());
}

TEST(FrameSetAssembler, FarFutureStampIsDropped) {
  Assembler assembler = makeAssembler(2);
  assembler.add(0, 0, 1);
  EXPECT_TRUE(assembler.add(1, 3600 * kSecond, 9).empty());
  EXPECT_EQ(assembler.counts().far_future, 1u);
  EXPECT_EQ(assembler.add(1, 0, 2).size(), 1u);
}

TEST(FrameSetAssembler, OneStreamWithAWrongClockIsOutvoted) {
  Assembler assembler = makeAssembler(3);
  for (int frame = 0; frame < 20; ++frame) {
    const int64_t stamp = frame * 33 * kMs;
    assembler.add(2, stamp + 3600 * kSecond, 9);
    assembler.add(0, stamp, 1);
    assembler.add(1, stamp, 2);
  }
  EXPECT_EQ(assembler.counts().time_jumps_back, 1u) << "its first item set the time";
  EXPECT_EQ(assembler.counts().far_future, 18u) << "from the third frame on";
  EXPECT_EQ(assembler.counts().incomplete, 16u) << "frames 0 to 15 are past the deadline";
}

/// Plays `frames` complete frames at 30 Hz from `start_ns`; returns the number of frame sets.
size_t play(Assembler* assembler, size_t streams, int64_t start_ns, int frames) {
  size_t given = 0;
  for (int frame = 0; frame < frames; ++frame)
    for (size_t s = 0; s < streams; ++s)
      given += assembler->add(s, start_ns + frame * 33 * kMs, frame).size();
  return given;
}

TEST(FrameSetAssembler, RunOfFarFutureStampsIsARealJump) {
  Assembler assembler = makeAssembler(3);
  EXPECT_EQ(play(&assembler, 3, 0, 5), 5u);
  EXPECT_EQ(play(&assembler, 3, 3600 * kSecond, 5), 5u) << "nothing of the new time is lost";
  EXPECT_EQ(assembler.counts().complete, 10u);
  EXPECT_EQ(assembler.counts().time_jumps_back, 0u);
}

TEST(FrameSetAssembler, LoopingRecordingStartsAnew) {
  Assembler assembler = makeAssembler(4);
  for (int loop = 0; loop < 3; ++loop) {
    EXPECT_EQ(play(&assembler, 4, 10 * kSecond, 30), 30u) << "loop " << loop;
    EXPECT_EQ(assembler.counts().time_jumps_back, uint64_t(loop));
  }
}

TEST(FrameSetAssembler, BurstOfOneSlowStreamIsNoJump) {
  Assembler assembler = makeAssembler(2);
  play(&assembler, 2, 10 * kSecond, 30);
  for (int i = 0; i < 10; ++i) assembler.add(1, 10 * kSecond + i * 33 * kMs, 9);
  EXPECT_EQ(assembler.counts().time_jumps_back, 0u);
  EXPECT_EQ(assembler.counts().late, 10u);
}

// Each item is a frame set of its own, and more of them wait than the queue holds before the
// deadline: whoever reads them must be able to tell what lacks.
TEST(FrameSetAssembler, StreamsThatAreNotInStepStillGiveFrameSets) {
  AssemblerOptions options;
  options.min_streams = 1;
  options.deadline = 0.5;
  Assembler assembler(4, options);
  size_t lone = 0;
  for (int frame = 0; frame < 15; ++frame)
    for (int stream = 0; stream < 4; ++stream)
      for (const auto& frame_set : assembler.add(stream, (66 * frame + 16 * stream) * kMs, 1))
        lone += std::count(frame_set.present.begin(), frame_set.present.end(), true) == 1;
  EXPECT_EQ(lone, size_t(4 * 15 - options.max_pending));
}

TEST(FrameSetAssembler, QueueIsBounded) {
  AssemblerOptions options;
  options.max_pending = 2;
  Assembler assembler(3, options);
  for (int i = 0; i < 4; ++i) assembler.add(0, i * 10 * kMs, i);
  EXPECT_EQ(assembler.counts().overflow, 2u);
  assembler.add(1, 20 * kMs, 5);
  EXPECT_EQ(assembler.add(2, 20 * kMs, 6).size(), 1u) << "the newest are kept";
}

TEST(FrameSetAssembler, FlushGivesOutWhatHasEnoughStreams) {
  Assembler assembler = makeAssembler(3);
  assembler.add(0, 0, 1);
  assembler.add(0, 33 * kMs, 2);
  assembler.add(1, 33 * kMs, 3);
  const Instants out = assembler.flush();
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].stamp_ns, 33 * kMs);
}

TEST(FrameSetAssembler, ResetForgetsTimeAndCounts) {
  Assembler assembler = makeAssembler(2);
  play(&assembler, 2, 10 * kSecond, 2);
  assembler.reset();
  EXPECT_EQ(assembler.counts().complete, 0u);
  EXPECT_EQ(play(&assembler, 2, 0, 2), 2u);
}

TEST(FrameSetAssembler, BadInputIsRefused) {
  Assembler assembler = makeAssembler(2);
  EXPECT_THROW(assembler.add(2, 0, 1), std::invalid_argument);
  EXPECT_THROW(makeAssembler(1), std::invalid_argument) << "min_streams is 2";
  AssemblerOptions options;
  options.deadline = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Assembler(2, options), std::invalid_argument);
}

AssemblerOptions withOffsets(std::vector<double> offsets, double max_drift = 0.0) {
  AssemblerOptions options;
  options.offsets = std::move(offsets);
  options.max_drift = max_drift;
  return options;
}

TEST(FrameSetAssembler, OffsetsAreAddedToTheStampsOfTheirStream) {
  Assembler assembler(2, withOffsets({0.0, -0.25}));
  assembler.add(0, kSecond, 1);
  const Instants out = assembler.add(1, kSecond + 252 * kMs, 2);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].stamp_ns, kSecond + kMs);
  EXPECT_EQ(out[0].stamps_ns, (std::vector<int64_t>{kSecond, kSecond + 2 * kMs}));
  EXPECT_EQ(out[0].items, (std::vector<int>{1, 2}));
  EXPECT_TRUE(assembler.add(1, 2 * kSecond, 3).empty());
  EXPECT_EQ(assembler.add(0, 2 * kSecond - 250 * kMs, 4)[0].stamp_ns, 2 * kSecond - 250 * kMs);
}

/// Frame sets with all streams of 3600 at 30 per second, of which the last drifts by 300 ppm: 36 ms
/// in the end.
uint64_t completeWithDrift(Assembler* assembler) {
  for (int k = 0; k < 3600; ++k) {
    const int64_t stamp = kSecond + k * (kSecond / 30);
    assembler->add(0, stamp, k);
    assembler->add(1, stamp + kMs, k);
    assembler->add(2, stamp + int64_t(3e-4 * double(k) / 30.0 * 1e9), k);
  }
  return assembler->counts().complete;
}

TEST(FrameSetAssembler, DriftIsFollowedAndSaid) {
  Assembler following(3, withOffsets({}, 0.1)), rigid(3, withOffsets({}));
  EXPECT_EQ(completeWithDrift(&following), 3600u);
  EXPECT_NEAR(following.timing(2).lag, 0.036, 0.003);
  EXPECT_EQ(following.timing(2).left_out, 0u);
  EXPECT_LT(completeWithDrift(&rigid), 1300u);  // 500, and 670 that meet the next frames
}

TEST(FrameSetAssembler, DriftIsFollowedNoFurtherThanAllowed) {
  Assembler assembler(3, withOffsets({}, 0.01));
  const uint64_t complete = completeWithDrift(&assembler);
  EXPECT_GT(complete, 1500u);  // 10 ms and the tolerance behind stream 1 are reached after 1600
  EXPECT_LT(complete, 1650u);
  EXPECT_GT(assembler.timing(2).left_out, 1000u);
}

TEST(FrameSetAssembler, AStreamThatLagsIsMeasuredAndOneThatIsLeftOutIsTold) {
  Assembler assembler = makeAssembler(4);
  for (int k = 0; k < 200; ++k) {
    const int64_t stamp = kSecond + k * (kSecond / 10);
    assembler.add(0, stamp, k);
    assembler.add(1, stamp, k);
    assembler.add(2, stamp + 4 * kMs, k);
    assembler.add(3, stamp + 20 * kMs, k);
  }
  EXPECT_NEAR(assembler.timing(0).lag, 0.0, 1e-9);
  EXPECT_NEAR(assembler.timing(2).lag, 0.004, 1e-9);
  EXPECT_EQ(assembler.timing(2).left_out, 0u);
  EXPECT_GE(assembler.timing(3).left_out, 198u);
  EXPECT_NEAR(assembler.timing(3).nearest.value(), 0.02, 1e-9);
  EXPECT_THROW(assembler.timing(4), std::out_of_range);
  assembler.reset();
  EXPECT_EQ(assembler.timing(3).left_out, 0u);
  EXPECT_EQ(assembler.timing(2).lag, 0.0);
}

TEST(FrameSetAssembler, StampsComeOutAsTheyWereWithoutOffsets) {
  Assembler assembler = makeAssembler(2);
  for (int k = 0; k < 300; ++k) {
    const int64_t stamp = kSecond + k * (kSecond / 30);
    assembler.add(0, stamp, k);
    const Instants out = assembler.add(1, stamp + 4 * kMs, k);
    ASSERT_EQ(out.size(), 1u);
    ASSERT_EQ(out[0].stamp_ns, stamp + 2 * kMs);
    ASSERT_EQ(out[0].stamps_ns[0], stamp);
    ASSERT_EQ(out[0].stamps_ns[1], stamp + 4 * kMs);
  }
}

TEST(FrameSetAssembler, WrongOffsetsAreRefused) {
  EXPECT_THROW(Assembler(3, withOffsets({0.0, 0.1})), std::invalid_argument);
  EXPECT_THROW(Assembler(1, withOffsets({std::numeric_limits<double>::quiet_NaN()})),
               std::invalid_argument);
  EXPECT_THROW(Assembler(2, withOffsets({}, -1.0)), std::invalid_argument);
}

TEST(TimingRemarks, SayWhichCameraAndHowMuch) {
  AssemblerOptions options;
  EXPECT_EQ(lagRemark("cam2", {0.0024, 0, {}}, options), "");
  EXPECT_EQ(lagRemark("cam2", {0.0031, 0, {}}, options),
            "cam2's stamps are 3.1 ms later than the others', allowed are 5.0 ms");
  options.max_drift = 0.1;
  EXPECT_EQ(lagRemark("cam2", {-0.0031, 0, {}}, options), "");
  EXPECT_EQ(lagRemark("cam2", {-0.06, 0, {}}, options),
            "cam2's stamps are 60.0 ms earlier than the others', drift is followed up to 100.0 ms");
  EXPECT_EQ(stepRemark(0.005, 0.005), "");
  EXPECT_EQ(
      stepRemark(0.0211, 0.005),
      "the cameras are not in step: images up to 21.1 ms apart are one frame set, each taken at "
      "the time of its stamp");
  EXPECT_EQ(missRemark("cam3", {0.0, 1, 0.041}),
            "cam3 is left out, its nearest stamp is 41.0 ms later");
  EXPECT_EQ(missRemark("cam3", {0.0, 1, -70.25}),
            "cam3 is left out, its nearest stamp is 70.2 s earlier");
  EXPECT_EQ(missRemark("cam3", {0.0, 1, 2.5 * 86400}),
            "cam3 is left out, its nearest stamp is 2.5 days later");
  EXPECT_EQ(missRemark("cam3", {0.0, 1, {}}), "cam3 is left out, nothing comes from it");
}

}  // namespace
}  // namespace markerless_mocap
