#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace markerless_mocap {

/// No camera has so many pixels; images that say so are refused before memory is taken.
constexpr uint64_t kMaxPixels = uint64_t(1) << 28;

/// What a PNG file says of its image before any pixel.
struct PngHead {
  uint32_t width = 0, height = 0, depth = 0;  ///< px, px, bits of each channel
  uint32_t colors = 0;                        ///< colour type, PNG_COLOR_TYPE_...

  int channels() const;
};

/// Whether the bytes begin as a PNG file does, with a whole head.
bool isPng(const std::vector<uint8_t>& bytes);
/// \param bytes of which isPng() is true
PngHead pngHead(const std::vector<uint8_t>& bytes);
/// Why the bytes cannot hold so many pixels; empty if they may. To be asked before memory is taken.
std::string refusalOf(const PngHead& head, size_t bytes);

}  // namespace markerless_mocap
