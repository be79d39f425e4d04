#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"
#include "silhouette/shadow/shadow_evidence.h"

namespace markerless_mocap {

/// What a test says about each pixel.
struct PixelClasses {
  BitMask foreground;          ///< far from the background and no shadow
  BitMask shadow;              ///< a darker shade of the background
  std::vector<uint8_t> ratio;  ///< where `shade`: brightness relative to the background's, 255 = 1
  size_t changed = 0;          ///< pixels far from the background, without specks
};

/// Tells foreground from background and shadow. A shadow is darker than its background, of the same
/// colour, and of the same texture; in a grey image texture alone tells.
class PixelTest {
 public:
  /// \param gain light of the image relative to the background's. The result stays until the next
  ///   call.
  const PixelClasses& classify(const SilhouetteOptions& options, const cv::Mat& image,
                               const Background& background, double gain);

 private:
  void prepare(const Background& background);
  void findChanged(const cv::Mat& image, const Background& background, double gain);
  /// Of every `step`th row from `first` on, which is 0 or half of that: then the rows between are
  /// known.
  void findChangedRows(const cv::Mat& image, const Background& background, double gain, int first,
                       int step);
  /// Of row y, only in words that are wanted; row y + rows_ahead will follow.
  void findChanged(const cv::Mat& image, const Background& background, double gain, int y,
                   int rows_ahead);
  /// In which words of row y an opening may leave anything, judged by the rows so far above and
  /// below.
  void wantFor(int y, int apart);
  /// Of the rows of blocks' row `row`.
  void findShadows(const cv::Mat& image, const Background& background, double gain, int row);
  /// Of a word of row y; whether there are any.
  bool findShadows(const cv::Mat& image, const Background& background, double gain, int y, int word,
                   ShadowColumns* columns);

  SilhouetteOptions options_;
  PixelClasses classes_;
  ShadowBlocks blocks_;
  std::vector<uint8_t> now_, flags_;  ///< one row, channel after channel
  std::vector<uint16_t> squared_, other_;
  std::vector<uint64_t> wanted_;  ///< of a row, 0 where nothing is
};

/// `count` pixels of a row, channel after channel, `stride` bytes apart.
void splitRow(const cv::Mat& image, int y, int first, int count, int stride, uint8_t* planes);

}  // namespace markerless_mocap
