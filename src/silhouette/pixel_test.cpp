#include "silhouette/pixel_test.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "silhouette/shade_evidence.h"

namespace markerless_mocap {
namespace {

/// Brightness of a colour `now` relative to `usual` if it is a shade of that; else 0.
template <int kChannels>
float shadeRatio(const SilhouetteOptions& o, const float (&now)[kChannels], const float* usual) {
  float cross = 0, square = 0;
  for (int c = 0; c < kChannels; ++c) {
    cross += now[c] * usual[c];
    square += usual[c] * usual[c];
  }
  const float ratio = cross / (square + 1e-6f);
  if (ratio < float(o.shadow_darkest) || ratio >= 1) return 0;
  float off = 0;
  for (int c = 0; c < kChannels; ++c) {
    const float d = now[c] - ratio * usual[c];
    off += d * d;
  }
  const float tolerance = float(o.shadow_chroma_tolerance) * ratio;
  return off < tolerance * tolerance * square + float(o.min_sigma * o.min_sigma) ? ratio : 0;
}

template <int kChannels>
PixelClasses classifyChannels(const PixelTest& test, const cv::Mat& image, const cv::Mat& mean,
                              const cv::Mat& inverse_sigma) {
  const SilhouetteOptions& o = *test.options;
  const float limit = float(o.threshold_sigmas * o.threshold_sigmas);
  PixelClasses classes{cv::Mat(image.size(), CV_8UC1), cv::Mat(image.size(), CV_32FC1)};
  cv::Mat shade_ratio = cv::Mat::zeros(image.size(), CV_32FC1);
  for (int y = 0; y < image.rows; ++y) {
    const uint8_t* pixel = image.ptr<uint8_t>(y);
    const float* usual = mean.ptr<float>(y);
    const float* weight = inverse_sigma.ptr<float>(y);
    uint8_t* out = classes.mask.ptr<uint8_t>(y);
    float* far = classes.squared_distance.ptr<float>(y);
    float* shade = shade_ratio.ptr<float>(y);
    for (int x = 0; x < image.cols;
         ++x, pixel += kChannels, usual += kChannels, weight += kChannels) {
      float now[kChannels], distance = 0;
      for (int c = 0; c < kChannels; ++c) {
        now[c] = pixel[c] * test.inverse_gain;
        const float d = (now[c] - usual[c]) * weight[c];
        distance += d * d;
      }
      far[x] = distance;
      out[x] = distance > limit ? 255 : 0;
      if (out[x] && o.remove_shadows) shade[x] = shadeRatio(o, now, usual);
      if (shade[x] > 0) out[x] = 0;
    }
  }
  if (o.remove_shadows) restoreClothes(shade_ratio, &classes.mask);
  return classes;
}

/// Largest value among those of the eight neighbours that are set in `inside`; 0 if none is.
float largestInside(const cv::Mat& value, const cv::Mat& inside, int x, int y) {
  float largest = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, value.rows - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, value.cols - 1); ++u)
      if (inside.at<uint8_t>(v, u)) largest = std::max(largest, value.at<float>(v, u));
  return largest;
}

}  // namespace

PixelClasses classifyPixels(const PixelTest& test, const cv::Mat& image, const cv::Mat& mean,
                            const cv::Mat& inverse_sigma) {
  return image.channels() == 3 ? classifyChannels<3>(test, image, mean, inverse_sigma)
                               : classifyChannels<1>(test, image, mean, inverse_sigma);
}

void trimRim(const cv::Mat& squared_distance, cv::Mat* mask) {
  constexpr float kHalf = 0.25f;  // of the distance, squared
  cv::Mat inner;
  cv::erode(*mask, inner, cv::Mat());
  for (int y = 0; y < mask->rows; ++y) {
    const uint8_t* is_inner = inner.ptr<uint8_t>(y);
    uint8_t* out = mask->ptr<uint8_t>(y);
    for (int x = 0; x < mask->cols; ++x)
      if (out[x] && !is_inner[x] &&
          squared_distance.at<float>(y, x) < kHalf * largestInside(squared_distance, inner, x, y))
        out[x] = 0;
  }
}

}  // namespace markerless_mocap
