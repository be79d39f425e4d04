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
  const cv::Rect inside({0, 0}, image);
  cv::Mat unknown, person;
  cv::resize(mask == kUnknownPixel, unknown, mask.size() * reduction, 0, 0, cv::INTER_NEAREST);
  cv::resize(mask == kPersonPixel, person, mask.size() * reduction, 0, 0, cv::INTER_LINEAR);
  cv::Mat out(image, CV_8UC1, cv::Scalar(0));
  out.setTo(kUnknownPixel, unknown(inside));
  out.setTo(kPersonPixel, person(inside) > 127);
  return out;
}

}  // namespace markerless_mocap
