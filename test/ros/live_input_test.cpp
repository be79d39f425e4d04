#include <gtest/gtest.h>
#include <sensor_msgs/Image.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "nodes/common/end_process.h"
#include "nodes/common/frozen_images.h"
#include "nodes/common/input_watch.h"
#include "nodes/common/message_pool.h"
#include "nodes/common/stamp_order.h"
#include "nodes/common/sudden_change.h"
#include "ros/jpeg_image.h"

namespace markerless_mocap {
namespace {

using Verdict = StampOrder::Verdict;

constexpr int64_t kMs = 1000000;
constexpr int64_t kPeriod = 67 * kMs;

/// Images at 15 per second; `clock_ns` is what the camera's clock says more than ours.
struct Camera {
  StampOrder order;
  int64_t now_ns = 0, clock_ns = 1'000'000 * kMs;

  StampOrder::Judgement send(int64_t off_ns = 0) {
    now_ns += kPeriod;
    return order.judge(now_ns + clock_ns + off_ns, now_ns);
  }
  void sendGood(int images) {
    for (int i = 0; i < images; ++i) EXPECT_EQ(send().verdict, Verdict::kInOrder);
  }
};

TEST(StampOrder, ZeroAndRepeatedStampsAreTold) {
  StampOrder order;
  EXPECT_EQ(order.judge(0, 1).verdict, Verdict::kZero);
  EXPECT_EQ(order.judge(5 * kMs, 2).verdict, Verdict::kInOrder);
  EXPECT_EQ(order.judge(5 * kMs, 3).verdict, Verdict::kDuplicate);
}

TEST(StampOrder, StampsThatHardlyGoOnAreRepeated) {
  StampOrder order;
  EXPECT_EQ(order.judge(1000 * kMs, 0).verdict, Verdict::kInOrder);
  for (int i = 1; i <= 20; ++i) {
    EXPECT_EQ(order.judge(1000 * kMs + i, i * kPeriod).verdict, Verdict::kDuplicate);
    EXPECT_EQ(order.duplicates(), i);
  }
  EXPECT_EQ(order.judge(1000 * kMs + 21 * kPeriod, 21 * kPeriod).verdict, Verdict::kInOrder);
  EXPECT_EQ(order.duplicates(), 0);
}

TEST(StampOrder, OneStampAheadCostsOneImage) {
  for (const int64_t ahead : {1000 * kMs, 3'600'000 * kMs}) {
    Camera camera;
    camera.sendGood(20);
    EXPECT_EQ(camera.send(ahead).verdict, Verdict::kDoubtful);
    camera.sendGood(5);
  }
}

TEST(StampOrder, AClockThatWasSetIsToldByHowMuch) {
  for (const double step : {-0.3, -1.0, -3600.0, 1.0, 3600.0}) {
    Camera camera;
    camera.sendGood(20);
    camera.clock_ns += int64_t(1e9 * step);
    EXPECT_EQ(camera.send().verdict, Verdict::kDoubtful) << step;
    const StampOrder::Judgement found = camera.send();
    EXPECT_EQ(found.verdict, Verdict::kStepped) << step;
    EXPECT_NEAR(found.step, step, 1e-6);
    camera.sendGood(5);
  }
}

TEST(StampOrder, AfterAPauseNothingIsLost) {
  Camera camera;
  camera.sendGood(20);
  camera.now_ns += 30'000 * kMs;
  camera.sendGood(5);
}

TEST(StampOrder, ImagesThatCameLateCatchUpWithoutAStepOfTheClock) {
  Camera camera;
  camera.sendGood(20);
  // The process stood still for 8 s: images of then come at once, those between are lost.
  const int64_t stopped_ns = camera.now_ns;
  const int64_t goes_on_ns = stopped_ns + 8000 * kMs;
  for (int i = 1; i <= 5; ++i)
    EXPECT_EQ(camera.order.judge(stopped_ns + i * kPeriod + camera.clock_ns, goes_on_ns + i * kMs)
                  .verdict,
              Verdict::kInOrder);
  camera.now_ns = goes_on_ns;
  camera.sendGood(5);
  EXPECT_EQ(camera.send(1000 * kMs).verdict, Verdict::kDoubtful) << "ahead of what is usual";
}

TEST(StampOrder, AfterAPauseAStampAheadIsDoubtful) {
  Camera camera;
  camera.sendGood(20);
  camera.now_ns += 30'000 * kMs;
  camera.sendGood(1);
  EXPECT_EQ(camera.send(1000 * kMs).verdict, Verdict::kDoubtful);
}

TEST(StampOrder, ImagesMayLack) {
  Camera camera;
  camera.sendGood(20);
  camera.now_ns += 3 * kPeriod;
  camera.sendGood(1);
}

TEST(FrozenImages, ASensorThatRepeatsItselfIsFrozenAtTheThirdImage) {
  FrozenImages images;
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(images.add(false));
  EXPECT_FALSE(images.add(true));
  EXPECT_TRUE(images.add(true));
  EXPECT_EQ(images.run(), 3);
  EXPECT_TRUE(images.add(true));
  EXPECT_FALSE(images.add(false));
  EXPECT_FALSE(images.add(true)) << "what a frozen camera did is not usual";
  EXPECT_TRUE(images.add(true));
}

TEST(FrozenImages, FilmsWithoutNoiseMayRepeatWhatTheyHaveRepeated) {
  FrozenImages images;
  images.add(false);
  for (int i = 0; i < 40; ++i) EXPECT_FALSE(images.add(true)) << "an empty room";
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(images.add(false)) << "a person";
  for (int i = 0; i < 60; ++i) EXPECT_FALSE(images.add(true)) << "the person is gone";
  for (int i = 0; i < 60; ++i) images.add(true);
  EXPECT_TRUE(images.add(true));
}

cv::Mat picture(int seed, int noise) {
  cv::Mat image(60, 80, CV_8UC3), change(60, 80, CV_8UC3);
  cv::theRNG().state = uint64_t(seed);
  cv::randu(image, 0, 255);
  cv::theRNG().state = uint64_t(noise);
  cv::randu(change, 0, 8);
  return image + change;
}

TEST(MessagePool, OnlyWhatNobodyHoldsIsUsedAgain) {
  MessagePool<sensor_msgs::Image> pool;
  sensor_msgs::ImageConstPtr first = pool.take(), second = pool.take();
  EXPECT_NE(first, second);
  const sensor_msgs::Image* const free = first.get();
  first.reset();
  EXPECT_EQ(pool.take().get(), free);
  EXPECT_NE(pool.take(), second);
  std::vector<sensor_msgs::ImageConstPtr> held;  // more than are kept
  for (int i = 0; i < 10; ++i) held.push_back(pool.take());
  for (size_t i = 0; i < held.size(); ++i)
    for (size_t j = 0; j < i; ++j) EXPECT_NE(held[i], held[j]);
}

TEST(SuddenChange, ADamagedImageIsLeftOutAndOneThatStaysIsNot) {
  SuddenChange change;
  for (int i = 1; i < 5; ++i) EXPECT_FALSE(change.add(picture(1, i)));
  for (int i = 1; i < 5; ++i) EXPECT_TRUE(change.add(picture(1 + i, 7))) << "each another";
  EXPECT_FALSE(change.add(picture(1, 9)));
  EXPECT_TRUE(change.add(picture(33, 1)));
  EXPECT_TRUE(change.add(picture(33, 2)));
  EXPECT_FALSE(change.add(picture(33, 3))) << "a lamp";
  EXPECT_FALSE(change.add(picture(33, 4)));
  EXPECT_FALSE(change.add(picture(1, 10))) << "as it was before the lamp";
  EXPECT_TRUE(change.add(picture(34, 1)));
}

TEST(SuddenChange, AnUnreadableImageBetweenEndsTheRun) {
  SuddenChange change;
  change.add(picture(1, 1));
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(change.add(picture(33, i)));
    EXPECT_TRUE(change.add(picture(33, i)));
    change.interrupt();
  }
}

/// A room with structures of all sizes.
cv::Mat emptyRoom() {
  cv::Mat fine(240, 320, CV_8UC3);
  cv::theRNG().state = 11;
  cv::randu(fine, 0, 256);
  cv::Mat coarse = fine.clone(), room;
  cv::GaussianBlur(fine, fine, {}, 3.0);
  cv::GaussianBlur(coarse, coarse, {}, 24.0);
  cv::normalize(0.3 * fine + 0.7 * coarse, room, 20, 235, cv::NORM_MINMAX);
  return room;
}

/// With the noise of a sensor.
cv::Mat room(int noise) {
  static const cv::Mat empty = emptyRoom();
  cv::Mat grain(empty.size(), CV_8UC3);
  cv::theRNG().state = uint64_t(noise + 1);
  cv::randn(grain, 8, 3);
  return empty + grain;
}

double changedPixels(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  return cv::countNonZero(difference.reshape(1) > 12) / double(difference.reshape(1).total());
}

TEST(SuddenChange, DamagedJpegsWithoutAWarningAreLeftOut) {
  SuddenChange change;
  int decoded = 0, told = 0;
  for (int seed = 0; seed < 300; ++seed) {
    const cv::Mat image = room(seed % 7);
    EXPECT_FALSE(change.add(image)) << seed;
    std::vector<uint8_t> bytes;
    cv::imencode(".jpg", image, bytes);
    cv::RNG random(uint64_t(seed) + 1);
    bytes[size_t(random.uniform(700, int(bytes.size()) - 50))] = uint8_t(random.uniform(0, 255));
    try {
      const cv::Mat damaged = decodedJpeg(bytes);
      if (changedPixels(damaged, image) < 0.05) continue;  // harmless
      ++decoded;
      told += change.add(damaged);
    } catch (const std::invalid_argument&) {
      change.interrupt();
    }
  }
  EXPECT_GT(decoded, 20);
  EXPECT_GE(told, 0.85 * decoded) << decoded;
}

TEST(SuddenChange, AScreenBelowIsNoDamage) {
  SuddenChange change;
  int left_out = 0;
  for (int i = 0; i < 300; ++i) {
    cv::Mat image = room(i % 7);
    if (i % 2) image.rowRange(200, 240) += cv::Scalar(40, 40, 40);
    left_out += change.add(image);
  }
  EXPECT_GT(left_out, 5);
  EXPECT_LT(left_out, 40);
}

TEST(SuddenChange, APersonWhoMovesIsNoDamage) {
  SuddenChange change;
  for (int i = 0; i < 60; ++i) {
    cv::Mat image = room(i % 7);
    cv::ellipse(image, {20 + 5 * i, 190}, {60, 120}, 0, 0, 360, cv::Scalar(20, 20, 200), -1);
    EXPECT_FALSE(change.add(image)) << i;
  }
}

TEST(InputWatch, SilenceIsToldByThePeriod) {
  using Silence = InputWatch::Silence;
  InputWatch watch;
  EXPECT_EQ(watch.silence(1e6), Silence::kNone) << "it has not begun";
  double now = 100.0;
  for (int i = 0; i < 10; ++i) watch.arrived(now += 1.0);
  EXPECT_EQ(watch.silence(now + 2.9), Silence::kNone);
  EXPECT_EQ(watch.silence(now + 3.1), Silence::kSome);
  EXPECT_EQ(watch.silence(now + 10.1), Silence::kLong);
  watch.arrived(now += 50.0);
  EXPECT_EQ(watch.silence(now + 3.1), Silence::kSome) << "the pause is not the period";
}

TEST(InputWatch, FastInputsMayPauseForAMoment) {
  using Silence = InputWatch::Silence;
  InputWatch watch;
  double now = 0.0;
  for (int i = 0; i < 200; ++i) watch.arrived(now += 0.005);
  EXPECT_EQ(watch.silence(now + 0.4), Silence::kNone);
  EXPECT_EQ(watch.silence(now + 0.6), Silence::kSome);
  EXPECT_EQ(watch.silence(now + 1.1), Silence::kLong);
}

TEST(EndProcess, AnExceptionInAThreadEndsTheProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(runOrEndProcess("the worker", [] { throw std::runtime_error("no memory"); }),
              testing::ExitedWithCode(1), "");
  runOrEndProcess("the worker", [] {});
}

}  // namespace
}  // namespace markerless_mocap
