#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"
#include "silhouette/shadow/shadow_evidence.h"

namespace markerless_mocap {

/// Result of the test of each pixel.
struct PixelClasses {
  BitMask foreground;  ///< differs from the background and is no shadow
  BitMask shadow;      ///< a shadow: a darker version of the background
  /// For pixels of `shadow`: brightness relative to the background's, 255 = 1.
  std::vector<uint8_t> ratio;
  /// Background in another light than its model's, brighter or darker; without rows: none.
  BitMask lit = BitMask();
  size_t changed = 0;  ///< number of pixels that differ from the background, without specks
};

/// Classifies pixels as foreground, background or shadow. A shadow is darker than the background
/// and has its colour and texture; in a grey image only its texture.
class PixelTest {
 public:
  /// \param gain light of the image relative to the background's. The result is valid until the
  ///   next call.
  PixelClasses& classify(const SilhouetteOptions& options, const cv::Mat& image,
                         const Background& background, double gain);

 private:
  void prepare(const Background& background);
  void findChanged(const cv::Mat& image, const Background& background, double gain);
  /// Tests every `step`-th row from `first` on. `first` is 0, or half of `step`: then the rows
  /// between have been tested.
  void findChangedRows(const cv::Mat& image, const Background& background, double gain, int first,
                       int step);
  /// Tests the selected words of row y. Row y + rows_ahead comes next and is prefetched.
  void findChanged(const cv::Mat& image, const Background& background, double gain, int y,
                   int rows_ahead);
  /// Selects the words of row y in which pixels may remain after the opening, from the rows `apart`
  /// above and below.
  void selectWords(int y, int apart);
  /// Finds the shadows in the pixel rows of the row of blocks `row`.
  void findShadows(const cv::Mat& image, const Background& background, double gain, int row);
  /// Finds the shadows in one word of row y; returns whether there are any.
  bool findShadows(const cv::Mat& image, const Background& background, double gain, int y, int word,
                   ShadowColumns* columns);

  SilhouetteOptions options_;
  PixelClasses classes_;
  ShadowBlocks blocks_;
  std::vector<uint8_t> now_, flags_;  ///< one row, one channel after the other
  std::vector<uint16_t> squared_, other_;
  std::vector<uint64_t> wanted_;  ///< of a row; 0 where no pixel differs
};

/// Splits `count` pixels of a row into planes of one channel each, `stride` bytes apart.
void splitRow(const cv::Mat& image, int y, int first, int count, int stride, uint8_t* planes);

}  // namespace markerless_mocap
