#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/background/pixel_test.h"

namespace markerless_mocap {

/// Finds what other light has changed: patches of sun, the light of a lamp, reflections in the
/// floor. There the texture of the background is still seen, brighter, darker or tinted, whereas a
/// person covers it. Plain surfaces cannot be told.
class KeptTexture {
 public:
  /// Makes foreground that shows the background's texture `lit`.
  /// \param gain light of the image relative to the background's
  void findLit(const cv::Mat& image, const Background& background, double gain,
               PixelClasses* classes);

 private:
  /// Sums over pixels: of the background (m), of the image (i), and of their products.
  struct Sums {
    bool is_filled = false;
    float n[3] = {}, m[3] = {}, i[3] = {}, mm[3] = {}, mi[3] = {}, ii[3] = {};
    void add(const float* expected, const float* now, int channels);
    void add(const Sums& other);
  };
  /// Image as a function of the background, around one block.
  struct Relation {
    bool is_sure = false;
    float offset[3] = {}, slope[3] = {};  ///< grey levels; image per background
  };

  /// Finds the blocks that surely show the texture, and remembers their light. Returns how many.
  int relateBlocks(int channels);
  void clearBlocks();
  void sumBlocks(const cv::Mat& image, const Background& background, float gain,
                 const BitMask& foreground);
  Sums around(const std::vector<Sums>& blocks, int column, int row) const;
  Relation relationOf(const Sums& sums, int channels) const;
  /// Whether a pixel is explained by a relation near its block, or by light that was seen before.
  bool isLit(const float* now, const float* expected, int channels, bool brighter, int column,
             int row) const;
  /// The same for one relation. \param most of the change that it describes
  bool explains(const Relation& relation, const float* now, const float* expected, int channels,
                float most) const;
  void moveLit(const cv::Mat& image, const Background& background, float gain,
               PixelClasses* classes) const;

  int images_ = 0;
  int last_found_ = -1;  ///< image in which such light was seen last; -1: never
  int columns_ = 0, rows_ = 0;
  float squared_noise_ = 0;
  std::vector<Sums> sums_[2];           ///< by block; of pixels darker and brighter than expected
  std::vector<Relation> relations_[2];  ///< the same
  std::vector<int> filled_[2];          ///< blocks with pixels, the same
  Relation light_[2];                   ///< mean change of light, the same
};

}  // namespace markerless_mocap
