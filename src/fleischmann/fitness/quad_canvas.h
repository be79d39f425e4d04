#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fleischmann/fitness/bit_image.h"

namespace markerless_mocap {

/// Corners of a convex quadrilateral in order around it, pixels; whole numbers are pixel centres.
struct Quad {
  std::array<float, 4> x, y;
};

/// Pixels of a drawing, and how many of them the silhouette has too.
struct Overlap {
  int64_t drawn = 0, shared = 0;
};

/// Draws unions of convex quads: a pixel is set when its centre lies in one of them, borders
/// included. Only the part that was drawn on is cleared and counted.
class QuadCanvas {
 public:
  QuadCanvas() = default;
  QuadCanvas(int width, int height);

  /// Clears the last drawing and draws this one. Corners may lie anywhere.
  void draw(const Quad* quads, int count);
  /// \param silhouette of the canvas's size
  Overlap overlap(const BitImage& silhouette) const;
  const BitImage& image() const { return image_; }

 private:
  struct Window {
    int first_column = 0, columns = 0, first_row = 0, rows = 0;
  };
  struct Placed;
  static bool place(const Quad& quad, int width, int height, Placed& out);
  void fill(const Placed& quad);

  BitImage image_;
  Window window_;
  std::vector<int32_t> low_, high_;  // spans of one quad by row
};

}  // namespace markerless_mocap
