/// Backgrounds of recordings in which nobody leaves the scene.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <thread>

#include "markerless_mocap/products/silhouette_mask.h"
#include "markerless_mocap/silhouette/background_picture.h"
#include "markerless_mocap/silhouette/recording_learner.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

constexpr int kFrames = 120;

/// Somebody walks from the left to the right and back.
cv::Rect walker(int frame) {
  const int turn = kFrames / 2;
  return {10 + 2 * (frame < turn ? frame : kFrames - frame) * 55 / turn, 30, 24, 70};
}

cv::Mat walkerImage(const cv::Mat& scene, int frame) {
  return withNoise(withPerson(scene, walker(frame)), frame);
}

/// Somebody sways on the spot; the middle of the body is covered in each image.
cv::Rect swayer(int frame) {
  return {55 + frame % 20, 30, 40, 70};
}
const cv::Rect kAlwaysCovered(74, 30, 21, 70);

RecordingLearner watched(const cv::Mat& scene, cv::Rect (*person)(int),
                         const SilhouetteOptions& options = {}) {
  RecordingLearner learner(options, kFrames);
  for (int i = 0; i < kFrames; ++i) learner.add(withNoise(withPerson(scene, person(i)), i));
  return learner;
}

SilhouetteExtractor withBackground(const SharedBackground& background) {
  SilhouetteExtractor extractor{SilhouetteOptions()};
  extractor.useBackground(background);
  return extractor;
}

class RecordingOf : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(GreyAndColor, RecordingOf, testing::Values(1, 3));

TEST_P(RecordingOf, PersonWhoNeverLeavesIsFoundInEveryImage) {
  const cv::Mat scene = makeScene(GetParam());
  const RecordingLearner learner = watched(scene, walker);
  EXPECT_TRUE(learner.isOccupiedAtFirst());
  SilhouetteExtractor extractor = withBackground(learner.learn());
  for (int i = 0; i < kFrames; i += 7) {
    const SilhouetteResult result = extractor.update(walkerImage(scene, i));
    EXPECT_EQ(result.state, SilhouetteState::kReady);
    EXPECT_GT(iou(result.mask == kPersonPixel, exactMask(walker(i))), 0.95) << i;
  }
  EXPECT_EQ(cv::countNonZero(extractor.update(withNoise(scene, 999)).mask == kPersonPixel), 0);
}

TEST_P(RecordingOf, WhatIsAlwaysCoveredIsUnknown) {
  const cv::Mat scene = makeScene(GetParam());
  const SharedBackground background = watched(scene, swayer).learn();
  SilhouetteExtractor extractor = withBackground(background);
  const SilhouetteResult result = extractor.update(withNoise(scene, 999));
  const cv::Mat unknown = result.mask == kUnknownPixel;
  EXPECT_GT(cv::countNonZero(unknown(kAlwaysCovered)), 0.9 * kAlwaysCovered.area());
  EXPECT_LT(cv::countNonZero(unknown), 1.5 * kAlwaysCovered.area());
  EXPECT_NEAR(result.unknown_fraction, double(cv::countNonZero(unknown)) / unknown.total(), 1e-9);
  EXPECT_NEAR(unknownFraction(*background), result.unknown_fraction, 1e-9);
  EXPECT_LT(cv::countNonZero(result.mask == kPersonPixel), 20);
}

TEST_P(RecordingOf, ThePictureOfABackgroundIsTheSceneWhereItIsKnown) {
  const cv::Mat scene = makeScene(GetParam());
  const SharedBackground background = watched(scene, swayer).learn();
  const BackgroundPicture picture = pictureOf(*background);
  ASSERT_EQ(picture.colors.type(), CV_8UC3);
  ASSERT_EQ(picture.colors.size(), scene.size());
  EXPECT_NEAR(cv::countNonZero(picture.unknown) / double(scene.total()),
              unknownFraction(*background), 1e-9);
  EXPECT_GT(cv::countNonZero(picture.unknown(kAlwaysCovered)), 0.9 * kAlwaysCovered.area());
  cv::Mat bgr = scene, difference;
  if (scene.channels() == 1) cv::cvtColor(scene, bgr, cv::COLOR_GRAY2BGR);
  cv::absdiff(picture.colors, bgr, difference);
  EXPECT_LT(cv::norm(difference, cv::NORM_INF, picture.unknown == 0), 12);
}

TEST(RecordingLearner, AnExtractorGivesTheBackgroundThatItUses) {
  const cv::Mat scene = makeScene(3);
  SilhouetteExtractor extractor{SilhouetteOptions()};
  extractor.update(scene);
  EXPECT_FALSE(extractor.background()) << "still learning";
  const SharedBackground background = watched(scene, swayer).learn();
  extractor.useBackground(background);
  for (int image = 0; image < 2; ++image) {
    ASSERT_TRUE(extractor.background());
    EXPECT_EQ(unknownFraction(*extractor.background()), unknownFraction(*background));
    extractor.update(scene);
  }
}

TEST_P(RecordingOf, LargeImagesAreLearnedAtFullDetail) {
  const cv::Size size(960, 720);
  const cv::Mat scene = makeScene(GetParam(), size);
  RecordingLearner learner({}, 40);
  const auto person = [](int i) { return cv::Rect(100 + 15 * i, 180, 120, 400); };
  for (int i = 0; i < 40; ++i) learner.add(withNoise(withPerson(scene, person(i)), i));
  SilhouetteExtractor extractor = withBackground(learner.learn());
  const cv::Mat mask = extractor.update(withNoise(withPerson(scene, person(20)), 99)).mask;
  EXPECT_GT(iou(mask == kPersonPixel, exactMask(person(20), size)), 0.97);
}

TEST(RecordingLearner, EmptyRoomAtFirstIsLeftToTheFirstImages) {
  const cv::Mat scene = makeScene(3);
  std::vector<RecordingLearner> learners;
  for (int camera = 0; camera < 2; ++camera) {
    learners.emplace_back(SilhouetteOptions(), kFrames);
    for (int i = 0; i < kFrames; ++i)
      learners.back().add(i < 30 ? withNoise(scene, i) : walkerImage(scene, i));
    EXPECT_FALSE(learners.back().isOccupiedAtFirst());
  }
  for (const SharedBackground& background : learnBackgrounds(learners))
    EXPECT_EQ(background, nullptr);
}

TEST(RecordingLearner, EmptyRoomAtFirstIsFoundAlsoIfSomebodyStaysOnTheSpotLater) {
  const cv::Mat scene = makeScene(3);
  RecordingLearner learner({}, kFrames);
  for (int i = 0; i < kFrames; ++i)
    learner.add(withNoise(i < 30 ? scene : withPerson(scene, swayer(i)), i));
  EXPECT_FALSE(learner.isOccupiedAtFirst());
}

TEST(RecordingLearner, FurnitureThatIsBroughtInLeavesTheFirstImagesEmpty) {
  const cv::Mat scene = makeScene(3);
  RecordingLearner learner({}, kFrames);
  for (int i = 0; i < kFrames; ++i) learner.add(withNoise(i < 30 ? scene : withPerson(scene), i));
  EXPECT_FALSE(learner.isOccupiedAtFirst());
}

TEST(RecordingLearner, SunThatWandersAwayIsNobodyWhoLeaves) {
  const cv::Mat scene = makeScene(3);
  cv::Mat sunny = scene.clone();
  sunny(kPerson) *= 1.35;
  RecordingLearner learner({}, kFrames);
  for (int i = 0; i < kFrames; ++i) learner.add(withNoise(i < 35 ? sunny : scene, i));
  EXPECT_FALSE(learner.isOccupiedAtFirst());
}

TEST(RecordingLearner, SunThatWandersInTheFirstImagesIsNobodyWhoMoves) {
  const cv::Mat scene = makeScene(3);
  RecordingLearner learner({}, kFrames);
  for (int i = 0; i < kFrames; ++i) {
    cv::Mat sunny = scene.clone();
    sunny(kPerson + cv::Point(i / 3, 0)) *= 1.35;
    learner.add(withNoise(sunny, i));
  }
  EXPECT_FALSE(learner.isOccupiedAtFirst());
}

TEST(RecordingLearner, ALampThatIsOnForAWhileHidesNoBackground) {
  const cv::Mat scene = makeScene(3);
  cv::Mat other;  // a lamp at the right
  cv::Mat factor(scene.size(), CV_32FC3);
  for (int x = 0; x < scene.cols; ++x)
    factor.col(x).setTo(cv::Scalar::all(0.4 + 0.6 * x / scene.cols));
  cv::multiply(scene, factor, other, 1.0, scene.type());
  RecordingLearner learner({}, kFrames);
  for (int i = 0; i < kFrames; ++i)
    learner.add(3 * i < kFrames ? walkerImage(other, i) : walkerImage(scene, i));
  ASSERT_TRUE(learner.isOccupiedAtFirst());
  EXPECT_LT(unknownFraction(*learner.learn()), 0.1);
}

TEST(RecordingLearner, PersonWhoStandsStillAtFirstAndThenLeavesIsNoticed) {
  const cv::Mat scene = makeScene(3);
  RecordingLearner learner({}, kFrames);
  for (int i = 0; i < kFrames; ++i) learner.add(withNoise(i < 35 ? withPerson(scene) : scene, i));
  EXPECT_TRUE(learner.isOccupiedAtFirst());
  SilhouetteExtractor extractor = withBackground(learner.learn());
  EXPECT_EQ(cv::countNonZero(extractor.update(withNoise(scene, 999)).mask), 0);
}

TEST(RecordingLearner, MostCamerasDecideAndOthersLearnFromTheFirstImages) {
  const cv::Mat scene = makeScene(3);
  const auto backgrounds = [&](int occupied) {
    std::vector<RecordingLearner> learners;
    for (int camera = 0; camera < 3; ++camera) {
      learners.emplace_back(SilhouetteOptions(), kFrames);
      for (int i = 0; i < kFrames; ++i)
        learners.back().add(camera < occupied ? walkerImage(scene, i) : withNoise(scene, i));
    }
    return learnBackgrounds(learners);
  };
  const auto two = backgrounds(2), one = backgrounds(1);
  EXPECT_TRUE(two[0] && two[1] && !two[2]);
  EXPECT_TRUE(!one[0] && !one[1] && !one[2]) << "a screen that plays, not a person";
}

TEST(RecordingLearner, NeedsOnlyAPartOfALongRecording) {
  const cv::Mat scene = makeScene(3, {64, 48});
  for (const bool occupied : {false, true}) {
    RecordingLearner learner({}, 3000);
    int wanted = 0;
    for (int i = 0; i < 3000; ++i) {
      const bool wants = learner.wantsNext();
      wanted += wants;
      const cv::Rect person(i % 40, 10, 12, 30);
      const cv::Mat image = occupied ? withPerson(scene, person) : scene;
      learner.add(wants ? withNoise(image, i) : cv::Mat());
    }
    EXPECT_EQ(learner.isOccupiedAtFirst(), occupied);
    EXPECT_GT(wanted, occupied ? 200 : 20);
    EXPECT_LT(wanted, occupied ? 350 : 40);
  }
}

TEST(RecordingLearner, RecordingShorterThanTheFirstImagesIsOccupiedIfSomethingMoves) {
  const cv::Mat scene = makeScene(3);
  RecordingLearner still({}, 1), moving({}, 20);
  still.add(scene);
  for (int i = 0; i < 20; ++i) moving.add(walkerImage(scene, i));
  EXPECT_FALSE(still.isOccupiedAtFirst());
  EXPECT_TRUE(moving.isOccupiedAtFirst());
}

TEST(RecordingLearner, BadInputIsRefused) {
  RecordingLearner learner({}, 10);
  EXPECT_THROW(learner.learn(), std::invalid_argument) << "no images";
  EXPECT_THROW(learner.add(cv::Mat::zeros(kSize, CV_16UC1)), std::invalid_argument);
  learner.add(cv::Mat());
  learner.add(makeScene(3));
  EXPECT_THROW(learner.add(makeScene(1)), std::invalid_argument);
  EXPECT_THROW(learner.add(makeScene(3, {64, 48})), std::invalid_argument);
  SilhouetteOptions options;
  options.model = "mean_shift";
  EXPECT_THROW(RecordingLearner(options, 10), std::invalid_argument);
  options = {};
  options.background = "first_images";
  EXPECT_THROW(RecordingLearner(options, 10), std::invalid_argument);
}

TEST(SilhouetteExtractor, GivenBackgroundMustBeOfItsModel) {
  SilhouetteOptions options;
  options.model = "mean_shift";
  SilhouetteExtractor extractor(options);
  EXPECT_THROW(extractor.useBackground(watched(makeScene(3), walker).learn()),
               std::invalid_argument);
}

TEST(SilhouetteExtractor, EmptyRoomGivesTheSameMasksWhateverTheBackgroundOption) {
  const cv::Mat scene = makeScene(3);
  SilhouetteOptions first_images;
  first_images.background = "first_images";
  SilhouetteExtractor automatic = learned(scene), plain = learned(scene, first_images);
  for (int i = 0; i < 40; ++i) {
    const cv::Mat image = walkerImage(scene, i);
    EXPECT_EQ(cv::countNonZero(automatic.update(image).mask != plain.update(image).mask), 0);
  }
}

TEST(SilhouetteExtractor, LiveBackgroundIsFilledInAsThePersonMoves) {
  const cv::Mat scene = makeScene(3);
  SilhouetteExtractor extractor{SilhouetteOptions()};
  int frame = 0;
  for (; frame < 31; ++frame) extractor.update(withNoise(withPerson(scene, swayer(frame)), frame));
  const cv::Mat image = withNoise(withPerson(scene, swayer(frame)), frame);
  const SilhouetteResult early = extractor.update(image);
  EXPECT_GT(early.unknown_fraction, 0.05);
  EXPECT_GT(cv::countNonZero(early.mask(kAlwaysCovered) == kUnknownPixel),
            0.9 * kAlwaysCovered.area());
  EXPECT_GT(iou(early.mask, exactMask(swayer(frame))), 0.6) << "unknown counts as person";
  SilhouetteResult late;
  for (; frame < 130; ++frame) late = extractor.update(walkerImage(scene, frame % kFrames));
  EXPECT_LT(late.unknown_fraction, 0.005);
  EXPECT_GT(iou(late.mask == kPersonPixel, exactMask(walker((frame - 1) % kFrames))), 0.95);
}

/// Shows images from `frame` on until there is a mask, for a minute at most.
SilhouetteResult firstMask(const std::function<cv::Mat(int)>& image, int frame,
                           SilhouetteExtractor* extractor) {
  SilhouetteResult found;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (found.mask.empty() && std::chrono::steady_clock::now() < end) {
    found = extractor->update(image(frame));
    if (found.mask.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return found;
}

TEST(SilhouetteExtractor, FirstLiveBackgroundIsLearnedBesideTheImages) {
  const cv::Mat scene = makeScene(3);
  const auto empty = [&](int frame) { return withNoise(scene, frame); };
  SilhouetteExtractor live{SilhouetteOptions()}, plain{SilhouetteOptions()};
  live.learnBeside();
  const int frames = SilhouetteOptions().background_frames;
  for (int frame = 0; frame < frames; ++frame) {
    live.update(empty(frame));
    plain.update(empty(frame));
  }
  SilhouetteOptions strict;
  strict.min_blob_px = 100000;  // what is changed meanwhile must not be lost
  live.change(strict);
  plain.change(strict);
  ASSERT_FALSE(firstMask(empty, frames, &live).mask.empty());
  plain.update(empty(frames));
  const cv::Mat image = withNoise(withPerson(scene, walker(10)), 100);
  EXPECT_EQ(cv::countNonZero(live.update(image).mask), 0);
  plain.update(image);
  for (SilhouetteExtractor* one : {&live, &plain}) one->change(SilhouetteOptions());
  const cv::Mat mask = plain.update(image).mask;
  EXPECT_GT(cv::countNonZero(mask), 0);
  EXPECT_EQ(cv::countNonZero(live.update(image).mask != mask), 0);
}

TEST(SilhouetteExtractor, LiveLearningThatIsResetBeginsAnew) {
  const cv::Mat scene = makeScene(3);
  const auto empty = [&](int frame) { return withNoise(scene, frame); };
  SilhouetteExtractor live{SilhouetteOptions()};
  live.learnBeside();
  for (const int round : {0, 1}) {
    for (int frame = 0; frame < SilhouetteOptions().background_frames; ++frame)
      EXPECT_EQ(live.update(empty(frame)).state, SilhouetteState::kLearning) << round;
    if (round == 0) live.reset();
  }
  EXPECT_FALSE(firstMask(empty, 30, &live).mask.empty());
}

TEST(SilhouetteExtractor, LiveBackgroundIsLearnedAgainBesideTheImages) {
  const cv::Mat scene = makeScene(3);
  const auto swaying = [&](int frame) {
    return withNoise(withPerson(scene, swayer(frame)), frame);
  };
  SilhouetteOptions options;
  options.follow_changes = false;  // nothing else makes the background known
  SilhouetteExtractor extractor{options};
  extractor.learnBeside();
  for (int frame = 0; frame < 30; ++frame) extractor.update(swaying(frame));
  EXPECT_GT(firstMask(swaying, 30, &extractor).unknown_fraction, 0.05);
  double unknown = 1.0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  for (int frame = 31; unknown > 0.005 && std::chrono::steady_clock::now() < end; ++frame) {
    unknown = extractor.update(walkerImage(scene, frame % kFrames)).unknown_fraction;
    if (frame > 130) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_LT(unknown, 0.005);
}

TEST(SilhouetteExtractor, UnknownPixelsAreSavedWithTheBackground) {
  const std::string path = testing::TempDir() + std::to_string(getpid()) + ".background";
  const cv::Mat scene = makeScene(3), image = withNoise(withPerson(scene), 100);
  SilhouetteExtractor first = withBackground(watched(scene, swayer).learn());
  first.saveBackground(path);
  SilhouetteExtractor second{SilhouetteOptions()};
  second.loadBackground(path);
  const cv::Mat mask = first.update(image).mask;
  EXPECT_GT(cv::countNonZero(mask == kUnknownPixel), 0);
  EXPECT_EQ(cv::countNonZero(second.update(image).mask != mask), 0);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace markerless_mocap
