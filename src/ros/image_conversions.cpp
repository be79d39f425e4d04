#include "ros/image_conversions.h"

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "markerless_mocap/products/silhouette_mask.h"
#include "ros/png_head.h"
#include "text/printable.h"

namespace markerless_mocap {

namespace encodings = sensor_msgs::image_encodings;

namespace {

bool isMask(const sensor_msgs::Image& message) {
  return message.encoding == encodings::MONO8 || message.encoding == encodings::TYPE_8UC1;
}

bool isBayer8(const std::string& encoding) {
  return encoding == encodings::BAYER_RGGB8 || encoding == encodings::BAYER_BGGR8 ||
         encoding == encodings::BAYER_GBRG8 || encoding == encodings::BAYER_GRBG8;
}

/// Encoding of the converted pixels.
const std::string& usableEncoding(const sensor_msgs::Image& message) {
  const bool usable = encodings::isMono(message.encoding) || encodings::isColor(message.encoding) ||
                      isBayer8(message.encoding);
  if (!usable)
    throw std::invalid_argument(
        "image of frame " + quoted(message.header.frame_id) + " has the encoding " +
        quoted(message.encoding) +
        ", allowed are mono8, bgr8, rgb8, bayer_....8 and encodings that convert to them");
  return encodings::isMono(message.encoding) ? encodings::MONO8 : encodings::BGR8;
}

/// Throws if the data are not those of the size and encoding. cv_bridge multiplies in 32 bits, so
/// it takes images of 2^32 bytes more than there are; what is big-endian it takes for bytes.
void checkLayout(const sensor_msgs::Image& message) {
  if (message.is_bigendian && encodings::bitDepth(message.encoding) > 8)
    throw std::invalid_argument("its pixels of " +
                                std::to_string(encodings::bitDepth(message.encoding)) +
                                " bits are big-endian, allowed is little-endian");
  const uint64_t pixel = uint64_t(encodings::bitDepth(message.encoding) / 8 *
                                  encodings::numChannels(message.encoding));
  const uint64_t pixels = uint64_t(message.width) * message.height;
  if (pixels == 0) throw std::invalid_argument("it has no pixels");
  const bool agrees = pixels <= kMaxPixels && message.width * pixel <= message.step &&
                      uint64_t(message.step) * message.height == message.data.size();
  if (!agrees)
    throw std::invalid_argument(
        std::to_string(message.width) + " x " + std::to_string(message.height) + " pixels \"" +
        message.encoding + "\" in rows of " + std::to_string(message.step) +
        " bytes do not fit its " + std::to_string(message.data.size()) + " bytes");
}

/// \param encoding of the result; empty: that of the message
cv::Mat sharedPixels(const sensor_msgs::Image& message, const std::string& encoding) {
  try {
    checkLayout(message);
    return cv_bridge::toCvShare(message, nullptr, encoding)->image;
  } catch (const std::exception& error) {  // from cv_bridge or OpenCV
    throw std::invalid_argument("image of frame " + quoted(message.header.frame_id) +
                                " cannot be read: " + error.what());
  }
}

}  // namespace

cv::Mat sharedMatFromMessage(const sensor_msgs::Image& message) {
  return sharedPixels(message, usableEncoding(message));
}

cv::Mat matFromMessage(const sensor_msgs::Image& message) {
  const cv::Mat image = sharedMatFromMessage(message);
  return image.data == message.data.data() ? image.clone() : image;
}

cv::Mat matFromMessage(const sensor_msgs::CompressedImage& message) {
  cv::Size whole;
  return matFromMessage(
      message, [](const cv::Size&) { return 1; }, &whole);
}

cv::Mat matFromMessage(const sensor_msgs::CompressedImage& message, const ReductionRule& rule,
                       cv::Size* whole) {
  const std::string subject = "compressed image of frame " + quoted(message.header.frame_id);
  cv::Mat image;
  try {
    if (isJpeg(message.data)) {
      image = decodedJpeg(message.data, rule, whole);
    } else if (isPng(message.data)) {
      const std::string refusal = refusalOf(pngHead(message.data), message.data.size());
      if (!refusal.empty()) throw std::invalid_argument(refusal);
      image = cv::imdecode(message.data, cv::IMREAD_ANYCOLOR);
      *whole = image.size();
    }
  } catch (const std::exception& error) {  // from decodedJpeg() or OpenCV
    throw std::invalid_argument(subject + " cannot be decoded: " + error.what());
  }
  if (image.empty())
    throw std::invalid_argument(subject + " with format " + quoted(message.format) +
                                " cannot be decoded, allowed are whole JPEG and PNG files");
  return image;
}

bool hasUnknownBackground(const sensor_msgs::Image& message) {
  if (!isMask(message)) return false;
  try {
    return hasUnknownBackground(sharedPixels(message, ""));
  } catch (const std::invalid_argument&) {
    return false;
  }
}

cv::Mat maskFromMessage(const sensor_msgs::Image& message) {
  if (!isMask(message))
    throw std::invalid_argument("silhouette of frame " + quoted(message.header.frame_id) +
                                " has the encoding " + quoted(message.encoding) +
                                ", allowed is mono8");
  return maskOfThreeValues(sharedPixels(message, ""));
}

sensor_msgs::Image messageFromMat(const cv::Mat& image, const std_msgs::Header& header) {
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3)
    throw std::invalid_argument("an image of OpenCV type " + std::to_string(image.type()) +
                                " cannot be published, allowed are CV_8UC1 and CV_8UC3");
  const std::string& encoding = image.type() == CV_8UC1 ? encodings::MONO8 : encodings::BGR8;
  sensor_msgs::Image message;
  cv_bridge::CvImage(header, encoding, image).toImageMsg(message);
  return message;
}

}  // namespace markerless_mocap
