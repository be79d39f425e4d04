#include "ros/mask_png.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "error_text_of.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

/// A person-like outline with specks, in a VGA image.
cv::Mat sampleMask() {
  cv::Mat mask(480, 640, CV_8UC1, cv::Scalar(0));
  cv::ellipse(mask, {320, 200}, {60, 110}, 0, 0, 360, 255, cv::FILLED);
  cv::line(mask, {300, 300}, {250, 460}, 255, 30);
  cv::line(mask, {340, 300}, {390, 460}, 255, 30);
  cv::line(mask, {330, 150}, {560, 90}, 255, 18);
  cv::RNG random(5);
  for (int i = 0; i < 60; ++i)
    mask.at<uint8_t>(random.uniform(0, 480), random.uniform(0, 640)) = 255;
  return mask;
}

std_msgs::Header sampleHeader() {
  std_msgs::Header header;
  header.stamp = ros::Time(12, 34);
  header.frame_id = "cam3_optical";
  return header;
}

cv::Mat throughPng(const cv::Mat& mask) {
  const sensor_msgs::ImagePtr image = maskFromCompressed(compressedMask(mask, sampleHeader()));
  EXPECT_EQ(image->header.stamp, ros::Time(12, 34));
  EXPECT_EQ(image->header.frame_id, "cam3_optical");
  return maskFromMessage(*image);
}

std::string refusalOf(std::vector<uint8_t> bytes) {
  sensor_msgs::CompressedImage message;
  message.header.frame_id = "cam3_optical";
  message.data = std::move(bytes);
  return errorTextOf([&] { maskFromCompressed(message); });
}

std::vector<uint8_t> pngOf(const cv::Mat& image) {
  std::vector<uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  return bytes;
}

TEST(MaskPng, KeepsEveryPixel) {
  cv::Mat mask = sampleMask();
  EXPECT_EQ(cv::norm(throughPng(mask), mask, cv::NORM_INF), 0.0);
  mask(cv::Rect(100, 50, 37, 91)).setTo(128);
  EXPECT_EQ(cv::norm(throughPng(mask), mask, cv::NORM_INF), 0.0);
  const cv::Mat odd =
      mask(cv::Rect(3, 5, 253, 177));  // rows that are not whole bytes, nor adjacent
  EXPECT_EQ(cv::norm(throughPng(odd), odd, cv::NORM_INF), 0.0);
}

TEST(MaskPng, IsSmall) {
  cv::Mat mask = sampleMask();
  EXPECT_LT(compressedMask(mask, {}).data.size(), 3000u);
  mask(cv::Rect(100, 50, 37, 91)).setTo(128);
  EXPECT_LT(compressedMask(mask, {}).data.size(), 6000u);
}

TEST(MaskPng, IsReadByOtherToolsAsImageTransportWritesMono8) {
  const cv::Mat mask = sampleMask();
  const sensor_msgs::CompressedImage message = compressedMask(mask, {});
  EXPECT_EQ(message.format, "mono8; png compressed ");
  const cv::Mat image = cv::imdecode(message.data, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(image.type(), CV_8UC1);
  EXPECT_EQ(cv::norm(image, mask, cv::NORM_INF), 0.0);
}

TEST(MaskPng, OtherValuesArePersonPixels) {
  cv::Mat grey = sampleMask();
  grey.at<uint8_t>(7, 9) = 77;
  sensor_msgs::CompressedImage message;
  message.data = pngOf(grey);
  EXPECT_EQ(maskFromMessage(*maskFromCompressed(message)).at<uint8_t>(7, 9), 255);
}

TEST(MaskPng, WhatIsNoMaskIsRefused) {
  EXPECT_EQ(refusalOf({}),
            "compressed mask of frame \"cam3_optical\" cannot be read: it is not a PNG");
  std::vector<uint8_t> jpeg;
  cv::imencode(".jpg", sampleMask(), jpeg);
  EXPECT_NE(refusalOf(jpeg).find("it is not a PNG"), std::string::npos);
  for (const int type : {CV_8UC3, CV_16UC1})
    EXPECT_NE(refusalOf(pngOf(cv::Mat(48, 64, type, cv::Scalar::all(3)))).find("it is not grey"),
              std::string::npos);
}

TEST(MaskPng, AHeadThatPromisesTooMuchIsRefusedBeforeMemoryIsTaken) {
  std::vector<uint8_t> bytes = compressedMask(sampleMask(), {}).data;
  bytes[16] = 0x00, bytes[17] = 0x00, bytes[18] = 0xff, bytes[19] = 0xff;  // width
  bytes[20] = 0x00, bytes[21] = 0x00, bytes[22] = 0xff, bytes[23] = 0xff;  // height
  EXPECT_NE(refusalOf(bytes).find("its head says 65535 x 65535 pixels"), std::string::npos);
  bytes[16] = bytes[20] = 0xff;
  EXPECT_NE(refusalOf(bytes).find("pixels, allowed are 268435456"), std::string::npos);
  bytes[16] = bytes[20] = 0, bytes[18] = bytes[22] = 0x3f;
  EXPECT_NE(refusalOf(bytes).find("cannot hold them"), std::string::npos);
}

TEST(MaskPng, OneThatIsCutOrDamagedIsRefused) {
  const std::vector<uint8_t> whole = compressedMask(sampleMask(), {}).data;
  for (const size_t size : {size_t(33), whole.size() / 2, whole.size() - 30})
    EXPECT_NE(refusalOf({whole.begin(), whole.begin() + long(size)}).find("cannot be read"),
              std::string::npos)
        << size;
  std::vector<uint8_t> damaged = whole;
  for (size_t i = 60; i < 90; ++i) damaged[i] ^= 0x5a;
  EXPECT_NE(refusalOf(damaged).find("cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
