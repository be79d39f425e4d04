#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/background/background.h"
#include "silhouette/background/pixel_test.h"
#include "silhouette/boundary/matting_kernels.h"

namespace markerless_mocap {

/// Moves the silhouette's boundary to where the image is half person, half background (alpha 0.5),
/// as blur and chroma subsampling spread the outline over several pixels. The person's colour is
/// taken from just inside, the background's from its model and from the shadow just outside.
class BoundaryMatting {
 public:
  /// \param gain light of the image relative to the background's
  /// \param classes of the image
  void refine(const cv::Mat& image, const Background& background, double gain,
              const PixelClasses& classes, BitMask* mask);

 private:
  /// Sums over a block of pixels or its neighbourhood; 16 bits hold 144 bytes.
  struct Sums {
    uint16_t color[3] = {};  ///< sum over the person's pixels
    uint16_t inside = 0;     ///< number of these pixels
    uint16_t light = 0;    ///< sum over the background's pixels of their brightness relative to the
                           ///< model, 255 for 1
    uint16_t outside = 0;  ///< number of these pixels
  };
  struct Block {
    int column, row;
  };
  struct Scene {
    const cv::Mat& image;
    const Background& background;
    float gain;
    const PixelClasses& classes;
  };

  /// Whether the kernels can process the block: it is whole, and in colour.
  static bool canUseKernels(const Scene& scene, int x, int y);
  static ColorBlock colorBlock(const Scene& scene, int x, int y);
  void findBlocks();
  void sumBlock(const Scene& scene, int column, int row);
  /// Sets alpha_ of the block's pixels to the value of the mask.
  void presetBlock(const BitMask& mask, int column, int row);
  /// Estimates alpha_ of the block's pixels, the fraction of the person; 255 for 1.
  void estimateBlock(const Scene& scene, const Sums& around, int column, int row);
  void estimatePixel(const Scene& scene, const MattingColors& colors, int x, int y);
  Sums around(int column, int row) const;
  void smooth(BitMask* mask) const;

  BitMask core_, band_, outer_;
  std::vector<Sums> sums_;      ///< one per block
  std::vector<uint8_t> kind_;   ///< one per block
  std::vector<Block> blocks_;   ///< those near the boundary or on it
  std::vector<uint8_t> alpha_;  ///< one per pixel
  int columns_ = 0, rows_ = 0;  ///< of blocks
  int stride_ = 0;              ///< of alpha_
};

}  // namespace markerless_mocap
