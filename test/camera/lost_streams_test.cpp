#include <gtest/gtest.h>

#include "markerless_mocap/camera/frame_set_assembler.h"

namespace markerless_mocap {
namespace {

using Assembler = FrameSetAssembler<int>;
using Instants = std::vector<Assembler::FrameSet>;

constexpr int64_t kMs = 1000000;
constexpr int64_t kPeriod = 67 * kMs;
constexpr size_t kStreams = 4;

/// As visual_hull joins masks.
Assembler makeAssembler() {
  AssemblerOptions options;
  options.deadline = 0.5;
  options.min_streams = 1;
  options.silence = 0.3;
  options.max_missed = 5;
  return Assembler(kStreams, options);
}

/// Sends frames of all streams but `without`; `shift_ns` is added to the stamps of the last stream.
struct Sender {
  Assembler* assembler;
  int frame = 0;
  int64_t epoch_ns = 1'000'000 * kMs;

  Instants send(int frames, int without = -1, int64_t shift_ns = 0) {
    Instants out;
    for (int end = frame + frames; frame < end; ++frame)
      for (size_t s = 0; s < kStreams; ++s) {
        if (int(s) == without) continue;
        const int64_t shift = s == kStreams - 1 ? shift_ns : 0;
        for (auto& f : assembler->add(s, epoch_ns + frame * kPeriod + shift, frame))
          out.push_back(std::move(f));
      }
    return out;
  }
  int64_t lastStamp() const { return epoch_ns + (frame - 1) * kPeriod; }
};

TEST(LostStreams, AStreamThatIsSilentIsSoonNotWaitedForAndComesBackAtOnce) {
  Assembler assembler = makeAssembler();
  Sender sender{&assembler};
  EXPECT_EQ(sender.send(20).size(), 20u);
  sender.send(6, 3);
  EXPECT_FALSE(assembler.timing(3).awaited);
  EXPECT_TRUE(assembler.timing(2).awaited);
  const Instants without = sender.send(1, 3);
  ASSERT_EQ(without.size(), 1u) << "no frame set waits for it any more";
  EXPECT_EQ(without[0].stamp_ns, sender.lastStamp());
  sender.send(2);
  EXPECT_TRUE(assembler.timing(3).awaited);
  const Instants with = sender.send(1);
  ASSERT_EQ(with.size(), 1u);
  EXPECT_TRUE(with[0].present[3]);
}

TEST(LostStreams, AShortGapIsWaitedFor) {
  Assembler assembler = makeAssembler();
  Sender sender{&assembler};
  sender.send(20);
  EXPECT_TRUE(sender.send(3, 3).empty());
  EXPECT_TRUE(assembler.timing(3).awaited);
}

TEST(LostStreams, APauseOfAllIsNoSilence) {
  Assembler assembler = makeAssembler();
  Sender sender{&assembler};
  sender.send(20);
  sender.epoch_ns += 3000 * kMs;
  const Instants out = sender.send(2);
  ASSERT_EQ(out.size(), 2u);
  for (const auto& frame_set : out) EXPECT_EQ(frame_set.present, std::vector<bool>(kStreams, true));
}

TEST(LostStreams, SlowStreamsAreNotTakenForSilent) {
  AssemblerOptions options;
  options.deadline = 2.0;
  options.silence = 0.3;
  Assembler assembler(2, options);
  for (int k = 0; k < 20; ++k)
    for (size_t s = 0; s < 2; ++s) {
      assembler.add(s, k * 500 * kMs, k);
      EXPECT_TRUE(assembler.timing(0).awaited);
      EXPECT_TRUE(assembler.timing(1).awaited);
    }
  EXPECT_EQ(assembler.counts().complete, 20u);
}

TEST(LostStreams, AStreamWithOtherStampsIsLeftOutAndItsItemsAreNoFrameSets) {
  Assembler assembler = makeAssembler();
  Sender sender{&assembler};
  sender.send(20);
  sender.send(16, -1, 30 * kMs);
  EXPECT_FALSE(assembler.timing(3).awaited);
  const Instants out = sender.send(10, -1, 30 * kMs);
  EXPECT_EQ(out.size(), 10u);
  for (const auto& frame_set : out) {
    EXPECT_FALSE(frame_set.present[3]);
    EXPECT_TRUE(frame_set.present[0]);
  }
  EXPECT_NEAR(assembler.timing(3).nearest.value(), 0.03, 1e-9);
  sender.send(2);
  EXPECT_TRUE(assembler.timing(3).awaited) << "its stamps fit again";
  EXPECT_EQ(sender.send(1).back().present, std::vector<bool>(kStreams, true));
}

// A camera whose host is faster than the others sends before the frame set it is nearest to closes.
TEST(LostStreams, TheNearestStampIsTheSameWhoeverIsFirst) {
  Assembler assembler = makeAssembler();
  const auto send = [&](int from, int to, int64_t shift) {
    for (int frame = from; frame < to; ++frame) {
      assembler.add(3, frame * kPeriod + shift, frame);
      for (size_t s = 0; s < 3; ++s) assembler.add(s, frame * kPeriod, frame);
    }
  };
  send(0, 20, 0);
  send(20, 40, 30 * kMs);
  EXPECT_FALSE(assembler.timing(3).awaited);
  EXPECT_NEAR(assembler.timing(3).nearest.value(), 0.03, 1e-9);
}

TEST(LostStreams, AStepBackWithinTheDeadlineLosesNothing) {
  Assembler assembler = makeAssembler();
  Sender sender{&assembler};
  sender.send(20);
  sender.epoch_ns -= 300 * kMs;
  EXPECT_EQ(sender.send(4).size(), 4u);
  EXPECT_EQ(assembler.counts().time_jumps_back, 1u);
}

TEST(LostStreams, OneStampAheadIsNoStep) {
  Assembler assembler = makeAssembler();
  Sender sender{&assembler};
  sender.send(20);
  sender.send(1, -1, 300 * kMs);
  sender.send(10);
  EXPECT_EQ(assembler.counts().time_jumps_back, 0u);
  EXPECT_EQ(sender.send(1).size(), 1u);
}

TEST(LostStreams, WithoutTheOptionsEveryFrameSetWaits) {
  AssemblerOptions options;
  options.deadline = 0.5;
  options.min_streams = 1;
  Assembler assembler(kStreams, options);
  Sender sender{&assembler};
  sender.send(20);
  sender.send(20, 3);
  EXPECT_TRUE(assembler.timing(3).awaited);
  EXPECT_LT(sender.send(1, 3).back().stamp_ns, sender.lastStamp() - 400 * kMs);
}

}  // namespace
}  // namespace markerless_mocap
