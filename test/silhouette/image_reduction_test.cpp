#include "silhouette/boundary/image_reduction.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "markerless_mocap/products/silhouette_mask.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

TEST(ImageReduction, IsTheSmallestThatFits) {
  EXPECT_EQ(reductionOf({640, 480}, 1.0), 1);
  EXPECT_EQ(reductionOf({1000, 1000}, 1.0), 1);
  EXPECT_EQ(reductionOf({1088, 1920}, 1.0), 2);
  EXPECT_EQ(reductionOf({3840, 2160}, 1.0), 3);
  EXPECT_EQ(reductionOf({}, 1.0), 1);
}

TEST(ImageReduction, GivesTheMeansOfSquares) {
  cv::Mat image(3, 5, CV_8UC1, cv::Scalar(10));
  image(cv::Rect(0, 0, 2, 1)).setTo(30);
  image.at<uint8_t>(2, 4) = 90;
  const cv::Mat small = reducedImage(image, 2);
  ASSERT_EQ(small.size(), cv::Size(3, 2));
  EXPECT_EQ(small.at<uint8_t>(0, 0), 20);
  EXPECT_EQ(small.at<uint8_t>(0, 1), 10);
  EXPECT_EQ(small.at<uint8_t>(1, 2), 90) << "the last row and column repeat";
}

TEST(ImageReduction, EnlargedMaskLiesWhereTheImageHadIt) {
  const cv::Size size(331, 242);
  cv::Mat person(size, CV_8UC1, cv::Scalar(0));
  cv::circle(person, {150, 120}, 60, 255, cv::FILLED);
  for (const int reduction : {1, 2, 3}) {
    cv::Mat mask = reducedImage(person, reduction) > 127;
    mask(cv::Rect(0, 0, 10, 10)).setTo(kUnknownPixel);
    const cv::Mat large = enlargedMask(mask, reduction, size);
    ASSERT_EQ(large.size(), size);
    EXPECT_GT(iou(large == kPersonPixel, person), 0.98) << reduction;
    EXPECT_EQ(cv::countNonZero(large == kUnknownPixel), 100 * reduction * reduction);
  }
}

TEST(ImageReduction, EnlargedMaskIsThatOfTheWholeMaskWhereverThePersonIs) {
  const cv::Size size(331, 242);
  for (const cv::Point at : {cv::Point(0, 0), {60, 40}, {81, 59}, {-40, 300}}) {
    cv::Mat mask(61, 83, CV_8UC1, cv::Scalar(0)), whole;
    cv::circle(mask, at, 15, 255, cv::FILLED);
    cv::resize(mask, whole, mask.size() * 4, 0, 0, cv::INTER_LINEAR);
    const cv::Mat expected = whole(cv::Rect({0, 0}, size)) > 127;
    EXPECT_EQ(cv::countNonZero(enlargedMask(mask, 4, size) != expected), 0) << at;
  }
}

TEST(ImageReduction, NoiseOfALargeImageIsAveragedAway) {
  const cv::Size size(640, 480);
  const cv::Rect person(240, 120, 120, 280);
  const cv::Mat scene(size, CV_8UC3, cv::Scalar(120, 120, 120));
  const auto noisy = [&](int seed) {
    cv::Mat image = scene.clone(), noise(size, CV_16SC3), out;
    if (seed == 100) image(person).setTo(cv::Scalar(120, 120, 160));
    cv::RNG random(seed);
    random.fill(noise, cv::RNG::NORMAL, 0, 25);
    cv::add(image, noise, out, cv::noArray(), CV_8UC3);
    return out;
  };
  const auto foundWith = [&](double max_megapixels) {
    SilhouetteOptions options;
    options.background = "first_images";
    options.max_megapixels = max_megapixels;
    SilhouetteExtractor extractor(options);
    for (int i = 0; i < options.background_frames; ++i) extractor.update(noisy(i));
    return iou(extractor.update(noisy(100)).mask, exactMask(person, size));
  };
  EXPECT_GT(foundWith(0.02), 0.95);
  EXPECT_LT(foundWith(1.0), 0.8);
}

TEST(ImageReduction, MayBeDoneBefore) {
  SilhouetteOptions options;
  options.max_megapixels = 0.01;  // of 160 x 120 pixels half of each side
  SilhouetteExtractor extractor(options), other(options);
  const int reduction = extractor.reductionFor(kSize);
  ASSERT_EQ(reduction, 2);
  const cv::Mat scene = makeScene(3);
  for (int i = 0; i < options.background_frames; ++i) {
    extractor.update(withNoise(scene, i));
    other.update(reducedImage(withNoise(scene, i), reduction), kSize);
  }
  const cv::Mat image = withNoise(withPerson(scene), 100);
  const cv::Mat mask = extractor.update(image).mask;
  ASSERT_EQ(mask.size(), kSize);
  EXPECT_GT(iou(mask, exactMask()), 0.9);
  EXPECT_EQ(cv::norm(mask, other.update(reducedImage(image, reduction), kSize).mask), 0.0);
}

}  // namespace
}  // namespace markerless_mocap
