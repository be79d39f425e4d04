#include "ros/image_conversions.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

std_msgs::Header header() {
  std_msgs::Header h;
  h.frame_id = "cam3_optical";
  h.stamp = ros::Time(1000, 5);
  return h;
}

cv::Mat colorPixels() {
  cv::Mat image(2, 3, CV_8UC3, cv::Scalar(10, 20, 30));
  image.at<cv::Vec3b>(1, 2) = {200, 100, 50};
  return image;
}

TEST(ImageConversions, ColourImageComesBackAsItWas) {
  const sensor_msgs::Image message = messageFromMat(colorPixels(), header());
  EXPECT_EQ(message.encoding, "bgr8");
  EXPECT_EQ(message.header.stamp, ros::Time(1000, 5));
  EXPECT_EQ(cv::norm(matFromMessage(message), colorPixels(), cv::NORM_INF), 0.0);
}

TEST(ImageConversions, Rgb8BecomesBlueGreenRed) {
  sensor_msgs::Image message = messageFromMat(colorPixels(), header());
  message.encoding = "rgb8";
  EXPECT_EQ(matFromMessage(message).at<cv::Vec3b>(1, 2), cv::Vec3b(50, 100, 200));
}

TEST(ImageConversions, GreyStaysOneChannel) {
  const cv::Mat grey(2, 2, CV_8UC1, cv::Scalar(7));
  const cv::Mat back = matFromMessage(messageFromMat(grey, header()));
  ASSERT_EQ(back.type(), CV_8UC1);
  EXPECT_EQ(back.at<uchar>(1, 1), 7);
}

TEST(ImageConversions, ResultOutlivesTheMessage) {
  cv::Mat back;
  {
    const sensor_msgs::Image message = messageFromMat(colorPixels(), header());
    back = matFromMessage(message);
  }
  EXPECT_EQ(back.at<cv::Vec3b>(1, 2), cv::Vec3b(200, 100, 50));
}

TEST(ImageConversions, UnknownEncodingIsNamedWithTheCamera) {
  sensor_msgs::Image message = messageFromMat(colorPixels(), header());
  message.encoding = "32FC3";
  const std::string sentence = errorTextOf([&] { matFromMessage(message); });
  EXPECT_NE(sentence.find("cam3_optical"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("\"32FC3\", allowed are mono8, bgr8, rgb8"), std::string::npos)
      << sentence;
}

TEST(ImageConversions, WordsOfAMessageAreQuotedShortAndInOneLine) {
  sensor_msgs::Image message = messageFromMat(colorPixels(), header());
  message.encoding = "bg\nr8\x1b[31m" + std::string(100000, 'q');
  const std::string sentence = errorTextOf([&] { matFromMessage(message); });
  EXPECT_NE(sentence.find("the encoding \"bg r8?[31mqq"), std::string::npos) << sentence;
  EXPECT_LT(sentence.size(), 300u);
}

TEST(ImageConversions, BigEndianPixelsOf16BitsAreRefused) {
  sensor_msgs::Image message;
  message.width = message.height = 2;
  message.encoding = "mono16";
  message.step = 4;
  message.data.assign(8, 1);
  message.is_bigendian = 1;
  const std::string sentence = errorTextOf([&] { matFromMessage(message); });
  EXPECT_NE(sentence.find("its pixels of 16 bits are big-endian, allowed is little-endian"),
            std::string::npos)
      << sentence;
  message.is_bigendian = 0;
  EXPECT_EQ(matFromMessage(message).at<uchar>(1, 1), 1);
}

/// A picture of one colour as a sensor behind that pattern of filters sees it.
sensor_msgs::Image mosaic(const std::string& encoding, const std::string& filters) {
  cv::Mat raw(8, 8, CV_8UC1);
  for (int y = 0; y < raw.rows; ++y)
    for (int x = 0; x < raw.cols; ++x) {
      const char filter = filters[size_t(2 * (y % 2) + x % 2)];
      raw.at<uchar>(y, x) = filter == 'r' ? 200 : filter == 'g' ? 100 : 50;
    }
  sensor_msgs::Image message = messageFromMat(raw, header());
  message.encoding = encoding;
  return message;
}

TEST(ImageConversions, BayerPatternsBecomeBlueGreenRed) {
  for (const std::string filters : {"rggb", "bggr", "gbrg", "grbg"}) {
    const cv::Mat image = matFromMessage(mosaic("bayer_" + filters + "8", filters));
    ASSERT_EQ(image.type(), CV_8UC3) << filters;
    EXPECT_EQ(image.at<cv::Vec3b>(4, 4), cv::Vec3b(50, 100, 200)) << filters;
    EXPECT_EQ(image.at<cv::Vec3b>(3, 4), cv::Vec3b(50, 100, 200)) << filters;
  }
}

TEST(ImageConversions, BayerOf16BitsIsRefused) {
  const std::string sentence = errorTextOf([] { matFromMessage(mosaic("bayer_rggb16", "rggb")); });
  EXPECT_NE(sentence.find("\"bayer_rggb16\", allowed are"), std::string::npos) << sentence;
}

TEST(ImageConversions, TruncatedDataIsRefused) {
  sensor_msgs::Image message = messageFromMat(colorPixels(), header());
  message.data.resize(5);
  EXPECT_THROW(matFromMessage(message), std::invalid_argument);
}

TEST(ImageConversions, SizesThatWrapIn32BitsAreRefused) {
  sensor_msgs::Image message = messageFromMat(colorPixels(), header());
  const auto refuses = [&](uint32_t width, uint32_t height, uint32_t step, size_t bytes) {
    message.width = width, message.height = height, message.step = step;
    message.data.assign(bytes, 7);
    return errorTextOf([&] { matFromMessage(message); });
  };
  EXPECT_EQ(
      refuses(21845, 65537, 65536, 65536),
      "image of frame \"cam3_optical\" cannot be read: 21845 x 65537 pixels \"bgr8\" in rows of "
      "65536 bytes do not fit its 65536 bytes");
  EXPECT_NE(refuses(1431655767, 2, 10, 20), "") << "three times this is 2^32 + 5";
  EXPECT_NE(refuses(20000, 20000, 60000, 20), "");
  EXPECT_NE(refuses(3, 2, 8, 16), "");
  EXPECT_NE(refuses(0, 0, 0, 0).find("it has no pixels"), std::string::npos);
  message.encoding = "mono8";
  EXPECT_NE(errorTextOf([&] { maskFromMessage(message); }).find("it has no pixels"),
            std::string::npos);
  message.width = message.height = message.step = 1u << 16;
  message.data.clear();
  EXPECT_NE(errorTextOf([&] { maskFromMessage(message); }).find("do not fit its 0 bytes"),
            std::string::npos);
  EXPECT_FALSE(hasUnknownBackground(message));
}

TEST(ImageConversions, APngThatPromisesTooMuchIsRefused) {
  sensor_msgs::CompressedImage message;
  message.header = header();
  cv::imencode(".png", colorPixels(), message.data);
  message.data[18] = message.data[22] = 0x3e;
  const std::string sentence = errorTextOf([&] { matFromMessage(message); });
  EXPECT_NE(sentence.find("cam3_optical"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("its head says 15875 x 15874 pixels"), std::string::npos) << sentence;
}

TEST(ImageConversions, CompressedImageIsDecoded) {
  sensor_msgs::CompressedImage message;
  message.format = "png";
  cv::imencode(".png", colorPixels(), message.data);
  EXPECT_EQ(cv::norm(matFromMessage(message), colorPixels(), cv::NORM_INF), 0.0);
}

TEST(ImageConversions, CompressedGreyStaysOneChannel) {
  sensor_msgs::CompressedImage message;
  cv::imencode(".png", cv::Mat(4, 4, CV_8UC1, cv::Scalar(90)), message.data);
  EXPECT_EQ(matFromMessage(message).type(), CV_8UC1);
}

TEST(ImageConversions, RubbishAndNothingAreNotDecoded) {
  sensor_msgs::CompressedImage message;
  message.header = header();
  EXPECT_THROW(matFromMessage(message), std::invalid_argument);
  message.data = {1, 2, 3, 4};
  EXPECT_THROW(matFromMessage(message), std::invalid_argument);
}

TEST(ImageConversions, MaskIsBackgroundPersonOrUnknown) {
  const cv::Mat mask = (cv::Mat_<uchar>(1, 6) << 0, 1, 127, 128, 129, 255);
  const cv::Mat back = maskFromMessage(messageFromMat(mask, header()));
  const cv::Mat expected = (cv::Mat_<uchar>(1, 6) << 0, 255, 255, 128, 255, 255);
  EXPECT_EQ(cv::norm(back, expected, cv::NORM_INF), 0.0);
}

TEST(ImageConversions, AMessageTellsWhetherItsBackgroundIsUnknown) {
  cv::Mat mask(40, 50, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(10, 10, 8, 20)).setTo(255);
  EXPECT_FALSE(hasUnknownBackground(messageFromMat(mask, header())));
  mask(cv::Rect(20, 10, 8, 20)).setTo(128);
  sensor_msgs::Image message = messageFromMat(mask, header());
  EXPECT_TRUE(hasUnknownBackground(message));
  message.data.resize(10);
  EXPECT_FALSE(hasUnknownBackground(message));
  EXPECT_FALSE(hasUnknownBackground(messageFromMat(colorPixels(), header())));
}

TEST(ImageConversions, UnknownPixelsOfAMaskStayUnknown) {
  const cv::Mat mask(2, 2, CV_8UC1, cv::Scalar(128));
  EXPECT_EQ(cv::countNonZero(maskFromMessage(messageFromMat(mask, header())) != 128), 0);
}

TEST(ImageConversions, ColourImageIsNoMask) {
  EXPECT_THROW(maskFromMessage(messageFromMat(colorPixels(), header())), std::invalid_argument);
}

TEST(ImageConversions, FloatImageIsNotPublished) {
  EXPECT_THROW(messageFromMat(cv::Mat(2, 2, CV_32FC1, cv::Scalar(0)), header()),
               std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
