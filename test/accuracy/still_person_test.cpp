/// Somebody who keeps still in front of the cameras from the first image to the last, in a room
/// that nobody has filmed empty.
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "capture/studio_fixture.h"
#include "capture/virtual_studio.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "markerless_mocap/silhouette/recording_learner.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {
namespace {

constexpr int kImages = 45;

/// One camera's view of a person, and of the room without them.
struct View {
  cv::Mat image, person, empty;
};

const std::vector<View>& views() {
  static const std::vector<View> all = [] {
    StudioOptions options;
    options.rig = "ring4";
    options.motion = "stroll_arms_down";
    options.background_frames = 1;
    options.duration = 1;
    options.seed = 7;
    options.character.appearance_seed = 7;
    const VirtualStudio studio(options, packageFiles(), "person1");
    const StudioFrameSet empty = studio.render(0), frame = studio.render(1);
    std::vector<View> out;
    for (size_t i = 0; i < frame.images.size(); ++i)
      out.push_back({frame.images[i], frame.masks[i], empty.images[i]});
    return out;
  }();
  return all;
}

cv::Mat withNoise(const cv::Mat& image, int seed) {
  cv::RNG rng(uint64_t(seed) + 1);
  cv::Mat noise(image.size(), CV_16SC3), sum;
  rng.fill(noise, cv::RNG::NORMAL, 0, 2);
  cv::add(image, noise, sum, cv::noArray(), CV_8U);
  return sum;
}

/// A learner that has seen a recording in which only noise changes.
RecordingLearner watched(const cv::Mat& image) {
  RecordingLearner learner(SilhouetteOptions(), kImages);
  for (int i = 0; i < kImages; ++i)
    learner.add(learner.wantsNext() ? withNoise(image, i) : cv::Mat());
  return learner;
}

std::vector<SharedBackground> learnedFrom(cv::Mat View::*image) {
  std::vector<RecordingLearner> learners;
  for (const View& view : views()) learners.push_back(watched(view.*image));
  return learnBackgrounds(learners);
}

cv::Mat maskOf(const SharedBackground& background, const cv::Mat& image) {
  SilhouetteExtractor extractor{SilhouetteOptions()};
  extractor.useBackground(background);
  return extractor.update(image).mask;
}

/// The person is in the masks with nearly all parts, and in the mean over the views with not much
/// else: pictures on the wall behind may be in a mask, the hull leaves them out.
template <class MaskT>
void expectPersonIn(const MaskT& maskAt) {
  double overlap = 0;
  for (size_t i = 0; i < views().size(); ++i) {
    const cv::Mat found = maskAt(i) == kPersonPixel, person = views()[i].person;
    const int both = cv::countNonZero(found & person);
    EXPECT_GT(both, 0.8 * cv::countNonZero(person)) << "cam" << i;
    overlap += double(both) / cv::countNonZero(found | person);
  }
  EXPECT_GT(overlap / double(views().size()), 0.65);
}

TEST(StillPerson, IsInTheMasksThoughNothingMoves) {
  const std::vector<SharedBackground> backgrounds = learnedFrom(&View::image);
  ASSERT_EQ(std::count(backgrounds.begin(), backgrounds.end(), nullptr), 0);
  expectPersonIn(
      [&](size_t i) { return maskOf(backgrounds[i], withNoise(views()[i].image, 100)); });
}

TEST(StillPerson, IsInTheMasksOfImagesAsTheyCome) {
  expectPersonIn([&](size_t i) {
    SilhouetteExtractor extractor{SilhouetteOptions()};
    SilhouetteResult result;
    for (int image = 0; image < kImages; ++image)
      result = extractor.update(withNoise(views()[i].image, image));
    return result.mask;
  });
}

TEST(StillPerson, WhatIsBehindThemIsUnknownOnceTheyHaveGone) {
  const std::vector<SharedBackground> backgrounds = learnedFrom(&View::image);
  for (size_t i = 0; i < views().size(); ++i) {
    const cv::Mat mask = maskOf(backgrounds.at(i), withNoise(views()[i].empty, 100));
    const int claimed = cv::countNonZero((mask == kPersonPixel) & views()[i].person);
    const int unknown = cv::countNonZero((mask == kUnknownPixel) & views()[i].person);
    EXPECT_LT(claimed, 0.2 * cv::countNonZero(views()[i].person)) << "cam" << i;
    EXPECT_GT(unknown, 0.6 * cv::countNonZero(views()[i].person)) << "cam" << i;
  }
}

/// The colour of the person's clothes.
cv::Scalar clothesOf(const View& view) {
  const cv::Rect body = cv::boundingRect(view.person);
  return cv::mean(
      view.image(cv::Rect(body.x + body.width / 2 - 4, body.y + body.height / 3, 8, 8)));
}

TEST(StillPerson, ThingsOfTheirColoursApartFromThemAreNotThePerson) {
  for (size_t i = 0; i < views().size(); ++i) {
    cv::Mat image = views()[i].image.clone();
    const cv::Rect body = cv::boundingRect(views()[i].person);
    const cv::Rect thing(body.br().x + 8, body.y, 12, 30);
    image(thing).setTo(clothesOf(views()[i]));
    const cv::Mat mask = maskOf(watched(image).learn(), withNoise(image, 100));
    EXPECT_GT(cv::countNonZero((mask == kPersonPixel) & views()[i].person), 0) << "cam" << i;
    EXPECT_EQ(cv::countNonZero(mask(thing) == kPersonPixel), 0) << "cam" << i;
  }
}

TEST(StillPerson, ThingsOfTheirColoursBehindThemAreNotThePersonOnceTheyHaveGone) {
  for (size_t i = 0; i < views().size(); ++i) {
    const cv::Mat& person = views()[i].person;
    const cv::Rect body = cv::boundingRect(person);
    cv::Mat thing = cv::Mat::zeros(person.size(), CV_8UC1);
    thing(cv::Rect(body.x + body.width / 2, body.y + body.height / 4, body.width / 2 + 10, 30)) =
        255;
    cv::Mat image = views()[i].image.clone(), empty = views()[i].empty.clone();
    const cv::Scalar color = clothesOf(views()[i]);
    image.setTo(color, thing & ~person);
    empty.setTo(color, thing);
    const SharedBackground background = watched(image).learn();
    thing &= ~person;
    const cv::Mat before = maskOf(background, withNoise(image, 100)) == kPersonPixel;
    EXPECT_GT(cv::countNonZero(before & thing), 0.5 * cv::countNonZero(thing)) << "cam" << i;
    const cv::Mat after = maskOf(background, withNoise(empty, 100)) == kPersonPixel;
    EXPECT_LT(cv::countNonZero(after & thing), 0.1 * cv::countNonZero(thing)) << "cam" << i;
  }
}

// Their outline was a guess, and images without them tell more. Masks go on meanwhile.
TEST(StillPerson, TheBackgroundIsLearnedAnewOnceTheyHaveGone) {
  for (size_t i = 0; i < views().size(); ++i) {
    SilhouetteExtractor extractor{SilhouetteOptions()};
    for (int image = 0; image < kImages; ++image)
      extractor.update(withNoise(views()[i].image, image));
    SilhouetteResult result;
    const auto showEmpty = [&](int from, int to) {
      for (int image = from; image < to; ++image) {
        result = extractor.update(withNoise(views()[i].empty, image));
        EXPECT_EQ(result.state, SilhouetteState::kReady) << "cam" << i << ", image " << image;
      }
    };
    showEmpty(0, 4);
    EXPECT_GT(result.unknown_fraction, 0.0) << "cam" << i;
    EXPECT_TRUE(result.is_learned_anew) << "cam" << i;
    const cv::Mat place = result.mask(cv::boundingRect(views()[i].person));
    EXPECT_EQ(cv::countNonZero(place == kPersonPixel), 0) << "cam" << i << ": a ghost";
    showEmpty(4, kImages + 4);
    EXPECT_FALSE(result.is_learned_anew) << "cam" << i;
    EXPECT_EQ(result.unknown_fraction, 0.0) << "cam" << i;
    EXPECT_LT(cv::countNonZero(result.mask), 0.02 * cv::countNonZero(views()[i].person))
        << "cam" << i;
  }
}

TEST(StillPerson, MasksAreTheSameWhateverChanceWasUsedBefore) {
  std::vector<cv::Mat> first;
  for (const int seed : {3, 4}) {
    cv::setRNGSeed(seed);
    const std::vector<SharedBackground> backgrounds = learnedFrom(&View::image);
    for (size_t i = 0; i < views().size(); ++i) {
      const cv::Mat mask = maskOf(backgrounds.at(i), views()[i].image);
      if (first.size() == i) first.push_back(mask);
      EXPECT_EQ(cv::norm(mask, first.at(i), cv::NORM_INF), 0) << "cam" << i;
    }
  }
}

TEST(StillPerson, IsNotSeenInAnEmptyRoom) {
  const std::vector<SharedBackground> backgrounds = learnedFrom(&View::empty);
  EXPECT_EQ(std::count(backgrounds.begin(), backgrounds.end(), nullptr),
            std::ptrdiff_t(views().size()));
}

TEST(StillPerson, IsNotLookedForInTinyImages) {
  RecordingLearner learner(SilhouetteOptions(), kImages);
  for (int i = 0; i < kImages; ++i) learner.add(cv::Mat(40, 30, CV_8UC3, cv::Scalar(90, 90, 90)));
  EXPECT_FALSE(learner.isOccupiedAtFirst());
}

}  // namespace
}  // namespace markerless_mocap
