#include "contour/regions/region_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "contour/regions/hull_below.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

/// Colours are looked for around the body, then the body is fitted to them.
struct Round {
  double error_m;  ///< expected, of the body's outline
  bool is_coarse;  ///< a quarter of the samples and a third of the rays are enough
  RobustSchedule fit;
};
const std::vector<Round> kFirstRounds = {{0.08, true, RobustSchedule::wide()},
                                         {0.06, true, {12, 0.2, 0.04}},
                                         {0.04, false, {12, 0.15, 0.03}}};
const std::vector<Round> kRoundsAfterLimbs = {{0.06, true, {12, 0.2, 0.04}},
                                              {0.04, false, {12, 0.15, 0.03}}};

// Image width divided by the width of what counts as a speck or a gap.
constexpr int kWidthPerDisk = 120;

// Worse poses are not worth a search for their limbs.
constexpr double kMinOverlap = 0.5, kMinAgreement = 0.4;
constexpr double kMinGain = 0.005;  // of the score
// Nine of ten searches for limbs raise the score by less.
constexpr double kLargestLimbGain = 0.15;

// Of the score, for each metre by which the hull reaches further below the body than it usually
// does: shadows and the soles of shoes belong to it.
constexpr double kFloatingLoss = 0.2, kUsuallyBelow = 0.1;

double floating(const RegionFit& one) {
  return kFloatingLoss * std::max(0.0, one.hull_below - kUsuallyBelow);
}

bool isFitted(const RegionFit& one) {
  return one.fit.status == ContourFitStatus::kFitted;
}

/// Mean intersection over union of the persons in two sets of masks.
double overlapOf(const std::vector<cv::Mat>& masks, const std::vector<cv::Mat>& others) {
  double sum = 0.0;
  int views = 0;
  for (size_t i = 0; i < masks.size(); ++i) {
    if (masks[i].empty() || others[i].empty()) continue;
    const cv::Mat one = personPixels(masks[i]), other = personPixels(others[i]);
    const int either = cv::countNonZero(one | other);
    sum += either ? double(cv::countNonZero(one & other)) / either : 0.0;
    ++views;
  }
  return views ? sum / views : 0.0;
}

/// Those candidates that touch the person or each other: a limb is attached to the body.
cv::Mat attached(const cv::Mat& mask, const cv::Mat& candidates) {
  if (mask.empty() || candidates.empty()) return candidates;
  const cv::Mat person = personPixels(mask);
  const int across = std::max(5, person.cols / kWidthPerDisk | 1);
  const cv::Mat disk = cv::getStructuringElement(cv::MORPH_ELLIPSE, {across, across});
  cv::Mat found, all, labels;
  cv::morphologyEx(candidates, found, cv::MORPH_OPEN, disk);
  cv::dilate(found | person, all, disk);
  const int count = cv::connectedComponents(all, labels, 8, CV_32S);
  std::vector<uchar> kept(size_t(count), 0);
  for (int y = 0; y < labels.rows; ++y) {
    const uchar* is_person = person.ptr<uchar>(y);
    const int* label = labels.ptr<int>(y);
    for (int x = 0; x < labels.cols; ++x)
      if (is_person[x] == kPersonPixel) kept[size_t(label[x])] = 255;
  }
  for (int y = 0; y < labels.rows; ++y) {
    uchar* pixel = found.ptr<uchar>(y);
    const int* label = labels.ptr<int>(y);
    for (int x = 0; x < labels.cols; ++x) pixel[x] &= kept[size_t(label[x])];
  }
  return found;
}

void sortByScore(std::vector<RegionFit>& fits) {
  std::stable_sort(fits.begin(), fits.end(), [](const RegionFit& one, const RegionFit& other) {
    return one.score() > other.score();
  });
}

/// Drops all but the best of those that have come to the same pose. \param fits best first
void dropSame(const ContourBody& body, std::vector<RegionFit>& fits) {
  std::vector<RegionFit> others;
  for (RegionFit& one : fits)
    if (std::all_of(others.begin(), others.end(), [&](const RegionFit& other) {
          return limbsDiffer(body, one.fit.pose, other.fit.pose);
        }))
      others.push_back(std::move(one));
  fits = std::move(others);
}

struct SearchedScene : ColorScene {
  explicit SearchedScene(const ColorScene& scene) : ColorScene(scene), coarse(frame.coarser()) {}
  RegionFrame coarse;
};

RegionFit followed(const SearchedScene& scene, const ContourPose& pose,
                   const std::vector<Round>& rounds) {
  RegionFit out;
  ContourPose at = pose;
  for (const Round& round : rounds) {
    out.found = scene.observer.observeNear(round.is_coarse ? scene.coarse : scene.frame, scene.body,
                                           at, round.error_m);
    out.fit = scene.tracker.bestFit(out.found.seen, scene.body, {at}, round.fit);
    if (!isFitted(out)) break;
    at = out.fit.pose;
  }
  if (isFitted(out)) out.hull_below = hullBelow(scene.hull, scene.body, at);
  return out;
}

std::optional<RegionFit> withOtherLimbs(const SearchedScene& scene, const RegionFit& first) {
  std::vector<cv::Mat> wide =
      scene.observer.candidates(scene.frame, scene.hull, scene.body, first.fit.pose);
  std::vector<cv::Mat> all(wide.size());
  tbb::parallel_for(size_t(0), wide.size(), [&](size_t i) {
    wide[i] = attached(first.found.masks[i], wide[i]);
    if (!wide[i].empty()) all[i] = wide[i] | first.found.masks[i];
  });
  ContourObservation seen = scene.observer.observeRoughly(all);
  seen.masks_follow_pose = true;
  RegionFit best = first;
  bool better = false;
  for (int limb = ContourLimb::kLeftArm; limb < ContourLimb::kCount; ++limb) {
    const auto moved =
        scene.tracker.searchLimb(seen, scene.body, best.fit.pose, ContourLimb::Id(limb));
    if (!moved) continue;
    RegionFit other = followed(scene, *moved, kRoundsAfterLimbs);
    if (!isFitted(other)) continue;
    const double gain = qualityOf(other.fit) - qualityOf(best.fit) +
                        overlapOf(other.found.masks, wide) - overlapOf(best.found.masks, wide) +
                        floating(best) - floating(other);
    if (gain <= kMinGain) continue;
    best = std::move(other);
    better = true;
  }
  if (!better) return std::nullopt;
  return best;
}

}  // namespace

double RegionFit::score() const {
  return qualityOf(fit) + found.overlap - floating(*this);
}

RegionFit fitByColor(const ColorScene& scene, const ContourPose& pose) {
  return followed(SearchedScene(scene), pose, kRoundsAfterLimbs);
}

std::optional<RegionFit> searchLimbsByColor(const ColorScene& scene, const RegionFit& first) {
  return withOtherLimbs(SearchedScene(scene), first);
}

std::vector<RegionFit> searchByColor(const ColorScene& scene, const std::vector<ContourPose>& poses,
                                     const RegionFit* rival, size_t limb_searches) {
  const SearchedScene searched(scene);
  std::vector<RegionFit> out;
  for (const ContourPose& pose : poses) {
    RegionFit one = followed(searched, pose, kFirstRounds);
    if (isFitted(one) && one.fit.overlap >= kMinOverlap && one.found.agreement >= kMinAgreement)
      out.push_back(std::move(one));
  }
  sortByScore(out);
  dropSame(scene.body, out);
  // The best one first, as a high score spares the others the search for their limbs.
  double highest = rival ? rival->score() : 0.0;
  for (size_t i = 0; i < std::min(limb_searches, out.size()); ++i) {
    highest = std::max(highest, out[i].score());
    if (out[i].score() <= highest - kLargestLimbGain) break;
    if (rival && !limbsDiffer(scene.body, out[i].fit.pose, rival->fit.pose)) continue;
    if (auto better = withOtherLimbs(searched, out[i])) out[i] = std::move(*better);
    highest = std::max(highest, out[i].score());
  }
  sortByScore(out);
  return out;
}

std::vector<RegionFit> searchProposalsByColor(const ColorScene& scene,
                                              const ContourObservation& seen,
                                              const std::vector<ContourPose>& proposals,
                                              const RegionFit* rival, size_t limb_searches) {
  std::vector<ContourPose> starts;
  for (const ContourFit& fit : scene.tracker.bestFits(seen, scene.body, proposals))
    starts.push_back(fit.pose);
  return searchByColor(scene, starts, rival, limb_searches);
}

}  // namespace markerless_mocap
