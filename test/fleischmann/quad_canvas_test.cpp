#include "fleischmann/fitness/quad_canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <random>

namespace markerless_mocap {
namespace {

constexpr int kWidth = 150, kHeight = 90;

/// Distance of a point inside (positive) or outside the quad's sides' lines, in double.
double depthInside(const Quad& quad, int x, int y) {
  double area = 0.0, depth = HUGE_VAL;
  for (int i = 0; i < 4; ++i) {
    const int n = (i + 1) % 4;
    area += double(quad.x[i]) * quad.y[n] - double(quad.x[n]) * quad.y[i];
  }
  for (int i = 0; i < 4; ++i) {
    const int n = (i + 1) % 4;
    const double dx = double(quad.x[n]) - quad.x[i], dy = double(quad.y[n]) - quad.y[i];
    const double cross = dx * (y - double(quad.y[i])) - dy * (x - double(quad.x[i]));
    depth = std::min(depth, (area > 0 ? cross : -cross) / std::hypot(dx, dy));
  }
  return depth;
}

/// Corners on an ellipse make a convex quad; the ellipses are of all sizes and everywhere.
Quad randomQuad(std::mt19937& random) {
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  const float cx = -20 + 190 * share(random), cy = -20 + 130 * share(random);
  const float a = 0.5f + 40 * share(random), b = 0.5f + 40 * share(random);
  float angle = 6.28f * share(random);
  const float turn = share(random) < 0.5f ? 1.0f : -1.0f;
  Quad quad;
  for (int k = 0; k < 4; ++k) {
    angle += turn * (0.3f + 1.2f * share(random));
    quad.x[k] = cx + a * std::cos(angle);
    quad.y[k] = cy + b * std::sin(angle);
  }
  return quad;
}

TEST(QuadCanvas, setsThePixelsWhoseCentresAreInside) {
  QuadCanvas canvas(kWidth, kHeight);
  const Quad quad = {{9.5f, 40.0f, 40.0f, 9.5f}, {3.0f, 3.0f, 5.9f, 5.9f}};
  canvas.draw(&quad, 1);
  EXPECT_EQ(canvas.image().count(), 31 * 3);  // x 10 to 40, y 3 to 5
  EXPECT_TRUE(canvas.image().at(10, 3));
  EXPECT_TRUE(canvas.image().at(40, 5));
  EXPECT_FALSE(canvas.image().at(9, 4));
  EXPECT_FALSE(canvas.image().at(41, 4));
  EXPECT_FALSE(canvas.image().at(20, 6));
}

// Pixels whose centre lies nearer than this to a side may fall either way in single precision.
TEST(QuadCanvas, drawsUnionsToThePixel) {
  constexpr double kTie = 1e-3;
  std::mt19937 random(11);
  QuadCanvas canvas(kWidth, kHeight);
  int64_t compared = 0, inside = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Quad, 3> quads;
    for (Quad& quad : quads) quad = randomQuad(random);
    canvas.draw(quads.data(), 3);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        double depth = -HUGE_VAL;
        for (const Quad& quad : quads) depth = std::max(depth, depthInside(quad, x, y));
        if (std::abs(depth) < kTie) continue;
        ++compared;
        inside += depth > 0;
        ASSERT_EQ(canvas.image().at(x, y), depth > 0) << trial << ": " << x << ", " << y;
      }
  }
  EXPECT_GT(compared, 0.99 * 200 * kWidth * kHeight);
  EXPECT_GT(inside, 100000);
}

TEST(QuadCanvas, overlapCountsWhatIsDrawnAndWhatIsShared) {
  std::mt19937 random(5);
  cv::Mat mask(kHeight, kWidth, CV_8UC1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) mask.at<uint8_t>(y, x) = random() % 3 == 0 ? 1 + x : 0;
  const BitImage silhouette(mask);
  QuadCanvas canvas(kWidth, kHeight);
  for (int trial = 0; trial < 50; ++trial) {
    const Quad quad = randomQuad(random);
    canvas.draw(&quad, 1);
    int64_t drawn = 0, shared = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        drawn += canvas.image().at(x, y);
        shared += canvas.image().at(x, y) && mask.at<uint8_t>(y, x);
      }
    const Overlap overlap = canvas.overlap(silhouette);
    EXPECT_EQ(overlap.drawn, drawn);
    EXPECT_EQ(overlap.shared, shared);
  }
}

TEST(QuadCanvas, whatIsOutsideFlatOrNotANumberIsBoundedAndLeavesNoTrace) {
  QuadCanvas canvas(kWidth, kHeight);
  const float far = 1e9f;
  const Quad whole = {{-far, far, far, -far}, {-far, -far, far, far}};
  canvas.draw(&whole, 1);
  EXPECT_EQ(canvas.image().count(), kWidth * kHeight);
  const Quad right = {{200, 300, 300, 200}, {0, 0, 50, 50}};
  const Quad flat = {{0, 100, 100, 0}, {10.5f, 10.5f, 10.5f, 10.5f}};
  const Quad none = {{NAN, 100, 100, 0}, {NAN, 10, 20, 20}};
  for (const Quad& quad : {right, flat, none}) {
    canvas.draw(&quad, 1);
    EXPECT_LE(canvas.image().count(), kWidth * kHeight);
  }
  canvas.draw(&right, 1);
  EXPECT_EQ(canvas.image().count(), 0);
  canvas.draw(nullptr, 0);
  EXPECT_EQ(canvas.image().count(), 0);
}

TEST(BitImage, keepsEveryPixelOfAMask) {
  std::mt19937 random(2);
  cv::Mat mask(37, 67, CV_8UC1);
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) mask.at<uint8_t>(y, x) = uint8_t(random() % 4 * 80);
  const BitImage image(mask);
  EXPECT_EQ(image.columns(), 3);
  EXPECT_EQ(image.count(), cv::countNonZero(mask));
  EXPECT_EQ(cv::countNonZero(image.mask() != (mask != 0)), 0);
}

}  // namespace
}  // namespace markerless_mocap
