#include "ros/segmentation_conversions.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <limits>
#include <stdexcept>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

BodyParts sampleParts() {
  BodyParts parts;
  parts.status = SegmentationStatus::kPartial;
  parts.reason = "arm 2 is not seen";
  for (int label = 0; label < kPartCount; ++label) {
    if (label == int(PartLabel::kArm2)) continue;
    PartCurve& curve = parts.parts[label];
    curve.seen = true;
    curve.whole = label != int(PartLabel::kLeg2);
    curve.voxel_count = 100u + label;
    curve.points = {{0.1, 0.2, 0.3 + label}, {0.4, 0.5, 0.6 + label}};
    curve.site_values = {0.0, 1.0};
  }
  parts.labels = {0, 1, 2};
  return parts;
}

VisualHull threeVoxels() {
  VisualHull hull;
  hull.lattice.size = {10, 10, 10};
  for (const uint32_t index : {3u, 4u, 700u}) hull.voxels.push_back({index, 8, {}, {}});
  return hull;
}

TEST(SegmentationConversions, PartsComeBackAsTheyWere) {
  const BodyParts there = sampleParts();
  const BodyParts back = partsFromMessage(messageFromParts(there, std_msgs::Header()));
  EXPECT_EQ(back.status, there.status);
  EXPECT_EQ(back.reason, there.reason);
  for (int label = 0; label < kPartCount; ++label) {
    EXPECT_EQ(back.parts[label].seen, there.parts[label].seen);
    EXPECT_EQ(back.parts[label].whole, there.parts[label].whole);
    EXPECT_EQ(back.parts[label].voxel_count, there.parts[label].voxel_count);
    EXPECT_EQ(back.parts[label].points, there.parts[label].points);
    EXPECT_EQ(back.parts[label].site_values, there.parts[label].site_values);
  }
}

TEST(SegmentationConversions, MessageAlwaysHasSixPartsByLabel) {
  const BodyPartsMsg message = messageFromParts(BodyParts(), std_msgs::Header());
  ASSERT_EQ(message.parts.size(), 6u);
  for (uint8_t label = 0; label < 6; ++label) EXPECT_EQ(message.parts[label].label, label);
  EXPECT_EQ(message.status, BodyPartsMsg::INVALID);
}

TEST(SegmentationConversions, BadMessagesAreRefused) {
  const BodyPartsMsg good = messageFromParts(sampleParts(), std_msgs::Header());
  BodyPartsMsg message = good;
  message.status = 9;
  EXPECT_THROW(partsFromMessage(message), std::invalid_argument);
  message = good;
  message.parts[0].label = 6;
  EXPECT_THROW(partsFromMessage(message), std::invalid_argument);
  message = good;
  message.parts[0].points[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(partsFromMessage(message), std::invalid_argument);
  message = good;
  message.parts[0].site_values.pop_back();
  EXPECT_THROW(partsFromMessage(message), std::invalid_argument);
}

/// The sentence with which a changed part is refused.
template <class Change>
std::string refusalOf(const Change& change) {
  BodyPartsMsg message = messageFromParts(sampleParts(), std_msgs::Header());
  change(message.parts[0]);
  return errorTextOf([&] { partsFromMessage(message); });
}

TEST(SegmentationConversions, SeenPartsThatAreNoCurveInARoomAreRefused) {
  const std::string sentence =
      "BodyParts has an unusable curve of the part 0, allowed are 2 to 10000 points within 10 km "
      "with one site value of 0 to 1 each";
  for (const size_t points : {0, 1, 20000})
    EXPECT_EQ(refusalOf([&](BodyPart& part) {
                part.points.resize(points);
                part.site_values.resize(points);
              }),
              sentence);
  EXPECT_EQ(refusalOf([](BodyPart& part) { part.points[1].x *= 1e300; }), sentence);
  EXPECT_EQ(refusalOf([](BodyPart& part) { part.site_values[1] = 7.0; }), sentence);
}

TEST(SegmentationConversions, PartsThatComeTwiceAreRefused) {
  EXPECT_EQ(refusalOf([](BodyPart& part) { part.label = 1; }), "BodyParts has the label 1 twice");
}

TEST(SegmentationConversions, CloudsWhoseSizesOverflowAreRefused) {
  auto cloud = labelledCloud(threeVoxels(), sampleParts(), std_msgs::Header());
  cloud.data.clear();
  for (const uint32_t step : {4u, 8u, 16u, 0x80000000u, 0u}) {
    cloud.width = cloud.height = 0x80000000u;
    cloud.point_step = step;
    cloud.fields[4].offset = 0;
    EXPECT_THROW(labelsFromMessage(cloud), std::invalid_argument) << step;
  }
}

TEST(SegmentationConversions, LabelsTravelWithThePoints) {
  const auto cloud = labelledCloud(threeVoxels(), sampleParts(), std_msgs::Header());
  EXPECT_EQ(cloud.width, 3u);
  EXPECT_EQ(labelsFromMessage(cloud), (std::vector<uint8_t>{0, 1, 2}));
}

TEST(SegmentationConversions, WhatIsCarriedOverIsToldAndDrawnDarker) {
  BodyParts parts = sampleParts();
  parts.parts[size_t(PartLabel::kArm2)].carried = true;
  parts.labels = {uint8_t(PartLabel::kArm1), uint8_t(PartLabel::kArm2), uint8_t(PartLabel::kLeg1)};
  const BodyPartsMsg message = messageFromParts(parts, std_msgs::Header());
  EXPECT_TRUE(message.parts[size_t(PartLabel::kArm2)].carried);
  EXPECT_FALSE(message.parts[size_t(PartLabel::kArm2)].seen);
  const BodyParts back = partsFromMessage(message);
  for (size_t label = 0; label < kPartCount; ++label)
    EXPECT_EQ(back.parts[label].carried, label == size_t(PartLabel::kArm2)) << label;
  const auto cloud = labelledCloud(threeVoxels(), parts, std_msgs::Header());
  sensor_msgs::PointCloud2ConstIterator<uint8_t> red(cloud, "r");
  EXPECT_EQ(red[0], partColor(PartLabel::kArm1)[0]);
  ++red;
  EXPECT_GT(red[0], 0);
  EXPECT_LT(red[0], partColor(PartLabel::kArm2)[0] / 2);
  ++red;
  EXPECT_EQ(red[0], partColor(PartLabel::kLeg1)[0]);
}

TEST(SegmentationConversions, FloatsOfEveryPointAreAligned) {
  const auto cloud = labelledCloud(threeVoxels(), sampleParts(), std_msgs::Header());
  EXPECT_EQ(cloud.point_step % 4, 0u);
  EXPECT_EQ(cloud.data.size(), size_t(cloud.point_step * cloud.width));
}

TEST(SegmentationConversions, NoLabelsGiveNoPoints) {
  BodyParts parts;
  EXPECT_EQ(labelledCloud(threeVoxels(), parts, std_msgs::Header()).width, 0u);
  parts.labels = {0, 1};
  EXPECT_THROW(labelledCloud(threeVoxels(), parts, std_msgs::Header()), std::invalid_argument);
}

TEST(SegmentationConversions, CloudWithoutLabelsOrWithUnknownOnesIsRefused) {
  auto cloud = labelledCloud(threeVoxels(), sampleParts(), std_msgs::Header());
  cloud.data[cloud.fields[4].offset] = 77;
  EXPECT_THROW(labelsFromMessage(cloud), std::invalid_argument);
  cloud.fields.pop_back();
  EXPECT_THROW(labelsFromMessage(cloud), std::invalid_argument);
}

TEST(SegmentationConversions, CurvesAreDrawnAndUnseenOnesTakenAway) {
  const auto markers = curveMarkers(sampleParts(), std_msgs::Header()).markers;
  ASSERT_EQ(markers.size(), 6u);
  for (int label = 0; label < kPartCount; ++label) {
    const bool drawn = label != int(PartLabel::kArm2);
    EXPECT_EQ(markers[label].action,
              drawn ? visualization_msgs::Marker::ADD : visualization_msgs::Marker::DELETE);
    EXPECT_EQ(markers[label].points.size(), drawn ? 2u : 0u);
  }
}

}  // namespace
}  // namespace markerless_mocap
