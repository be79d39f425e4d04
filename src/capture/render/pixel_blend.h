#pragma once

#include "capture/render/room_view.h"
#include "capture/render/triangle_rasterizer.h"

namespace markerless_mocap {

/// What the nine samples of a pixel show of objects.
struct PixelBlend {
  int covered = 0;         ///< 0 to kTentSum
  int sum[3] = {0, 0, 0};  ///< blue, green, red times the weights

  PixelBlend(const SampleBuffer& buffer, int x, int y) {
    for (int v = -1; v <= 1; ++v) {
      const Sample* const samples = buffer.row(2 * y + 1 + v) + 2 * x + 1;
      for (int u = -1; u <= 1; ++u) {
        if (samples[u].kind == Sample::kNothing) continue;
        const int fraction = kTent[std::abs(u) + std::abs(v)];
        covered += fraction;
        for (int i = 0; i < 3; ++i) sum[i] += fraction * samples[u].bgr[i];
      }
    }
  }
};

/// Calls `use(x, y)` for the pixels all of whose samples are in the buffer.
template <class UseT>
void forEachPixel(const SampleBuffer& buffer, const UseT& use) {
  if (buffer.rect.empty()) return;
  for (int y = buffer.rect.y / 2; 2 * y + 2 < buffer.rect.br().y; ++y)
    for (int x = buffer.rect.x / 2; 2 * x + 2 < buffer.rect.br().x; ++x) use(x, y);
}

}  // namespace markerless_mocap
