#include "ros/png_head.h"

#include <png.h>

#include <cstring>

namespace markerless_mocap {
namespace {

constexpr uint64_t kMaxRatio = 1100;  // that deflate reaches is 1032
constexpr size_t kHeadBytes = 26;     // signature and the head's length, name, size, depth, colours

uint32_t bigEndian(const uint8_t* bytes) {
  return uint32_t(bytes[0]) << 24 | uint32_t(bytes[1]) << 16 | uint32_t(bytes[2]) << 8 | bytes[3];
}

}  // namespace

int PngHead::channels() const {
  if (colors & PNG_COLOR_MASK_PALETTE) return 1;
  return (colors & PNG_COLOR_MASK_COLOR ? 3 : 1) + (colors & PNG_COLOR_MASK_ALPHA ? 1 : 0);
}

bool isPng(const std::vector<uint8_t>& bytes) {
  constexpr char kStart[] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR";
  return bytes.size() >= kHeadBytes && std::memcmp(bytes.data(), kStart, sizeof kStart - 1) == 0;
}

PngHead pngHead(const std::vector<uint8_t>& bytes) {
  return {bigEndian(&bytes[16]), bigEndian(&bytes[20]), bytes[24], bytes[25]};
}

std::string refusalOf(const PngHead& head, size_t bytes) {
  const uint64_t pixels = uint64_t(head.width) * head.height;
  // Divided, because the product may overflow.
  const uint64_t row = uint64_t(head.width) * head.depth * uint64_t(head.channels()) / 8 + 1;
  if (pixels > 0 && pixels <= kMaxPixels && row <= kMaxRatio * bytes / head.height) return "";
  return "its head says " + std::to_string(head.width) + " x " + std::to_string(head.height) +
         " pixels, " +
         (pixels > kMaxPixels ? "allowed are " + std::to_string(kMaxPixels)
                              : "its " + std::to_string(bytes) + " bytes cannot hold them");
}

}  // namespace markerless_mocap
