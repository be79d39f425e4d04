#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/background/background.h"
#include "silhouette/background/pixel_test.h"
#include "silhouette/boundary/matting_kernels.h"

namespace markerless_mocap {

/// Sets the silhouette's rim to where an image is half person, half background: blur and chroma
/// subsampling smear the outline over its neighbours. What the person looks like is taken from just
/// inside, the background from its model and the shadow just outside.
class BoundaryMatting {
 public:
  /// \param gain light of the image relative to the background's \param classes of the image
  void refine(const cv::Mat& image, const Background& background, double gain,
              const PixelClasses& classes, BitMask* mask);

 private:
  /// What lies in a block of pixels or near it: 144 bytes fit.
  struct Sums {
    uint16_t color[3] = {};  ///< of the person's pixels
    uint16_t inside = 0;     ///< how many
    uint16_t light = 0;      ///< brightness of the background's pixels, 255 as in their model
    uint16_t outside = 0;    ///< how many
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

  /// Whether the block's colours can be looked at all at once.
  static bool isQuick(const Scene& scene, int x, int y);
  static ColorBlock colorBlock(const Scene& scene, int x, int y);
  void findBlocks();
  void sumBlock(const Scene& scene, int column, int row);
  /// The pixels' share of the person as the mask has it, into share_.
  void presetBlock(const BitMask& mask, int column, int row);
  /// The pixels' share of the person, 255 = all, into share_.
  void estimateBlock(const Scene& scene, const Sums& around, int column, int row);
  void estimatePixel(const Scene& scene, const MattingColors& colors, int x, int y);
  Sums around(int column, int row) const;
  void smooth(BitMask* mask) const;

  BitMask core_, band_, outer_;
  std::vector<Sums> sums_;      ///< a block each
  std::vector<uint8_t> kind_;   ///< a block each
  std::vector<Block> blocks_;   ///< those near the rim or on it
  std::vector<uint8_t> alpha_;  ///< a pixel each
  int columns_ = 0, rows_ = 0;  ///< of blocks
  int stride_ = 0;              ///< of share_
};

}  // namespace markerless_mocap
