#include "markerless_mocap/silhouette/silhouette_extractor.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "silhouette/boundary/clean_mask.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

class SilhouetteOf : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(GreyAndColor, SilhouetteOf, testing::Values(1, 3));

TEST_P(SilhouetteOf, PersonIsFoundAndTheEmptySceneIsEmpty) {
  const cv::Mat scene = makeScene(GetParam());
  SilhouetteExtractor extractor = learned(scene);
  const SilhouetteResult empty = extractor.update(withNoise(scene, 100));
  EXPECT_EQ(empty.state, SilhouetteState::kReady);
  EXPECT_EQ(cv::countNonZero(empty.mask), 0);
  const cv::Mat mask = extractor.update(withNoise(withPerson(scene.clone()), 101)).mask;
  EXPECT_EQ(mask.type(), CV_8UC1);
  EXPECT_GT(iou(mask, exactMask()), 0.97);
}

TEST_P(SilhouetteOf, ChangeOfLightIsCompensated) {
  const cv::Mat scene = makeScene(GetParam());
  SilhouetteOptions options;
  options.remove_shadows = false;
  for (const double gain : {0.8, 1.2}) {
    cv::Mat image = withNoise(withPerson(scene * gain), 100);
    EXPECT_GT(iou(learned(scene, options).update(image).mask, exactMask()), 0.97) << gain;
    options.compensate_flicker = false;
    EXPECT_LT(iou(learned(scene, options).update(image).mask, exactMask()), 0.5) << gain;
    options.compensate_flicker = true;
  }
}

TEST_P(SilhouetteOf, CastShadowIsBackgroundUnlessAskedFor) {
  const cv::Mat scene = makeScene(GetParam());
  cv::Mat shaded = scene.clone();
  const cv::Rect shadow(20, 40, 40, 50);
  shaded(shadow) *= 0.75;
  SilhouetteOptions options;
  const int with_test = cv::countNonZero(learned(scene, options).update(shaded).mask);
  options.remove_shadows = false;
  const int without_test = cv::countNonZero(learned(scene, options).update(shaded).mask);
  EXPECT_GT(without_test, 0.9 * shadow.area());
  EXPECT_EQ(with_test, 0);
}

TEST_P(SilhouetteOf, ClothesOfAShadeOfTheBackgroundAreForeground) {
  const cv::Mat scene = makeScene(GetParam());
  cv::Mat image = scene.clone();
  // Folds: darker and brighter in turns, three pixels wide. Those of cloth of exactly the
  // background's colour must be deeper in a colour image.
  const double dark = GetParam() == 3 ? 0.62 : 0.65, bright = GetParam() == 3 ? 0.85 : 0.82;
  for (int y = 0; y < kPerson.height; ++y)
    image(cv::Rect(kPerson.x, kPerson.y + y, kPerson.width, 1)) *= y / 3 % 2 ? dark : bright;
  EXPECT_GT(iou(learned(scene).update(image).mask, exactMask()), 0.9);
}

TEST_P(SilhouetteOf, SmearedOutlineDoesNotWidenThePerson) {
  const cv::Mat scene = makeScene(GetParam());
  cv::Mat image = withPerson(scene.clone());
  cv::GaussianBlur(image, image, {5, 5}, 1.2);
  const cv::Mat mask = learned(scene).update(image).mask;
  EXPECT_GT(iou(mask, exactMask()), 0.95);
}

TEST(SilhouetteExtractor, DarkerThanAnyShadowIsForeground) {
  const cv::Mat scene = makeScene(3);
  cv::Mat dark = scene.clone();
  dark(kPerson) *= 0.4;
  EXPECT_GT(iou(learned(scene).update(dark).mask, exactMask()), 0.97);
}

TEST(SilhouetteExtractor, LearnsAsManyFramesAsAsked) {
  SilhouetteOptions options;
  options.background_frames = 3;
  SilhouetteExtractor extractor(options);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(extractor.framesLearned(), i);
    const SilhouetteResult result = extractor.update(makeScene(1));
    EXPECT_EQ(result.state, SilhouetteState::kLearning);
    EXPECT_TRUE(result.mask.empty());
  }
  EXPECT_EQ(extractor.update(makeScene(1)).state, SilhouetteState::kReady);
  extractor.reset();
  EXPECT_EQ(extractor.update(makeScene(3)).state, SilhouetteState::kLearning)
      << "after a reset another kind of image may come";
}

std::string refusal(SilhouetteExtractor* extractor, const cv::Mat& image) {
  try {
    extractor->update(image);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(SilhouetteExtractor, WrongImagesAreRefusedInOneSentence) {
  SilhouetteExtractor extractor = learned(makeScene(3));
  EXPECT_EQ(refusal(&extractor, cv::Mat()), "silhouette: the image is empty");
  EXPECT_EQ(refusal(&extractor, cv::Mat::zeros(kSize, CV_16UC1)),
            "silhouette: the image has pixels of 1 x 16 bits, allowed is 8 bit grey or BGR");
  EXPECT_EQ(
      refusal(&extractor, makeScene(1)),
      "silhouette: the image is 160 x 120 grey, allowed is 160 x 120 BGR, as its background is, "
      "or to learn that anew");
  EXPECT_NE(refusal(&extractor, cv::Mat::zeros(60, 80, CV_8UC3)), "");
}

TEST(SilhouetteExtractor, OptionsOutOfRangeAreRefused) {
  SilhouetteOptions options;
  options.background_frames = 1;
  EXPECT_THROW(SilhouetteExtractor{options}, std::invalid_argument);
}

cv::Mat cleaned(const cv::Mat& mask, const SilhouetteOptions& options) {
  return cleanBits(BitMask::fromMat(mask), options).toMat();
}

TEST(CleanMask, RemovesSpecksAndSmallBlobsOnly) {
  cv::Mat mask = exactMask();
  mask.at<uint8_t>(5, 5) = 255;
  mask(cv::Rect(120, 10, 10, 10)).setTo(255);
  EXPECT_GT(iou(cleaned(mask, {}), exactMask()), 0.99);
}

TEST(CleanMask, FillsSmallHolesAndKeepsLargeOnes) {
  cv::Mat mask = exactMask();
  const cv::Rect small(65, 35, 8, 8), large(65, 60, 9, 9);
  mask(small).setTo(0);
  mask(large).setTo(0);
  SilhouetteOptions options;
  options.max_hole_px = 64;
  const cv::Mat clean = cleaned(mask, options);
  EXPECT_EQ(cv::countNonZero(clean(small)), small.area());
  EXPECT_LT(cv::countNonZero(clean(large)), large.area() / 10);
  EXPECT_LT(cv::countNonZero(cleaned(mask, {})(small)), small.area() / 10)
      << "64 pixels are more than usual";
}

TEST(CleanMask, BackgroundCutOffByTheImageBorderIsNoHole) {
  cv::Mat mask(kSize, CV_8UC1, cv::Scalar(255));
  const cv::Rect corner(0, 0, 8, 8);
  mask(corner).setTo(0);
  EXPECT_GT(cv::countNonZero(cleaned(mask, {})(corner) == 0), corner.area() / 2);
}

}  // namespace
}  // namespace markerless_mocap
