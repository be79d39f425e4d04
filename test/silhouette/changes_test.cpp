/// Light, reflections and objects that change the scene are no person.
#include <gtest/gtest.h>

#include <cmath>

#include "markerless_mocap/products/silhouette_mask.h"
#include "silhouette/background/background_learner.h"
#include "silhouette/changes/kept_texture.h"
#include "silhouette/changes/light_switch.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

const cv::Size kRoom(320, 240);
const cv::Rect kFloorPatch(60, 120, 160, 80);

/// A floor of boards, each of its own brightness.
cv::Mat makeFloor() {
  cv::Mat boards(kRoom.height / 6, kRoom.width / 16, CV_8UC1), floor;
  cv::RNG random(5);
  random.fill(boards, cv::RNG::UNIFORM, 70, 140);
  cv::resize(boards, floor, kRoom, 0, 0, cv::INTER_NEAREST);
  cv::cvtColor(floor, floor, cv::COLOR_GRAY2BGR);
  cv::multiply(floor, cv::Scalar(0.7, 0.9, 1.0), floor);
  cv::GaussianBlur(floor, floor, {3, 3}, 0);
  return floor;
}

cv::Rect walkerAt(int i) {
  return {20 + 3 * i, 100, 24, 90};
}

cv::Mat withWalker(const cv::Mat& scene, int i) {
  return withPerson(scene, walkerAt(i));
}

/// The scene with the patch multiplied by a colour.
cv::Mat withLight(const cv::Mat& scene, const cv::Rect& patch, const cv::Scalar& light) {
  cv::Mat lit = scene.clone(), part = lit(patch);
  cv::multiply(part, light, part);
  return lit;
}

double overlap(const cv::Mat& mask, const cv::Rect& person) {
  return iou(mask, exactMask(person, kRoom));
}

TEST(ChangedLight, PatchOfSunIsNoPerson) {
  const cv::Mat floor = makeFloor();
  SilhouetteExtractor extractor = learned(floor);
  for (int i = 0; i < 40; ++i) {
    const cv::Mat lit = withLight(floor, kFloorPatch, {1.5, 1.6, 1.7});
    const cv::Mat mask = extractor.update(withNoise(withWalker(lit, i), 100 + i)).mask;
    if (i < 2) continue;
    EXPECT_GT(overlap(mask, walkerAt(i)), 0.93) << i;
  }
}

TEST(ChangedLight, IsForegroundIfChangesAreNotFollowed) {
  const cv::Mat floor = makeFloor();
  SilhouetteOptions options;
  options.follow_changes = false;
  SilhouetteExtractor extractor = learned(floor, options);
  const cv::Mat lit = withLight(floor, kFloorPatch, {1.5, 1.6, 1.7});
  cv::Mat mask;
  for (int i = 0; i < 5; ++i) mask = extractor.update(withNoise(withWalker(lit, i), 100 + i)).mask;
  EXPECT_GT(cv::countNonZero(mask(kFloorPatch)), 0.9 * kFloorPatch.area());
}

TEST(ChangedLight, PatchOfSunThatLeavesIsNoPerson) {
  const cv::Mat floor = makeFloor();
  SilhouetteExtractor extractor = learned(withLight(floor, kFloorPatch, {1.5, 1.6, 1.7}));
  for (int i = 0; i < 40; ++i) {
    const cv::Mat mask = extractor.update(withNoise(withWalker(floor, i), 100 + i)).mask;
    if (i < 2) continue;
    EXPECT_GT(overlap(mask, walkerAt(i)), 0.93) << i;
  }
}

TEST(ChangedLight, ReflectionInTheFloorIsNoPerson) {
  const cv::Mat floor = makeFloor();
  SilhouetteExtractor extractor = learned(floor);
  for (int i = 0; i < 40; ++i) {
    cv::Mat image = withWalker(floor, i);
    cv::Mat mirrored = image(cv::Rect(walkerAt(i).x, 190, 24, 50));
    cv::addWeighted(mirrored, 0.8, cv::Mat(mirrored.size(), CV_8UC3, {200, 30, 30}), 0.2, 0,
                    mirrored);
    const cv::Mat mask = extractor.update(withNoise(image, 100 + i)).mask;
    if (i < 2) continue;
    EXPECT_GT(overlap(mask, walkerAt(i)), 0.93) << i;
  }
}

Background backgroundOf(const cv::Mat& scene) {
  BackgroundLearner learner(10, true);
  for (int i = 0; i < 10; ++i) learner.add(withNoise(scene, i));
  Background background = learner.learn(1, 4);
  background.setThreshold(3, 4);
  return background;
}

TEST(ChangedLight, PlainClothesBrighterOrDarkerThanTheFloorAreNoLight) {
  const cv::Mat floor = makeFloor();
  const Background background = backgroundOf(floor);
  SilhouetteOptions options;
  for (const double grey : {40.0, 100.0, 190.0}) {
    cv::Mat image = floor.clone();
    image(cv::Rect(100, 60, 60, 120)).setTo(cv::Scalar(0.7 * grey, 0.9 * grey, grey));
    PixelTest test;
    KeptTexture texture;
    for (int i = 0; i < 16; ++i) {
      const cv::Mat noisy = withNoise(image, 100 + i);
      PixelClasses& classes = test.classify(options, noisy, background, 1);
      ASSERT_GT(classes.foreground.count(), 1000u);
      texture.findLit(noisy, background, 1, &classes);
      EXPECT_LT(classes.lit.count(), 0.02 * double(classes.foreground.count())) << grey;
    }
  }
}

/// Light that one lamp gives, more to the left, and another everywhere.
cv::Mat litByLamp(const cv::Mat& scene, double lamp) {
  cv::Mat lit = scene.clone();
  for (int x = 0; x < scene.cols; ++x) {
    cv::Mat column = lit.col(x);
    const double light = 0.5 + lamp * (0.8 - 0.6 * x / scene.cols);
    cv::multiply(column, cv::Scalar(light, light, 1.05 * light), column);
  }
  return lit;
}

TEST(ChangedLight, SwitchedLampIsNoPersonAndIsRememberedWhenSwitchedBack) {
  const cv::Mat on = litByLamp(makeFloor(), 1), off = litByLamp(makeFloor(), 0.2);
  SilhouetteExtractor extractor = learned(on);
  for (int i = 0; i < 60; ++i) {
    const cv::Mat& scene = i / 15 % 2 == 0 ? on : off;
    const SilhouetteResult found = extractor.update(withNoise(withWalker(scene, i), 100 + i));
    EXPECT_GT(overlap(found.mask, walkerAt(i)), 0.93) << i;
    if (i < 15) continue;
    EXPECT_NEAR(found.light_gain, 1, 0.03) << i;
  }
}

/// Bands of light that move through the image, as of lamps that flicker.
cv::Mat inBands(const cv::Mat& scene, int i) {
  cv::Mat lit = scene.clone();
  for (int y = 0; y < lit.rows; ++y) lit.row(y) *= 1.0 + 0.4 * std::sin(y / 20.0 + i);
  return lit;
}

TEST(ChangedLight, LightThatChangesAgainAndAgainLeavesTheBackgroundAsItWas) {
  const cv::Mat floor = makeFloor();
  SilhouetteExtractor extractor = learned(floor);
  const auto update = [&](const cv::Mat& scene, int i) {
    return extractor.update(withNoise(withWalker(scene, i), 100 + i)).mask;
  };
  for (int i = 0; i < 5; ++i) update(floor, i);
  for (int i = 5; i < 65; ++i) update(inBands(floor, i), i);
  for (int i = 65; i < 75; ++i) EXPECT_GT(overlap(update(floor, i), walkerAt(i)), 0.93) << i;
}

/// A room with dark and bright things on its walls.
cv::Mat makeWalls() {
  cv::Mat walls(kRoom, CV_8UC3, cv::Scalar(150, 160, 165));
  cv::RNG random(7);
  for (int i = 0; i < 15; ++i)
    cv::rectangle(walls, cv::Rect(random(300), random(220), 15 + random(30), 15 + random(30)),
                  cv::Scalar(random(220), random(220), random(220)), cv::FILLED);
  return walls;
}

/// As a camera sees it whose lens is turned.
cv::Mat outOfFocus(const cv::Mat& image) {
  cv::Mat blurred;
  cv::GaussianBlur(image, blurred, {}, 8);
  return blurred;
}

cv::Mat aBitOutOfFocus(const cv::Mat& image) {
  cv::Mat blurred;
  cv::GaussianBlur(image, blurred, {}, 3);
  return blurred;
}

cv::Mat zoomed(const cv::Mat& image) {
  cv::Mat larger;
  cv::resize(image(cv::Rect(40, 30, 240, 180)), larger, kRoom);
  return larger;
}

TEST(ChangedLight, PicturesThatWereWrongForAWhileLeaveTheBackgroundAsItWas) {
  const cv::Mat walls = makeWalls();
  for (const auto& change : {outOfFocus, aBitOutOfFocus, zoomed}) {
    SilhouetteExtractor extractor = learned(walls);
    for (int i = 0; i < 90; ++i) {
      const cv::Mat image = withNoise(withWalker(walls, i), 100 + i);
      const bool is_wrong = i >= 5 && i < 80;
      const cv::Mat mask = extractor.update(is_wrong ? change(image) : image).mask;
      if (is_wrong) continue;
      EXPECT_GT(overlap(mask, walkerAt(i)), 0.93) << i;
    }
  }
}

TEST(ChangedLight, TurnedCameraIsNoChangeOfLight) {
  const cv::Mat floor = makeFloor();
  Background background = backgroundOf(floor);
  const uint16_t mean = background.mean(0, 50, 1)[70];
  cv::Mat turned;
  cv::flip(floor, turned, 1);
  EXPECT_FALSE(relight(turned, 1, BitMask(kRoom), &background));
  EXPECT_FALSE(relight(0.6 * floor, 0.6, BitMask(kRoom), &background)) << "a gain is enough";
  EXPECT_EQ(background.mean(0, 50, 1)[70], mean);
  const cv::Mat lit = litByLamp(floor, 1);
  EXPECT_TRUE(relight(lit, 1, BitMask(kRoom), &background));
  EXPECT_NEAR(background.mean(0, 50, 1)[70], lit.at<cv::Vec3b>(50, 70)[1] * Background::kMeanScale,
              4 * Background::kMeanScale);
}

class StillObject : public testing::Test {
 protected:
  cv::Mat scene(bool with_box) const {
    cv::Mat image = floor_.clone();
    if (with_box) image(kBox).setTo(cv::Scalar(30, 60, 200));
    return image;
  }
  cv::Mat update(const cv::Mat& scene, const cv::Rect& person) {
    ++images_;
    const cv::Mat image = person.empty() ? scene : withPerson(scene, person);
    return extractor_.update(withNoise(image, 100 + images_)).mask;
  }

  const cv::Rect kBox{200, 120, 50, 50};
  const cv::Mat floor_ = makeFloor();
  SilhouetteExtractor extractor_ = learned(floor_);
  int images_ = 0;
};

TEST_F(StillObject, BroughtBesideAMovingPersonBecomesBackground) {
  cv::Mat mask;
  for (int i = 0; i < 30; ++i) mask = update(scene(true), {40 + 2 * i, 90, 30, 90});
  EXPECT_GT(overlap(mask, {98, 90, 30, 90}), 0.95);
  // A person before the object is still seen.
  mask = update(scene(true), {190, 90, 30, 90});
  EXPECT_GT(overlap(mask, {190, 90, 30, 90}), 0.95);
}

TEST_F(StillObject, TakenAwayLeavesNothing) {
  cv::Mat mask;
  for (int i = 0; i < 30; ++i) mask = update(scene(true), {40 + 2 * i, 90, 30, 90});
  for (int i = 0; i < 6; ++i) mask = update(scene(false), {100 - 2 * i, 90, 30, 90});
  EXPECT_GT(overlap(mask, {90, 90, 30, 90}), 0.95);
}

TEST_F(StillObject, AloneOrTouchedByAPersonStays) {
  cv::Mat mask;
  for (int i = 0; i < 40; ++i) mask = update(scene(true), {});
  EXPECT_GT(overlap(mask, kBox), 0.95) << "it may be a person who stands still";
  for (int i = 0; i < 40; ++i) mask = update(scene(true), {172 + 3 * (i % 3), 90, 30, 90});
  EXPECT_GT(cv::countNonZero(mask(kBox)), 0.95 * kBox.area())
      << "it may be a part of the person who moves";
}

/// The background is known but for the left part, where somebody stood all the time.
class UnknownPlace : public StillObject {
 protected:
  UnknownPlace() {
    Background background = *extractor_.background();
    BitMask unknown(kRoom);
    for (int y = kPlace.y; y < kPlace.br().y; ++y)
      unknown.fill(y, kPlace.x, kPlace.br().x - 1, true);
    background.setUnknown(std::move(unknown));
    extractor_.useBackground(std::make_shared<const Background>(std::move(background)));
  }

  const cv::Rect kPlace{20, 80, 60, 120};
};

TEST_F(UnknownPlace, IsKnownAfterThePersonHasMovedAway) {
  cv::Mat mask;
  for (int i = 0; i < 30; ++i) mask = update(scene(true), {120 + (i % 20), 90, 30, 90});
  EXPECT_EQ(cv::countNonZero(mask == kUnknownPixel), 0);
  EXPECT_GT(overlap(mask, {129, 90, 30, 90}), 0.95) << "without the box, too";
  const cv::Rect back(30, 90, 30, 90);
  mask = update(scene(true), back);
  EXPECT_GT(overlap(mask, back), 0.95) << "the place has become background as it is seen now";
}

TEST_F(UnknownPlace, StaysUnknownWhileThePersonMovesInIt) {
  cv::Mat mask;
  for (int i = 0; i < 40; ++i) mask = update(scene(false), {30 + (i % 20), 90, 30, 90});
  EXPECT_EQ(cv::countNonZero(mask(kPlace) == kUnknownPixel), kPlace.area());
}

}  // namespace
}  // namespace markerless_mocap
