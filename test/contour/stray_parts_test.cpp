#include "contour/track/stray_parts.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

const cv::Rect kStray(5, 5, 30, 30);  ///< pixels

class StrayPartsTest : public testing::Test {
 protected:
  StrayPartsTest() {
    hull.lattice.origin = Eigen::Vector3d(-0.2, -0.2, 0.0);
    hull.lattice.pitch = 0.1;
    hull.lattice.size = {4, 4, 17};
    hull.voxels.resize(hull.lattice.count());
    for (uint32_t i = 0; i < hull.lattice.count(); ++i) hull.voxels[i].index = i;
    for (const Camera& camera : rig) {
      masks.push_back(cv::Mat::zeros(camera.height(), camera.width(), CV_8UC1));
      drawAt({0, 0, 0.9}, camera, masks.back());
    }
  }
  static void drawAt(const Eigen::Vector3d& place, const Camera& camera, cv::Mat& mask) {
    const Eigen::Vector2d middle = *camera.project(place);
    cv::rectangle(mask, cv::Rect(int(middle.x()) - 20, int(middle.y()) - 50, 40, 100), 255,
                  cv::FILLED);
  }
  bool same(const std::vector<cv::Mat>& cleaned) const {
    for (size_t i = 0; i < masks.size(); ++i)
      if (cleaned[i].data != masks[i].data) return false;
    return true;
  }

  CameraRig rig = drawnRig(2);
  VisualHull hull;
  std::vector<cv::Mat> masks;
};

TEST_F(StrayPartsTest, AreRemovedAndThePersonStays) {
  const cv::Mat person = masks[0].clone();
  masks[0](kStray) = 255;
  const std::vector<cv::Mat> cleaned = withoutStrayParts(masks, hull, rig);
  EXPECT_EQ(cv::norm(cleaned[0], person, cv::NORM_INF), 0.0);
  EXPECT_EQ(masks[0].at<uchar>(kStray.tl()), 255) << "the masks given are not changed";
  EXPECT_EQ(cleaned[1].data, masks[1].data);
}

TEST_F(StrayPartsTest, SpecksAndAMissingHullChangeNothing) {
  const VisualHull none;
  masks[0](cv::Rect(5, 5, 3, 3)) = 255;
  EXPECT_TRUE(same(withoutStrayParts(masks, hull, rig)));
  masks[0](kStray) = 255;
  EXPECT_TRUE(same(withoutStrayParts(masks, none, rig)));
}

TEST_F(StrayPartsTest, SunAtTheFeetBecomesUnknown) {
  const cv::Mat person = masks[0].clone();
  const cv::Rect place = cv::boundingRect(person);
  const cv::Rect sun(place.x, place.br().y - 5, 80, 40);
  masks[0](sun) = 255;
  const cv::Mat cleaned = withoutStrayParts(masks, hull, rig)[0];
  EXPECT_EQ(cv::countNonZero((person != 0) & (cleaned == 0)), 0);
  EXPECT_GT(cv::countNonZero(person & (cleaned == kPersonPixel)), 0.8 * cv::countNonZero(person))
      << "the hull is narrower than the drawing";
  const cv::Mat added = (masks[0] != 0) & (person == 0);
  EXPECT_GT(cv::countNonZero(added & (cleaned == kUnknownPixel)), 0.8 * cv::countNonZero(added));
}

TEST_F(StrayPartsTest, NothingIsRemovedWhereTheBackgroundIsUnknown) {
  masks[0](kStray) = 255;
  masks[0](cv::Rect(200, 5, 20, 20)) = 128;
  EXPECT_TRUE(same(withoutStrayParts(masks, hull, rig)));
}

}  // namespace
}  // namespace markerless_mocap
