#include "ros/mask_png.h"

#include <png.h>
#include <sensor_msgs/image_encodings.h>
#include <zlib.h>

#include <boost/make_shared.hpp>
#include <csetjmp>
#include <stdexcept>
#include <string>
#include <vector>

#include "markerless_mocap/products/silhouette_mask.h"
#include "ros/png_head.h"
#include "text/printable.h"

namespace markerless_mocap {
namespace {

constexpr size_t kUsualBytes = 8192;

void append(png_structp png, png_bytep bytes, png_size_t count) {
  auto* out = static_cast<std::vector<uint8_t>*>(png_get_io_ptr(png));
  out->insert(out->end(), bytes, bytes + count);
}

void nothingToFlush(png_structp) {}

/// OpenCV's encoder knows neither one bit per pixel nor rows without a filter, which are quickest
/// and smallest here. Returns false if libpng cannot write. Nothing with a destructor lives where
/// it may leave.
bool writePng(const cv::Mat& mask, int depth, png_structp png, png_infop info,
              std::vector<uint8_t>* out) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, out, append, nothingToFlush);
  png_set_IHDR(png, info, png_uint_32(mask.cols), png_uint_32(mask.rows), depth,
               PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, Z_BEST_SPEED);
  png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_write_info(png, info);
  if (depth < 8) png_set_packing(png);  // of pixels that are not 0
  for (int y = 0; y < mask.rows; ++y) png_write_row(png, mask.ptr(y));
  png_write_end(png, info);
  return true;
}

/// Why the bytes are not those of a mask; empty if they may be.
std::string faultOfHead(const std::vector<uint8_t>& bytes) {
  if (!isPng(bytes)) return "it is not a PNG";
  const PngHead head = pngHead(bytes);
  if (head.depth > 8 || head.colors != PNG_COLOR_TYPE_GRAY)
    return "it is not grey of at most 8 bits per pixel";
  return refusalOf(head, bytes.size());
}

/// Sets all of a mono8 image but its header. Returns what is wrong with the PNG; empty: nothing.
/// OpenCV is as quick, but prints what is wrong.
std::string faultWhileReading(const std::vector<uint8_t>& bytes, sensor_msgs::Image* mask) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) return png.message;
  png.format = PNG_FORMAT_GRAY;
  mask->encoding = sensor_msgs::image_encodings::MONO8;
  mask->width = mask->step = png.width;
  mask->height = png.height;
  mask->data.resize(size_t(png.width) * png.height);
  const bool whole = png_image_finish_read(&png, nullptr, mask->data.data(), 0, nullptr) != 0;
  std::string fault = whole ? "" : png.message;
  png_image_free(&png);
  return fault;
}

}  // namespace

sensor_msgs::CompressedImage compressedMask(const cv::Mat& mask, const std_msgs::Header& header) {
  sensor_msgs::CompressedImage message;
  message.header = header;
  message.format = sensor_msgs::image_encodings::MONO8 + "; png compressed ";
  message.data.reserve(kUsualBytes);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool written =
      info && writePng(mask, hasUnknownPixels(mask) ? 8 : 1, png, info, &message.data);
  png_destroy_write_struct(&png, &info);
  if (!written) throw std::runtime_error("a mask cannot be written as PNG");
  return message;
}

sensor_msgs::ImagePtr maskFromCompressed(const sensor_msgs::CompressedImage& message) {
  auto mask = boost::make_shared<sensor_msgs::Image>();
  std::string refusal = faultOfHead(message.data);
  if (refusal.empty()) refusal = faultWhileReading(message.data, mask.get());
  if (!refusal.empty())
    throw std::invalid_argument("compressed mask of frame " + quoted(message.header.frame_id) +
                                " cannot be read: " + refusal);
  mask->header = message.header;
  return mask;
}

}  // namespace markerless_mocap
