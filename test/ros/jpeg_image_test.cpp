#include "ros/jpeg_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "error_text_of.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

cv::Mat noise(int type) {
  cv::Mat image(97, 131, type);
  cv::theRNG().state = 7;
  cv::randu(image, 0, 255);
  return image;
}

std::vector<uint8_t> jpegOf(const cv::Mat& image) {
  std::vector<uint8_t> bytes;
  cv::imencode(".jpg", image, bytes);
  return bytes;
}

TEST(JpegImage, IsDecodedAsOpenCvDoes) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const std::vector<uint8_t> bytes = jpegOf(noise(type));
    const cv::Mat expected = cv::imdecode(bytes, cv::IMREAD_ANYCOLOR);
    const cv::Mat image = decodedJpeg(bytes);
    ASSERT_EQ(image.type(), expected.type());
    EXPECT_EQ(cv::norm(image, expected, cv::NORM_INF), 0.0);
  }
}

TEST(JpegImage, ComesSmallerIfTheRuleSaysSo) {
  cv::Mat scene = noise(CV_8UC3);
  cv::GaussianBlur(scene, scene, {0, 0}, 8);
  const std::vector<uint8_t> bytes = jpegOf(scene);
  for (const int reduction : {1, 2, 3, 4, 8}) {
    const auto rule = [&](const cv::Size& size) {
      EXPECT_EQ(size, scene.size());
      return reduction;
    };
    cv::Size whole;
    const cv::Mat image = decodedJpeg(bytes, rule, &whole);
    EXPECT_EQ(whole, scene.size());
    if (reduction == 3) {
      EXPECT_EQ(image.size(), scene.size()) << "the decoder cannot do this";
      continue;
    }
    ASSERT_EQ(image.size(),
              cv::Size((131 + reduction - 1) / reduction, (97 + reduction - 1) / reduction));
    cv::Mat expected;
    cv::resize(scene, expected, {131 / reduction, 97 / reduction}, 0, 0, cv::INTER_AREA);
    const cv::Rect inside(cv::Point(), expected.size());
    EXPECT_LT(cv::norm(image(inside), expected, cv::NORM_L1) / double(3 * inside.area()), 2.0)
        << reduction;
  }
}

TEST(JpegImage, OneWithoutItsEndIsRefused) {
  const std::vector<uint8_t> whole = jpegOf(noise(CV_8UC3));
  for (const size_t size : {size_t(4), whole.size() / 10, whole.size() / 2, whole.size() - 40}) {
    const std::vector<uint8_t> part(whole.begin(), whole.begin() + long(size));
    ASSERT_TRUE(isJpeg(part));
    EXPECT_NE(errorTextOf([&] { decodedJpeg(part); }).find("incomplete or damaged"),
              std::string::npos)
        << size;
  }
}

TEST(JpegImage, AHeadThatPromisesTooMuchIsRefused) {
  std::vector<uint8_t> bytes = jpegOf(noise(CV_8UC3));
  const uint8_t size[] = {0, 97, 0, 131};
  const auto at = std::search(bytes.begin(), bytes.end(), std::begin(size), std::end(size));
  ASSERT_NE(at, bytes.end());
  at[0] = at[2] = 0x3f;
  const std::string sentence = errorTextOf([&] { decodedJpeg(bytes); });
  EXPECT_NE(sentence.find("its head says 16259 x 16225 pixels, allowed are"), std::string::npos)
      << sentence;
}

TEST(JpegImage, MostOfThoseWithWrongBytesAreRefused) {
  const std::vector<uint8_t> whole = jpegOf(noise(CV_8UC3));
  int refused = 0;
  for (size_t at = 700; at + 200 < whole.size(); at += whole.size() / 40) {
    std::vector<uint8_t> damaged = whole;
    for (size_t i = 0; i < 64; ++i) damaged[at + i] = uint8_t(damaged[at + i] * 7 + 13);
    try {
      decodedJpeg(damaged);
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  EXPECT_GE(refused, 35);
}

TEST(JpegImage, AMessageSaysWhatIsWrong) {
  sensor_msgs::CompressedImage message;
  message.header.frame_id = "cam3_optical";
  message.data = jpegOf(noise(CV_8UC3));
  EXPECT_EQ(matFromMessage(message).cols, 131);
  message.data.resize(message.data.size() / 2);
  const std::string sentence = errorTextOf([&] { matFromMessage(message); });
  EXPECT_NE(sentence.find("cam3_optical"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("incomplete or damaged"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace markerless_mocap
