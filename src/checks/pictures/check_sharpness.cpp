#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "checks/pictures/check_pictures.h"
#include "checks/text/sentence.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr double kDark = 45;         // grey level below which nearly all pixels of a dark image are
constexpr int kWhite = 250;          // grey level of saturated pixels
constexpr double kMostWhite = 0.12;  // of the pixels
/// Standard deviation of a covered camera's picture without noise, grey levels; of the mean.
constexpr double kFlat = 1.5, kFlatShare = 0.08, kLight = 200;
/// Contrast of edges, grey levels: noise of 10 gives 0.8, boards of a floor seen from above give 3.
constexpr double kNoEdges = 1.5;
constexpr double kBlurred = 0.32, kAgainstOthers = 0.55, kVeryBlurred = 0.22;
constexpr double kShare = 0.15;  // of the pictures

double deviationOf(const cv::Mat& picture) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(picture, mean, deviation);
  return deviation[0];
}

/// Contrast of what is a few pixels wide: less than a shade, more than noise.
double edgesOf(const cv::Mat& grey) {
  cv::Mat image, fine, coarse;
  grey.convertTo(image, CV_32F);
  cv::GaussianBlur(image, fine, {}, 3.0);
  cv::GaussianBlur(image, coarse, {}, 8.0);
  return deviationOf(fine - coarse);
}

bool isFlat(const cv::Mat& grey) {
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, {}, 4.0);
  const double level = cv::mean(smooth)[0];  // white ones are overexposed
  return level < kLight && deviationOf(smooth) < std::max(kFlat, kFlatShare * level) &&
         edgesOf(grey) < kNoEdges;
}

/// The median over time, which has no people and little noise.
cv::Mat stillPicture(const std::vector<SeenPicture>& pictures) {
  cv::Mat still(pictures.front().grey.size(), CV_8UC1);
  std::vector<uint8_t> column;
  for (size_t v = 0; v < still.total(); ++v) {
    column.clear();
    for (const SeenPicture& picture : pictures) column.push_back(picture.grey.data[v]);
    still.data[v] = medianAmong(column);
  }
  return still;
}

/// Contrast of the finest details relative to that of coarser ones: about 0.6 in sharp images,
/// below 0.3 if edges are wider than five pixels. NaN in images with no details.
double sharpnessOf(const cv::Mat& grey) {
  cv::Mat image, fine, middle, coarse;
  grey.convertTo(image, CV_32F);
  cv::GaussianBlur(image, fine, {}, 1.0);
  cv::GaussianBlur(image, middle, {}, 2.0);
  cv::GaussianBlur(image, coarse, {}, 5.0);
  const double details = deviationOf(middle - coarse);
  return details < 1.0 ? NAN : deviationOf(fine - middle) / details;
}

std::vector<SeenPicture> ofOneSize(const SeenCamera& camera) {
  std::vector<SeenPicture> pictures;
  for (const SeenPicture& picture : camera.pictures)
    if (pictures.empty() || picture.grey.size() == pictures.front().grey.size())
      pictures.push_back(picture);
  return pictures;
}

/// Fraction of pixels that are at least as bright.
double brightShare(const cv::Mat& grey, int level) {
  return double(cv::countNonZero(grey >= level)) / double(grey.total());
}

bool checkLevels(const SeenCamera& camera, const std::vector<SeenPicture>& pictures,
                 Findings* findings) {
  double dark = 0, flat = 0, white = 0;
  for (const SeenPicture& picture : pictures) {
    const bool is_flat = isFlat(picture.grey);
    flat += is_flat;
    dark += !is_flat && brightShare(picture.grey, int(kDark)) < 0.05;
    white += brightShare(picture.grey, kWhite) / double(pictures.size());
  }
  dark /= double(pictures.size());
  flat /= double(pictures.size());
  if (flat > kShare)
    findings->push_back(
        {"image_covered", camera.name, Severity::kError,
         sentence("%.0f %% of the images show one even surface", 100 * flat),
         "take the cap or cover off; see whether somebody stands before the camera"});
  if (dark > kShare)
    findings->push_back({"image_dark", camera.name, Severity::kWarning,
                         sentence("95 %% of the pixels are darker than %.0f of 255", kDark),
                         "more light, a longer exposure (at most 1/100 s while people move), or a "
                         "more open lens"});
  if (white > kMostWhite && flat <= kShare)
    findings->push_back(
        {"image_overexposed", camera.name, Severity::kWarning,
         sentence("%.0f %% of the pixels are white", 100 * white),
         "a shorter exposure or less gain; keep lamps and windows out of the image"});
  return flat > kShare;
}

}  // namespace

void checkSharpness(const SeenRig& rig, Findings* findings) {
  std::vector<double> all(rig.cameras.size(), NAN), known;
  for (size_t i = 0; i < rig.cameras.size(); ++i) {
    const std::vector<SeenPicture> pictures = ofOneSize(rig.cameras[i]);
    if (rig.cameras[i].masks_only || pictures.empty()) continue;
    if (checkLevels(rig.cameras[i], pictures, findings)) continue;
    all[i] = sharpnessOf(stillPicture(pictures));
    if (std::isfinite(all[i])) known.push_back(all[i]);
  }
  const double usual = nearestQuantile(known, 0.5);
  for (size_t i = 0; i < all.size(); ++i)
    if (all[i] < kVeryBlurred || (all[i] < kBlurred && all[i] < kAgainstOthers * usual))
      findings->push_back(
          {"image_blurred", rig.cameras[i].name, Severity::kWarning,
           sentence(
               "the finest details have %.0f %% of the contrast of coarser ones, %.0f %% in the "
               "other cameras",
               100 * all[i], 100 * usual),
           "focus the lens and fix it (no autofocus); clean it"});
}

}  // namespace markerless_mocap
