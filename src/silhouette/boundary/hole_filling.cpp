#include "silhouette/boundary/hole_filling.h"

#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/mask_runs.h"

namespace markerless_mocap {
namespace {

/// A hole can be false up to this many times the area of holes that are always filled.
constexpr int kMaxHoleFactor = 50;
/// If person and background differ by this (mean over channels, grey levels), a hole is real.
constexpr double kClear = 28;
/// Radius of the closing that finds gaps, px.
constexpr int kGapReach = 3;
/// Distance from a hole at which the person's colour is taken, px; nearer, blur mixes the colours.
constexpr int kAway = 2;

struct Contrast {
  double squares = 0;  ///< sum of squared differences of channels, grey levels
  int count = 0;       ///< number of channels added
};

/// Adds the contrast of the person at x with the background in the hole at `hole_x`, if the mask
/// has x.
void addContrast(const cv::Mat& image, const Background& background, double gain,
                 const BitMask& mask, int y, int x, int hole_x, Contrast* sum) {
  if (x < 0 || x >= image.cols || !mask.at(x, y)) return;
  const ModeRow expected = background.quantised(0, y);
  const int channels = image.channels();
  for (int c = 0; c < channels; ++c) {
    const double off = image.ptr(y)[x * channels + c] - gain * expected.mean[c][hole_x];
    sum->squares += off * off;
  }
  sum->count += channels;
}

}  // namespace

void fillFalseHoles(const cv::Mat& image, const Background& background, double gain,
                    int max_hole_px, BitMask* mask) {
  const int largest = kMaxHoleFactor * max_hole_px;
  if (largest == 0) return;
  const auto is_false_hole = [&](const std::vector<MaskRun>& hole) {
    Contrast sum;
    for (const MaskRun& run : hole) {
      addContrast(image, background, gain, *mask, run.y, run.first - kAway, run.first, &sum);
      addContrast(image, background, gain, *mask, run.y, run.last + kAway, run.last, &sum);
    }
    return sum.squares < kClear * kClear * sum.count;
  };
  BitMask gaps = eroded(dilated(*mask, kGapReach), kGapReach);
  gaps.remove(*mask);
  for (const std::vector<MaskRun>& gap : findBlobs(largest, gaps))
    if (is_false_hole(gap)) fillRuns(gap, mask);
  fillHoles(max_hole_px, largest, is_false_hole, mask);
}

}  // namespace markerless_mocap
