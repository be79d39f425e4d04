#include "silhouette/boundary/hole_filling.h"

#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/mask_runs.h"

namespace markerless_mocap {
namespace {

/// A larger hole is no miss, times the largest that is filled anyhow.
constexpr int kLargestMiss = 50;
/// Mean difference of a channel, grey levels, from which on a person is not missed.
constexpr double kClear = 28;
/// Radius of the closing that shows gaps, px.
constexpr int kGapReach = 3;
/// How far from a hole the person is looked at, px: nearer the outline is smeared.
constexpr int kAway = 2;

struct Contrast {
  double squares = 0;  ///< of the channels' differences, grey levels
  int count = 0;       ///< of channels
};

/// Of the person at x and the background in its hole at `hole_x`, if the mask has x.
void addContrast(const cv::Mat& image, const Background& background, double gain,
                 const BitMask& mask, int y, int x, int hole_x, Contrast* sum) {
  if (x < 0 || x >= image.cols || !mask.at(x, y)) return;
  const ModeRow expected = background.coarse(0, y);
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
  const int largest = kLargestMiss * max_hole_px;
  if (largest == 0) return;
  const auto is_missed = [&](const std::vector<MaskRun>& hole) {
    Contrast sum;
    for (const MaskRun& run : hole) {
      addContrast(image, background, gain, *mask, run.y, run.first - kAway, run.first, &sum);
      addContrast(image, background, gain, *mask, run.y, run.last + kAway, run.last, &sum);
    }
    return sum.squares < kClear * kClear * sum.count;
  };
  BitMask gaps = eroded(dilated(*mask, kGapReach), kGapReach);
  for (size_t i = 0; i < gaps.words().size(); ++i) gaps.words()[i] &= ~mask->words()[i];
  for (const std::vector<MaskRun>& gap : findBlobs(largest, gaps))
    if (is_missed(gap)) fillRuns(gap, mask);
  fillHoles(max_hole_px, largest, is_missed, mask);
}

}  // namespace markerless_mocap
