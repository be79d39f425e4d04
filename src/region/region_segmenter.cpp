#include "region/region_segmenter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "markerless_mocap/products/silhouette_mask.h"
#include "region/body_drawing.h"
#include "region/colors/part_colors.h"
#include "region/cut/band_cut.h"

namespace markerless_mocap {
namespace {

// Weights of what is newly learned. The surroundings change as the person moves.
constexpr float kPersonRate = 0.1f, kSurroundingsRate = 0.5f;

// Further from the projected outline, a sample is decided by the body alone.
constexpr float kBand_sigmas = 2.5f, kBand = 2.f;
// The surroundings are learned up to this distance.
constexpr float kMargin_sigmas = 2.5f, kMargin = 8.f;

constexpr float kShapeWeight = 0.5f;  // of the predicted outline beside colour
constexpr float kKnownLogOdds = 1.f;  // of a sample that background subtraction decided
constexpr float kDecided = 100.f;     // outside the band

constexpr double kMinComponent = 0.02;  // of the person's area
constexpr int kMaxHole = 8;             // samples

/// log(Phi(-z) / Phi(z)) of the standard normal distribution.
float logOddsOfOffset(float z) {
  const double lower = 0.5 * std::erfc(std::clamp(double(z), -5.0, 5.0) * M_SQRT1_2);
  return float(std::log(lower / (1 - lower)));
}

/// A table of logOddsOfOffset.
class OffsetTable {
 public:
  OffsetTable() {
    for (int i = 0; i <= kSteps; ++i)
      values_[size_t(i)] = logOddsOfOffset(kRange * (2.f * float(i) / kSteps - 1));
  }
  float operator()(float z) const {
    const float at = (std::clamp(z, -kRange, kRange) / kRange + 1) * 0.5f * kSteps;
    return values_[size_t(at + 0.5f)];
  }

 private:
  static constexpr int kSteps = 400;
  static constexpr float kRange = 4.f;
  std::array<float, kSteps + 1> values_;
};

void addShape(const BodyDrawing& drawing, float sigma, cv::Mat& log_odds, cv::Mat& band) {
  static const OffsetTable table;
  band.create(log_odds.size(), CV_8UC1);
  const float reach = kBand_sigmas * sigma + kBand;
  for (int y = 0; y < log_odds.rows; ++y) {
    const float* distance = drawing.distance.ptr<float>(y);
    float* odds = log_odds.ptr<float>(y);
    uchar* undecided = band.ptr<uchar>(y);
    for (int x = 0; x < log_odds.cols; ++x) {
      const float d = distance[x];
      undecided[x] = std::abs(d) <= reach ? 255 : 0;
      odds[x] =
          undecided[x] ? odds[x] + kShapeWeight * table(d / sigma) : (d < 0 ? kDecided : -kDecided);
    }
  }
}

void addKnown(const cv::Mat& known, cv::Mat& log_odds) {
  for (int y = 0; y < log_odds.rows; ++y) {
    const uchar* value = known.ptr<uchar>(y);
    float* odds = log_odds.ptr<float>(y);
    for (int x = 0; x < log_odds.cols; ++x)
      odds[x] += value[x] == kPersonPixel    ? kKnownLogOdds
                 : value[x] == kUnknownPixel ? 0.f
                                             : -kKnownLogOdds;
  }
}

/// Number of the part that is nearest to a sample. \param at in drawing.box
size_t nearestPart(const BodyDrawing& drawing, const cv::Point& at) {
  size_t nearest = 0;
  float least = std::numeric_limits<float>::max();
  for (size_t i = 0; i < drawing.parts.size(); ++i) {
    const PartDistance& part = drawing.parts[i];
    const cv::Point own = at + drawing.box.tl() - part.box.tl();
    if (!cv::Rect({}, part.box.size()).contains(own) || part.distance.at<float>(own) >= least)
      continue;
    least = part.distance.at<float>(own);
    nearest = i;
  }
  return nearest;
}

/// Counts where background subtraction and colours agree. \param mask in drawing.box
void compare(const BodyDrawing& drawing, const cv::Mat& known, const cv::Mat& mask,
             RegionMask& found) {
  found.silhouette = cv::countNonZero(known == kPersonPixel);
  found.known.assign(drawing.parts.size(), 0);
  found.colored = found.agreeing = found.known;
  const cv::Mat near = known(drawing.box);
  for (int y = 0; y < mask.rows; ++y) {
    const uchar *person = mask.ptr<uchar>(y), *silhouette = near.ptr<uchar>(y),
                *drawn = drawing.part.ptr<uchar>(y);
    for (int x = 0; x < mask.cols; ++x) {
      if (!person[x]) continue;
      const size_t part =
          drawn[x] != BodyDrawing::kNoPart ? drawn[x] : nearestPart(drawing, {x, y});
      ++found.colored[part];
      if (silhouette[x] == kUnknownPixel) continue;
      ++found.known[part];
      if (silhouette[x] == kPersonPixel) ++found.agreeing[part];
    }
  }
}

/// Adds what background subtraction sees as person if it is attached to the mask: limbs that the
/// body in its pose does not reach.
void addAttached(const cv::Mat& known, cv::Mat& mask) {
  const cv::Mat person = known == kPersonPixel;
  cv::Mat labels;
  const int count = cv::connectedComponents(person, labels, 8, CV_32S);
  std::vector<uchar> attached(size_t(count), 0);
  if (count == 1) return;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (mask.at<uchar>(y, x)) attached[size_t(labels.at<int>(y, x))] = 255;
  attached[0] = 0;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      mask.at<uchar>(y, x) |= attached[size_t(labels.at<int>(y, x))];
}

/// Drops small components.
void dropSpecks(cv::Mat& mask) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8, CV_32S);
  const double least = kMinComponent * cv::countNonZero(mask);
  std::vector<uchar> keep(size_t(count), 255);
  keep[0] = 0;
  for (int i = 1; i < count; ++i)
    if (stats.at<int>(i, cv::CC_STAT_AREA) < least) keep[size_t(i)] = 0;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) mask.at<uchar>(y, x) = keep[size_t(labels.at<int>(y, x))];
}

void fillHoles(cv::Mat& mask) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(~mask, labels, stats, centres, 4, CV_32S);
  for (int i = 1; i < count; ++i) {
    if (stats.at<int>(i, cv::CC_STAT_AREA) > kMaxHole) continue;
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    mask(box).setTo(255, labels(box) == i);
  }
}

}  // namespace

class RegionSegmenter::Impl {
 public:
  explicit Impl(int parts) : colors_(size_t(parts)) {}

  void reset() {
    colors_.assign(colors_.size(), {});
    has_colors_ = false;
  }

  void learn(const cv::Mat& image, const ProjectedBody& body) {
    const BodyDrawing drawing = draw(image, body);
    if (drawing.box.area() == 0) return;
    learnColors(ColorBins::instance().of(image(drawing.box)), drawing, body.sigma, kPersonRate,
                kSurroundingsRate, colors_);
    has_colors_ = true;
  }

  RegionMask segment(const cv::Mat& image, const ProjectedBody& body, const cv::Mat& known,
                     Limbs limbs) const {
    RegionMask out;
    out.mask = cv::Mat::zeros(image.size(), CV_8UC1);
    const BodyDrawing drawing = draw(image, body);
    if (drawing.box.area() == 0) return out;
    const cv::Mat bins = ColorBins::instance().of(image(drawing.box));
    cv::Mat log_odds = has_colors_
                           ? colorLogOdds(bins, drawing, body.sigma, colors_)
                           : colorLogOdds(bins, drawing, body.sigma, colorsOf(bins, drawing, body)),
            band;
    if (!known.empty()) addKnown(known(drawing.box), log_odds);
    addShape(drawing, body.sigma, log_odds, band);
    cv::Mat mask = bandCut(image(drawing.box), log_odds, band);
    dropSpecks(mask);
    fillHoles(mask);
    if (!known.empty()) {
      compare(drawing, known, mask, out);
      if (limbs == Limbs::kElsewhere) addAttached(known(drawing.box), mask);
    }
    mask.copyTo(out.mask(drawing.box));
    return out;
  }

  cv::Mat candidates(const cv::Mat& image, const ProjectedBody& body, const cv::Mat& known,
                     float reach) const {
    cv::Mat out = cv::Mat::zeros(image.size(), CV_8UC1);
    const BodyDrawing drawing = drawBody(body, int(colors_.size()), image.size(), reach);
    if (drawing.box.area() == 0) return out;
    const cv::Mat bins = ColorBins::instance().of(image(drawing.box));
    cv::Mat colored =
        has_colors_ ? personColored(bins, colors_) : personColored(bins, colorsOf(image, body));
    cv::morphologyEx(colored, colored, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8UC1));
    if (!known.empty()) {
      colored.setTo(0, known(drawing.box) == kBackgroundPixel);
      colored |= known(drawing.box) == kPersonPixel;
    }
    const cv::Mat near = drawing.distance < reach;
    colored.copyTo(out(drawing.box), near);
    return out;
  }

 private:
  /// The colours in one image.
  std::vector<PartColors> colorsOf(const cv::Mat& bins, const BodyDrawing& drawing,
                                   const ProjectedBody& body) const {
    std::vector<PartColors> colors(colors_.size());
    learnColors(bins, drawing, body.sigma, kPersonRate, kSurroundingsRate, colors);
    return colors;
  }
  std::vector<PartColors> colorsOf(const cv::Mat& image, const ProjectedBody& body) const {
    const BodyDrawing drawing = draw(image, body);
    return colorsOf(ColorBins::instance().of(image(drawing.box)), drawing, body);
  }
  BodyDrawing draw(const cv::Mat& image, const ProjectedBody& body) const {
    return drawBody(body, int(colors_.size()), image.size(), kMargin_sigmas * body.sigma + kMargin);
  }

  std::vector<PartColors> colors_;
  bool has_colors_ = false;
};

RegionSegmenter::RegionSegmenter(int parts) : impl_(std::make_unique<Impl>(parts)) {}
RegionSegmenter::~RegionSegmenter() = default;
RegionSegmenter::RegionSegmenter(RegionSegmenter&&) noexcept = default;
RegionSegmenter& RegionSegmenter::operator=(RegionSegmenter&&) noexcept = default;
void RegionSegmenter::prepare() {
  ColorBins::instance();
}
void RegionSegmenter::reset() {
  impl_->reset();
}
void RegionSegmenter::learn(const cv::Mat& image, const ProjectedBody& body) {
  impl_->learn(image, body);
}
cv::Mat RegionSegmenter::candidates(const cv::Mat& image, const ProjectedBody& body,
                                    const cv::Mat& known, float reach) const {
  return impl_->candidates(image, body, known, reach);
}
RegionMask RegionSegmenter::segment(const cv::Mat& image, const ProjectedBody& body,
                                    const cv::Mat& known, Limbs limbs) const {
  return impl_->segment(image, body, known, limbs);
}

}  // namespace markerless_mocap
