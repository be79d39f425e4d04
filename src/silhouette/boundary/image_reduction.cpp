#include "silhouette/boundary/image_reduction.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

cv::Size dividedSize(const cv::Size& image, int reduction) {
  return {(image.width + reduction - 1) / reduction, (image.height + reduction - 1) / reduction};
}

}  // namespace

int reductionOf(const cv::Size& image, double max_megapixels) {
  int reduction = 1;
  while (1e-6 * dividedSize(image, reduction).area() > max_megapixels) ++reduction;
  return reduction;
}

cv::Mat reducedImage(const cv::Mat& image, int reduction) {
  if (reduction == 1) return image;
  const cv::Size size = dividedSize(image.size(), reduction);
  const int right = size.width * reduction - image.cols,
            below = size.height * reduction - image.rows;
  cv::Mat whole = image, out;
  if (right > 0 || below > 0)
    cv::copyMakeBorder(image, whole, 0, below, 0, right, cv::BORDER_REPLICATE);
  cv::resize(whole, out, size, 0, 0, cv::INTER_AREA);
  return out;
}

cv::Mat enlargedMask(const cv::Mat& mask, int reduction, const cv::Size& image) {
  if (reduction == 1) return mask;
  cv::Mat out(image, CV_8UC1, cv::Scalar(kBackgroundPixel));
  const cv::Rect set = cv::boundingRect(mask);
  if (set.empty()) return out;
  // One pixel around them takes part in the interpolation.
  const cv::Rect from =
      cv::Rect(set.x - 1, set.y - 1, set.width + 2, set.height + 2) & cv::Rect({0, 0}, mask.size());
  const cv::Rect to =
      cv::Rect(from.tl() * reduction, from.br() * reduction) & cv::Rect({0, 0}, image);
  const cv::Mat small = mask(from);
  cv::Mat large = out(to), unknown, person;
  const auto enlarge = [&](const cv::Mat& some, int interpolation, cv::Mat* enlarged) {
    cv::resize(some, *enlarged, small.size() * reduction, 0, 0, interpolation);
    *enlarged = (*enlarged)(cv::Rect({0, 0}, to.size()));
  };
  if (hasUnknownPixels(small)) {
    enlarge(small == kUnknownPixel, cv::INTER_NEAREST, &unknown);
    large.setTo(kUnknownPixel, unknown);
  }
  enlarge(small == kPersonPixel, cv::INTER_LINEAR, &person);
  large.setTo(kPersonPixel, person > 127);
  return out;
}

}  // namespace markerless_mocap
