#include "silhouette/changes/light_switch.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "silhouette/bits/bit_morphology.h"

namespace markerless_mocap {
namespace {

/// So many fewer pixels than usual must agree with one gain.
constexpr double kDrop = 0.12;
/// If so many fewer agree than in the last image, what is learned from now on may have to be taken
/// back. A person who leaves the place where they stood hides it step by step.
constexpr double kSudden = 0.04;
/// It is taken back as soon as so many more agree with the background before.
constexpr double kShown = 0.03;
/// How fast the usual fraction follows, per image.
constexpr double kFollow = 0.05;
constexpr int kSoon = 300;  ///< images; changes less apart belong together
constexpr int kSide = 16;   ///< of a block, px
/// The person may have moved this far since the mask, px.
constexpr int kMoved = 12;
constexpr int kFewestPixels = 64;
/// Darker blocks show nothing, relative to the background.
constexpr float kDarkestLight = 0.04f;
constexpr int kDarkest = 8, kBrightest = 250;
/// Fraction of the background that light must explain, and how much more than an even change of
/// light does: a person who comes near hides as much as a lamp changes.
constexpr double kExplained = 0.7, kGained = 0.04;
/// Difference that light leaves, mean over channels: grey levels, and relative.
constexpr float kLeftOver = 6, kRelativeLeftOver = 0.08f;
/// Where light has an edge, it differs from that of the block by up to this fraction.
constexpr float kEdge = 0.4f;

/// Whether a pixel is neither black, nor clipped in background or image.
bool isReliable(const uint8_t* pixel, const ModeRow& mode, int x, int channels) {
  for (int c = 0; c < channels; ++c)
    if (mode.mean[c][x] < kDarkest || std::max(mode.mean[c][x], pixel[c]) > kBrightest)
      return false;
  return true;
}

/// For each block the light by channel, 0 where too little of the background is seen.
cv::Mat blockLight(const cv::Mat& image, const BitMask& person, const Background& background) {
  const int channels = image.channels();
  const cv::Size blocks((image.cols + kSide - 1) / kSide, (image.rows + kSide - 1) / kSide);
  cv::Mat now(blocks, CV_32FC3, cv::Scalar::all(0)), before = now.clone();
  cv::Mat count(blocks, CV_32S, cv::Scalar(0));
  for (int y = 0; y < image.rows; ++y) {
    const ModeRow mode = background.quantised(0, y);
    for (int x = 0; x < image.cols; ++x) {
      const uint8_t* pixel = image.ptr(y, x);
      if (person.at(x, y) || !isReliable(pixel, mode, x, channels)) continue;
      for (int c = 0; c < channels; ++c) {
        now.at<cv::Vec3f>(y / kSide, x / kSide)[c] += pixel[c];
        before.at<cv::Vec3f>(y / kSide, x / kSide)[c] += mode.mean[c][x];
      }
      ++count.at<int>(y / kSide, x / kSide);
    }
  }
  cv::Mat light;
  cv::divide(now, before, light);
  light.setTo(cv::Scalar::all(0), count < kFewestPixels);
  return light;
}

bool isFilled(const cv::Mat& light, int x, int y) {
  return light.at<cv::Vec3f>(y, x)[0] > kDarkestLight;
}

/// Mean of the blocks around one that have light; 0 if there are none.
cv::Vec3f lightAround(const cv::Mat& light, int x, int y) {
  cv::Vec3f sum(0, 0, 0);
  int n = 0;
  for (int v = std::max(0, y - 1); v <= std::min(light.rows - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(light.cols - 1, x + 1); ++u)
      if (isFilled(light, u, v)) sum += light.at<cv::Vec3f>(v, u), ++n;
  return n > 0 ? sum / float(n) : sum;
}

/// Fills blocks without light with the mean of their neighbours, step by step. Returns false if no
/// block has light.
bool fillBlocks(cv::Mat* light) {
  for (int step = 0; step <= light->rows + light->cols; ++step) {
    const cv::Mat before = light->clone();
    int missing = 0;
    for (int y = 0; y < before.rows; ++y)
      for (int x = 0; x < before.cols; ++x) {
        if (isFilled(before, x, y)) continue;
        ++missing;
        light->at<cv::Vec3f>(y, x) = lightAround(before, x, y);
      }
    if (missing == 0) return true;
  }
  return false;
}

/// Light of each pixel, CV_32FC3.
cv::Mat pixelLight(const cv::Mat& blocks, const cv::Size& size) {
  cv::Mat light;
  cv::resize(blocks, light, blocks.size() * kSide, 0, 0, cv::INTER_LINEAR);
  return light(cv::Rect({0, 0}, size));
}

/// Mean difference of a pixel from what the light makes of the background, and whether it is small.
struct LeftOver {
  float difference = 0, grey = 0;
  bool isSmall() const { return difference < kLeftOver + kRelativeLeftOver * grey; }
};

LeftOver leftOver(const uint8_t* pixel, const ModeRow& mode, int x, const cv::Vec3f& light,
                  int channels) {
  LeftOver left;
  for (int c = 0; c < channels; ++c) {
    const float lit = std::min(255.0f, mode.mean[c][x] * light[c]);
    left.difference += std::abs(float(pixel[c]) - lit) / float(channels);
    left.grey += lit / float(channels);
  }
  return left;
}

/// Fraction of the visible background that has the light's colours.
double explainedFraction(const cv::Mat& image, const BitMask& person, const Background& background,
                         const cv::Mat& light) {
  int seen = 0, explained = 0;
  for (int y = kSide / 2; y < image.rows; y += kSide / 2) {
    const ModeRow mode = background.quantised(0, y);
    for (int x = kSide / 2; x < image.cols; x += kSide / 2) {
      if (person.at(x, y)) continue;
      ++seen;
      explained +=
          leftOver(image.ptr(y, x), mode, x, light.at<cv::Vec3f>(y, x), image.channels()).isSmall();
    }
  }
  return explained / std::max(1.0, double(seen));
}

void relightRow(const cv::Mat& image, const BitMask& hidden, const cv::Mat& light, int y,
                Background* background) {
  const int channels = image.channels();
  const ModeRow mode = background->quantised(0, y);
  for (int x = 0; x < image.cols; ++x) {
    const cv::Vec3f& lit = light.at<cv::Vec3f>(y, x);
    const uint8_t* pixel = image.ptr(y, x);
    const LeftOver left = leftOver(pixel, mode, x, lit, channels);
    // Edges of the light between two blocks are taken from the image.
    const bool is_edge = !hidden.at(x, y) && !left.isSmall() && left.difference < kEdge * left.grey;
    for (int c = 0; c < channels; ++c) {
      uint16_t& mean = background->mean(0, y, c)[x];
      const float seen = is_edge ? float(pixel[c]) * Background::kMeanScale : float(mean) * lit[c];
      mean = uint16_t(std::min(255.0f * Background::kMeanScale, seen));
    }
  }
  background->updateQuantised(0, y);
}

}  // namespace

bool relight(const cv::Mat& image, double gain, const BitMask& person, Background* background) {
  const BitMask hidden = dilated(person, kMoved);
  cv::Mat blocks = blockLight(image, hidden, *background);
  if (!fillBlocks(&blocks)) return false;
  const cv::Mat light = pixelLight(blocks, image.size());
  const cv::Mat even(image.size(), CV_32FC3, cv::Scalar::all(gain));
  const double explained = explainedFraction(image, hidden, *background, light);
  const double before = explainedFraction(image, hidden, *background, even);
  if (explained < kExplained || explained < before + kGained) return false;
  for (int y = 0; y < image.rows; ++y) relightRow(image, hidden, light, y, background);
  return true;
}

bool LightSwitch::update(const cv::Mat& image, const LightGain& light, const BitMask& person,
                         Background* background) {
  const double agreeing = light.inlier_fraction;
  if (usual_ < 0) usual_ = last_ = agreeing;
  const bool is_sudden = agreeing <= last_ - kSudden && person.rows() > 0;
  const bool has_dropped = agreeing <= usual_ - kDrop && person.rows() > 0;
  last_ = agreeing;
  if (++unchanged_ > kSoon) first_.reset();
  if ((has_dropped || unchanged_ <= kSoon) && takeBack(image, agreeing, background)) return true;
  if (!has_dropped) {
    if (is_sudden) remember(*background, usual_);
    usual_ += kFollow * (agreeing - usual_);
    return false;
  }
  Background before = *background;
  const bool is_changed = relight(image, light.gain, person, background);
  // Also where light does not explain it: a blurred or zoomed picture spoils the background.
  remember(std::move(before), usual_);
  usual_ = is_changed ? estimateLightGain(image, *background).inlier_fraction : agreeing;
  if (is_changed) last_ = usual_;
  return is_changed;
}

bool LightSwitch::takeBack(const cv::Mat& image, double agreeing, Background* background) {
  if (isShown(image, first_, agreeing)) {
    exchange(&*first_, background);
    other_ = std::move(first_);
    first_.reset();
    return true;
  }
  if (!isShown(image, other_, agreeing)) return false;
  exchange(&*other_, background);
  return true;
}

bool LightSwitch::isShown(const cv::Mat& image, const std::optional<Light>& light,
                          double agreeing) const {
  if (!light) return false;
  const double agrees = estimateLightGain(image, light->background).inlier_fraction;
  return agrees >= light->usual - kShown && agrees >= agreeing + kShown;
}

void LightSwitch::exchange(Light* light, Background* background) {
  std::swap(light->background, *background);
  std::swap(light->usual, usual_);
  last_ = usual_;
  unchanged_ = 0;
}

void LightSwitch::remember(Background before, double usual) {
  if (unchanged_ <= kSoon && other_ && !first_) first_ = std::move(other_);
  other_ = Light{std::move(before), usual};
  unchanged_ = 0;
}

}  // namespace markerless_mocap
