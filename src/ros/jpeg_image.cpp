#include "ros/jpeg_image.h"

#include <csetjmp>
#include <cstdio>
// After <cstdio>, which it needs.
#include <jpeglib.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

#include "ros/png_head.h"

namespace markerless_mocap {
namespace {

/// A block of 8 x 8 pixels takes at least a bit.
constexpr uint64_t kMaxPixelsPerByte = 512;

/// What libjpeg finds wrong. Warnings are about data that it replaces by a guess: nothing is
/// decoded after one, as a short file may promise very many pixels.
struct Faults {
  jpeg_error_mgr manager;  // first, as libjpeg hands on its address
  std::jmp_buf leave;
  char text[JMSG_LENGTH_MAX] = "";
};

void leaveDecoder(j_common_ptr common) {
  auto* faults = reinterpret_cast<Faults*>(common->err);
  faults->manager.format_message(common, faults->text);
  std::longjmp(faults->leave, 1);
}

void noteMessage(j_common_ptr common, int level) {
  if (level < 0) leaveDecoder(common);
}

void ignoreText(j_common_ptr) {}

class Decoder {
 public:
  Decoder() {
    jpeg_.err = jpeg_std_error(&faults_.manager);
    faults_.manager.error_exit = leaveDecoder;
    faults_.manager.emit_message = noteMessage;
    faults_.manager.output_message = ignoreText;
  }
  ~Decoder() { jpeg_destroy_decompress(&jpeg_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// Returns false if it cannot go on. Nothing with a destructor lives where it may leave.
  bool readHead(const std::vector<uint8_t>& bytes) {
    if (setjmp(faults_.leave) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_mem_src(&jpeg_, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_save_markers(&jpeg_, JPEG_APP0 + 1, 64);
    jpeg_read_header(&jpeg_, TRUE);
    jpeg_.out_color_space = channels() == 1 ? JCS_GRAYSCALE : JCS_EXT_BGR;
    return true;
  }
  /// Call this before readPixels(). \param reduction 1, 2, 4 or 8
  void reduce(int reduction) {
    jpeg_.scale_num = 1;
    jpeg_.scale_denom = unsigned(reduction);
  }
  bool readPixels(cv::Mat* image) {
    if (setjmp(faults_.leave) != 0) return false;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = image->ptr(int(jpeg_.output_scanline));
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }
  int channels() const { return jpeg_.num_components == 1 ? 1 : 3; }
  /// CMYK, or with EXIF data, which may turn the image: left to OpenCV.
  bool isUnusual() const { return jpeg_.num_components > 3 || jpeg_.marker_list != nullptr; }
  cv::Size size() const { return {int(jpeg_.image_width), int(jpeg_.image_height)}; }
  std::string fault() const { return faults_.text; }

 private:
  jpeg_decompress_struct jpeg_{};
  Faults faults_{};
};

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("the JPEG is incomplete or damaged (" + why + ")");
}

}  // namespace

bool isJpeg(const std::vector<uint8_t>& bytes) {
  return bytes.size() > 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

cv::Mat decodedJpeg(const std::vector<uint8_t>& bytes) {
  cv::Size whole;
  return decodedJpeg(
      bytes, [](const cv::Size&) { return 1; }, &whole);
}

cv::Mat decodedJpeg(const std::vector<uint8_t>& bytes, const ReductionRule& rule, cv::Size* whole) {
  Decoder decoder;
  if (!decoder.readHead(bytes)) refuse(decoder.fault());
  const cv::Size size = decoder.size();
  const uint64_t pixels = uint64_t(size.width) * uint64_t(size.height);
  if (pixels > kMaxPixels || pixels / kMaxPixelsPerByte > bytes.size())
    refuse("its head says " + std::to_string(size.width) + " x " + std::to_string(size.height) +
           " pixels, allowed are " +
           std::to_string(std::min(kMaxPixels, kMaxPixelsPerByte * bytes.size())) + " in " +
           std::to_string(bytes.size()) + " bytes");
  if (decoder.isUnusual()) {
    cv::Mat image = cv::imdecode(bytes, cv::IMREAD_ANYCOLOR);
    *whole = image.size();
    return image;
  }
  *whole = size;
  const int wanted = rule(size), reduction = wanted == 2 || wanted == 4 || wanted == 8 ? wanted : 1;
  decoder.reduce(reduction);
  cv::Mat image((size.height + reduction - 1) / reduction, (size.width + reduction - 1) / reduction,
                CV_MAKETYPE(CV_8U, decoder.channels()));
  if (!decoder.readPixels(&image)) refuse(decoder.fault());
  return image;
}

}  // namespace markerless_mocap
