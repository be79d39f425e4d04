#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fleischmann/fitness/bit_image.h"

namespace markerless_mocap {

/// Corners of a convex quadrilateral in order around it, pixels; integers are pixel centres.
struct Quad {
  std::array<float, 4> x, y;
};

/// Number of drawn pixels, and number of those that are in the silhouette, too.
struct Overlap {
  int64_t drawn = 0, shared = 0;
};

/// Draws unions of convex quadrilaterals: a pixel is set if its centre lies in one of them or on
/// its border. Only the region that was drawn on is cleared and counted.
class QuadCanvas {
 public:
  QuadCanvas() = default;
  QuadCanvas(int width, int height);

  /// Clears the last drawing and draws the quadrilaterals. Corners may lie outside the canvas.
  void draw(const Quad* quads, int count);
  /// \param silhouette of the size of the canvas
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
  std::vector<int32_t> low_, high_;  // span of one quadrilateral in each row
};

}  // namespace markerless_mocap
