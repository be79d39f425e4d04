#include "silhouette/recording/scene_samples.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "numerics/order_statistics.h"
#include "silhouette/background/light_gain.h"

namespace markerless_mocap {
namespace {

/// Learning needs no more detail than this many pixels show.
constexpr int kMaxPixels = 160000;
/// Samples; twice as many are kept before every second one is dropped.
constexpr size_t kSamples = 36;
constexpr size_t kMedianSamples = 15;
constexpr size_t kMaxBytes = size_t(80) << 20;  ///< of whole images that are kept
/// An image is compared with those so many frames before and after it.
constexpr std::array<int, 2> kApart = {SceneSampler::kStep, 3 * SceneSampler::kStep};
constexpr int kReach = 3 * SceneSampler::kStep;
constexpr double kMotion = 12;  ///< grey levels
/// Light changes a colour by a factor up to the first value, and each channel by it but for the
/// second fraction.
constexpr float kMostLight = 3.f, kSameTint = 0.1f;
/// A sample differs from the median of all in more than this fraction of its pixels, and in more
/// than so many times what is usual: another lamp is on.
constexpr double kOtherLight = 0.25, kOtherLightFactor = 2.0;
constexpr int kSmooth = 5, kClose = 9, kDilate = 5;

cv::Mat ellipse(int side) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {side, side});
}

/// Pixels of which a channel changes.
cv::Mat changedPixels(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference, planes[3];
  cv::absdiff(a, b, difference);
  cv::split(difference, planes);
  return cv::max(planes[0], cv::max(planes[1], planes[2])) > kMotion;
}

/// Whether one colour is the other one in more or less light: all channels change by one factor.
bool isOtherLight(const cv::Vec3b& a, const cv::Vec3b& b) {
  const float factor = float(a[0] + a[1] + a[2]) / std::max(1.f, float(b[0] + b[1] + b[2]));
  if (factor > kMostLight || factor * kMostLight < 1) return false;
  for (int c = 0; c < 3; ++c)
    if (std::abs(float(a[c]) - factor * float(b[c])) > kSameTint * float(std::max(a[c], b[c])))
      return false;
  return true;
}

/// Pixels that change otherwise than by light, as of sun that wanders. Grey images do not tell.
cv::Mat movedPixels(const cv::Mat& a, const cv::Mat& b, bool has_color) {
  cv::Mat moved = changedPixels(a, b);
  if (!has_color) return moved;
  for (int y = 0; y < moved.rows; ++y)
    for (int x = 0; x < moved.cols; ++x)
      if (moved.at<uint8_t>(y, x) && isOtherLight(a.at<cv::Vec3b>(y, x), b.at<cv::Vec3b>(y, x)))
        moved.at<uint8_t>(y, x) = 0;
  return moved;
}

/// Of so many samples, one keeps its whole image.
int wholeImageStride(const cv::Mat& image) {
  const size_t all = 2 * kSamples * image.total() * image.elemSize();
  return int((all + kMaxBytes - 1) / kMaxBytes);
}

/// Median of each pixel and channel over some of the images.
cv::Mat medianOf(const std::vector<cv::Mat>& all) {
  const size_t stride = (all.size() + kMedianSamples - 1) / kMedianSamples;
  std::vector<cv::Mat> images;
  for (size_t i = 0; i < all.size(); i += stride) images.push_back(all[i]);
  cv::Mat median(images[0].size(), CV_8UC3);
  std::vector<uint8_t> values(images.size());
  for (int y = 0; y < median.rows; ++y)
    for (int x = 0; x < 3 * median.cols; ++x) {
      for (size_t i = 0; i < images.size(); ++i) values[i] = images[i].ptr(y)[x];
      median.ptr(y)[x] = medianAmong(values);
    }
  return median;
}

/// Fraction of the pixels in which the images differ.
double differenceOf(const cv::Mat& a, const cv::Mat& b) {
  return double(cv::countNonZero(changedPixels(a, b))) / double(a.total());
}

/// Drops samples in the light of another lamp, if they are the fewer ones: it lights each wall by
/// another factor, so that no gain makes up for it.
void dropOtherLight(const cv::Mat& median, SceneSamples* samples) {
  std::vector<double> differences;
  for (const cv::Mat& color : samples->colors) differences.push_back(differenceOf(color, median));
  std::vector<double> sorted = differences;
  const double limit = std::max(kOtherLight, kOtherLightFactor * medianAmong(sorted));
  size_t kept = 0;
  for (size_t i = 0; i < differences.size(); ++i) {
    if (differences[i] > limit) continue;
    samples->colors[kept] = samples->colors[i];
    samples->moving[kept] = samples->moving[i];
    samples->images[kept] = samples->images[i];
    samples->gains[kept++] = samples->gains[i];
  }
  samples->colors.resize(kept);
  samples->moving.resize(kept);
  samples->images.resize(kept);
  samples->gains.resize(kept);
}

}  // namespace

cv::Mat smallCopy(const cv::Mat& image) {
  int factor = 1;
  while (image.total() / size_t(factor * factor) > kMaxPixels) factor *= 2;
  cv::Mat small;
  cv::resize(image, small, {image.cols / factor, image.rows / factor}, 0, 0, cv::INTER_AREA);
  if (small.channels() == 1) cv::cvtColor(small, small, cv::COLOR_GRAY2BGR);
  return small;
}

bool SceneSampler::wantsNext() const {
  for (const int apart : {0, kApart[0], kApart[1], -kApart[0], -kApart[1]})
    if (seen_ + apart >= 0 && (seen_ + apart) % stride_ == 0) return true;
  return false;
}

void SceneSampler::add(const cv::Mat& image) {
  Frame frame;
  if (!image.empty()) {
    image_size_ = image.size();
    image_channels_ = image.channels();
    frame = {image.clone(), smallCopy(image), {}};
    cv::blur(frame.small, frame.smooth, {kSmooth, kSmooth});
  }
  recent_.push_back(std::move(frame));
  ++seen_;
  if (seen_ > kReach) keep(seen_ - 1 - kReach);
  if (recent_.size() > size_t(2) * kReach) recent_.pop_front();
}

const SceneSampler::Frame* SceneSampler::frameAt(int index) const {
  const int first = seen_ - int(recent_.size());
  if (index < first || index >= seen_ || recent_[index - first].image.empty()) return nullptr;
  return &recent_[index - first];
}

cv::Mat SceneSampler::last() const {
  for (auto frame = recent_.rbegin(); frame != recent_.rend(); ++frame)
    if (!frame->image.empty()) return frame->image;
  return {};
}

cv::Mat SceneSampler::movingAt(int index) const {
  const cv::Mat& now = frameAt(index)->smooth;
  cv::Mat moving = cv::Mat::zeros(now.size(), CV_8UC1);
  for (const int apart : kApart)
    for (const int other : {index - apart, index + apart})
      if (const Frame* frame = frameAt(other))
        moving |= movedPixels(now, frame->smooth, image_channels_ == 3);
  cv::morphologyEx(moving, moving, cv::MORPH_CLOSE, ellipse(kClose));
  cv::dilate(moving, moving, ellipse(kDilate));
  return moving;
}

void SceneSampler::keep(int index) {
  const Frame* frame = frameAt(index);
  if (index % stride_ != 0 || !frame) return;
  const bool is_whole = index / stride_ % wholeImageStride(frame->image) == 0;
  kept_.push_back({index, is_whole ? frame->image : cv::Mat(), frame->small, movingAt(index)});
  if (kept_.size() >= 2 * kSamples) thinOut();
}

void SceneSampler::thinOut() {
  stride_ *= 2;
  kept_.erase(std::remove_if(kept_.begin(), kept_.end(),
                             [&](const Kept& kept) { return kept.index % stride_ != 0; }),
              kept_.end());
}

std::vector<SceneSampler::Kept> SceneSampler::allKept() const {
  SceneSampler all = *this;
  for (int index = std::max(0, seen_ - kReach); index < seen_; ++index) all.keep(index);
  if (all.kept_.empty())
    throw std::invalid_argument("silhouette: there is no image to learn the background from");
  return all.kept_;
}

std::vector<cv::Mat> SceneSampler::motion() const {
  std::vector<cv::Mat> moving;
  for (const Kept& kept : allKept()) moving.push_back(kept.moving);
  return moving;
}

SceneSamples SceneSampler::samples(bool compensate_flicker) const {
  SceneSamples samples;
  for (const Kept& kept : allKept()) {
    samples.images.push_back(kept.image);
    samples.colors.push_back(kept.small);
    samples.moving.push_back(kept.moving);
  }
  samples.size = samples.colors[0].size();
  samples.image_size = image_size_;
  samples.image_channels = image_channels_;
  const cv::Mat median = medianOf(samples.colors);
  for (cv::Mat& color : samples.colors) {
    samples.gains.push_back(compensate_flicker ? float(estimateLightGain(color, median).gain)
                                               : 1.0f);
    color = color / samples.gains.back();
  }
  dropOtherLight(median, &samples);
  return samples;
}

}  // namespace markerless_mocap
