#include <opencv2/imgproc.hpp>

#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {
namespace {

cv::Mat disk(int radius) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
}

/// Sets all pixels of those components of `mask` that `chosen(stats row)` picks to `value`.
template <class Chosen>
void paintComponents(const cv::Mat& components_of, int connectivity, uint8_t value, Chosen chosen,
                     cv::Mat* mask) {
  cv::Mat labels, stats, centroids;
  const int count =
      cv::connectedComponentsWithStats(components_of, labels, stats, centroids, connectivity);
  std::vector<uint8_t> paint(count, 0);
  for (int i = 1; i < count; ++i) paint[i] = chosen(stats.ptr<int>(i));
  for (int y = 0; y < mask->rows; ++y) {
    const int* label = labels.ptr<int>(y);
    uint8_t* out = mask->ptr<uint8_t>(y);
    for (int x = 0; x < mask->cols; ++x)
      if (paint[label[x]]) out[x] = value;
  }
}

}  // namespace

cv::Mat cleanMask(const cv::Mat& mask, const SilhouetteOptions& options) {
  cv::Mat clean = mask != 0;
  // Outside the image nothing is known: OpenCV's default border neither erodes nor dilates.
  if (options.open_radius_px > 0)
    cv::morphologyEx(clean, clean, cv::MORPH_OPEN, disk(options.open_radius_px));
  if (options.close_radius_px > 0)
    cv::morphologyEx(clean, clean, cv::MORPH_CLOSE, disk(options.close_radius_px));
  const auto is_small_hole = [&](const int* stats) {
    const int left = stats[cv::CC_STAT_LEFT], top = stats[cv::CC_STAT_TOP];
    const bool enclosed = left > 0 && top > 0 && left + stats[cv::CC_STAT_WIDTH] < clean.cols &&
                          top + stats[cv::CC_STAT_HEIGHT] < clean.rows;
    return enclosed && stats[cv::CC_STAT_AREA] <= options.max_hole_px;
  };
  paintComponents(~clean, 4, 255, is_small_hole, &clean);
  const auto is_small_blob = [&](const int* stats) {
    return stats[cv::CC_STAT_AREA] < options.min_blob_px;
  };
  paintComponents(clean, 8, 0, is_small_blob, &clean);
  return clean;
}

}  // namespace markerless_mocap
