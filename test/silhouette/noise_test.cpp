/// Masks of noisy images.
#include <gtest/gtest.h>

#include "silhouette/background/background_learner.h"
#include "silhouette/background/pixel_test.h"
#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/mask_runs.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

const cv::Size kRoom(320, 240);
const cv::Rect kTrousers(140, 120, 36, 90), kShirt(130, 50, 56, 75);

cv::Mat noisy(const cv::Mat& image, int seed, double sigma = 5) {
  cv::Mat noise(image.size(), CV_16SC3), out;
  cv::RNG random(seed + 1);
  random.fill(noise, cv::RNG::NORMAL, 0, sigma);
  cv::add(image, noise, out, cv::noArray(), image.type());
  return out;
}

/// Planks of slightly different browns below a grey wall.
cv::Mat makeRoom() {
  cv::Mat room(kRoom, CV_8UC3, cv::Scalar(150, 155, 158));
  cv::RNG random(5);
  for (int y = 110; y < room.rows; y += 10)
    for (int x = 0; x < room.cols; x += 64)
      room(cv::Rect(x, y, 64, 10)).setTo(cv::Scalar(95, 110, 125) * random.uniform(0.8, 1.2));
  return room;
}

/// Darkens an ellipse on the floor, at its middle to `darkest`.
void castShadow(double darkest, cv::Mat* image) {
  cv::Mat light(kRoom, CV_32FC1, 1.0f);
  cv::ellipse(light, {190, 212}, {80, 14}, 0, 0, 360, darkest, cv::FILLED);
  cv::GaussianBlur(light, light, {0, 0}, 4);
  cv::cvtColor(light, light, cv::COLOR_GRAY2BGR);
  cv::multiply(*image, light, *image, 1, CV_8UC3);
}

cv::Mat makePerson(cv::Mat* image) {
  cv::Mat mask = cv::Mat::zeros(kRoom, CV_8UC1);
  const auto paint = [&](const cv::Rect& part, const cv::Scalar& color) {
    (*image)(part).setTo(color);
    mask(part).setTo(255);
  };
  paint(kShirt, {60, 40, 160});
  paint({kTrousers.x, kTrousers.y, 14, kTrousers.height}, {40, 36, 34});
  paint({kTrousers.x + 22, kTrousers.y, 14, kTrousers.height}, {40, 36, 34});
  return mask;
}

SilhouetteExtractor learnedFromNoise(const cv::Mat& room, const SilhouetteOptions& options = {}) {
  SilhouetteExtractor extractor(options);
  for (int i = 0; i < options.background_frames; ++i) extractor.update(noisy(room, i));
  return extractor;
}

TEST(NoisyImage, SoftShadowAtDarkTrousersIsTakenOutAndTheTrousersStay) {
  const cv::Mat room = makeRoom();
  SilhouetteExtractor extractor = learnedFromNoise(room);
  for (const double darkest : {0.85, 0.7, 0.6}) {
    cv::Mat image = room.clone();
    castShadow(darkest, &image);
    const cv::Mat exact = makePerson(&image);
    EXPECT_GT(iou(extractor.update(noisy(image, 100)).mask, exact), 0.97) << darkest;
  }
}

TEST(NoisyImage, MaskHasNoSmallHolesAndNoSpecks) {
  SilhouetteOptions options;
  options.max_hole_px = 50;
  const cv::Mat room = makeRoom();
  SilhouetteExtractor extractor = learnedFromNoise(room, options);
  for (int i = 0; i < 5; ++i) {
    cv::Mat image = room.clone();
    makePerson(&image);
    // Spots of the background's own colour are holes until they are filled.
    for (int k = 0; k < 4; ++k) {
      const cv::Rect spot(kShirt.x + 6 + 12 * k, kShirt.y + 20 + i, 5, 5);
      room(spot).copyTo(image(spot));
    }
    const cv::Mat mask = extractor.update(noisy(image, 200 + i, 10)).mask;
    BitMask filled = BitMask::fromMat(mask);
    fillHoles(options.max_hole_px, &filled);
    removeBlobs(options.min_blob_px, &filled);
    EXPECT_EQ(cv::countNonZero(mask != filled.toMat()), 0) << i;
    EXPECT_EQ(cv::countNonZero(mask(kShirt) == 0), 0) << i;
  }
}

/// What cannot outlive the opening is not looked at; nothing that does is lost.
TEST(NoisyImage, ChangedPixelsAreThoseOfTheWholeImageOpened) {
  SilhouetteOptions options;
  options.remove_shadows = false;
  for (const cv::Size size : {cv::Size(128, 60), cv::Size(130, 61), cv::Size(63, 33)}) {
    const cv::Mat room = makeRoom()(cv::Rect({100, 100}, size)).clone();
    BackgroundLearner learner(30, false);
    for (int i = 0; i < 30; ++i) learner.add(noisy(room, i));
    Background background = learner.learn(1, options.min_sigma);
    for (const double sigmas : {1.0, 1.6, 2.2, 3.0}) {
      background.setThreshold(sigmas, options.min_sigma);
      const cv::Mat image = noisy(room, 100);
      PixelTest test;
      options.open_radius_px = 0;
      BitMask opened = test.classify(options, image, background, 1).foreground;
      opened = dilated(eroded(opened, 1), 1);
      options.open_radius_px = 1;
      EXPECT_EQ(test.classify(options, image, background, 1).foreground.words(), opened.words())
          << size << " " << sigmas;
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
