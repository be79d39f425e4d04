#include "contour/contour_tracker.h"

#include <algorithm>
#include <utility>

#include "contour/fit/view_times.h"
#include "contour/track/exchanged_sides.h"
#include "contour/track/expected_error.h"
#include "contour/track/pose_from_pose_tree.h"
#include "contour/track/pose_report.h"
#include "contour/track/search_times.h"
#include "contour/track/stray_parts.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kReconsiderAfterStart_ns = 2000000000;  // after a start
constexpr int64_t kReconsiderInterval_ns = 200000000;
// A search for limbs by colour takes longer.
// It doubles after each search without success, up to the second value.
constexpr int64_t kLimbSearchInterval_ns = 200000000, kMaxLimbSearchInterval_ns = 1600000000;
// Colours change slowly.
constexpr int64_t kLearningInterval_ns = 100000000;

// A start of lower quality is accepted only if a start on a later frame leads to the same body. The
// mean shape gives a lower quality than the person's own. Furniture confirms itself by standing
// still, so something must have moved in between.
constexpr double kMinQuality = 0.90, kMinQualityOfMeanShape = 0.86;
// Of a person whom nothing hides, 95 % of the fits are better.
constexpr double kUsualQuality = 0.94;
// A start with a smaller overlap is never accepted. A person in a long dress, with the shape
// estimated from one frame, gives an overlap of 0.78; a man together with the chair he sits on
// 0.68.
constexpr double kMinOverlap = 0.72;

// Colours follow a body wherever they are told to look. Where the background is known, the
// silhouettes must show the person, too: this fraction of what colours found, to report a pose and
// to go on. On films on which the pose is right it is 0.86 and more; a body that is beside a man at
// his desk, of whom little is seen, has 0.45 to 0.69.
constexpr double kMinAgreement = 0.75, kLostAgreement = 0.5;

// After a long gap the person may have moved too far for the prediction. A limb or the whole body
// is then fitted to the wrong place, nearly as well as usual; and so it is by some starts.
constexpr int64_t kDoubt_ns = 1000000000;
constexpr double kLonger = 1.5;  // times the last gap: cameras may be slow

// Without them a search finds little, and takes as long.
const char* const kImagesAwaited =
    "images of cameras whose background is not known have been asked for";

const char* const kDoubtful = "a person was found again, but no pose fits as well as before yet";

// Expected error of the outline of a predicted body, where colours are looked for around it.
constexpr double kPredictionError_m = 0.04;

ShapePrior priorOf(const PersonResources& resources, const PersonOptions& person) {
  return {resources.shape_statistics, person.stature, person.stature_sigma};
}

}  // namespace

ContourTracker::ContourTracker(const CameraRig& rig, PersonResources resources,
                               const PersonOptions& person, const ContourOptions& options,
                               InitializerFactory make_initializer)
    : resources_(std::move(resources)),
      person_(person),
      make_initializer_(std::move(make_initializer)),
      observer_(rig, options),
      hypotheses_(rig, options),
      still_contours_(rig) {
  setBody(initialBody(resources_, person_.stature));
  if (person_.measure && !body_->shape_estimated)
    shape_estimator_.emplace(rig, options, priorOf(resources_, person_), person_.shape_poses,
                             resources_.in_background);
}

void ContourTracker::setBody(std::shared_ptr<const TrackedBody> body) {
  color_check_.forget();
  usual_quality_.forget();
  body_ = std::move(body);
  contour_body_.emplace(body_->shape);
  converter_.emplace(body_->model);
  initializer_ = make_initializer_(body_->model);
}

void ContourTracker::reset() {
  hypotheses_.lose();
  color_check_.forget();
  still_contours_.reset();
  reconsider_until_ns_ = next_check_ns_ = next_reconsideration_ns_ = 0;
  next_limb_search_ns_ = limb_search_interval_ns_ = next_start_ns_ = next_learning_ns_ = 0;
  doubted_until_ns_ = 0;
  searching_since_ns_.reset();
  initializer_->reset();
  converter_->reset();
  stamp_.reset();
}

RegionObservation ContourTracker::observe(const Frame& now) const {
  const std::optional<ContourPrediction> predicted = hypotheses_.predict(now.stamp_ns);
  if (!predicted) return observer_.observe(now.regions);
  return observer_.observeNear(now.regions, *contour_body_, predicted->pose, kPredictionError_m);
}

bool ContourTracker::isAccepted(const ContourObservation& seen, const ContourFit& fit) const {
  const bool good = qualityOf(fit) > (shape_estimator_ ? kMinQualityOfMeanShape : kMinQuality);
  return fit.overlap > kMinOverlap && agreement_ > kMinAgreement && hypotheses_.isUnambiguous() &&
         (good || (hypotheses_.isConfirmed() && still_contours_.showLife(seen)));
}

// A limb that colours follow in a wrong place is contradicted by silhouettes, or silhouettes show
// it elsewhere.
void ContourTracker::searchLimbs(const Frame& now, RegionObservation& found, ActiveTrack& active) {
  const double least = *std::min_element(found.limb_agreement.begin(), found.limb_agreement.end());
  const bool doubtful = now.stamp_ns < reconsider_until_ns_ || least < kMinLimbAgreement;
  if (!doubtful) limb_search_interval_ns_ = 0;
  if (!doubtful || now.stamp_ns < next_limb_search_ns_ || !now.regions.needsColors()) return;
  auto better = searchLimbsByColor(
      {observer_, hypotheses_, now.regions, now.products.newestHull(), *contour_body_},
      {found, active.track.fit});
  limb_search_interval_ns_ = better ? kLimbSearchInterval_ns
                                    : std::clamp(2 * limb_search_interval_ns_,
                                                 kLimbSearchInterval_ns, kMaxLimbSearchInterval_ns);
  next_limb_search_ns_ = nextInstant(now.stamp_ns, limb_search_interval_ns_);
  if (!better) return;
  found = std::move(better->found);
  active = hypotheses_.startFrom(now.stamp_ns, better->fit);
}

// A valid pose tree is nearly always right, so it becomes the alternative if it contradicts a pose
// that fits poorly. While the pose is uncertain, an invalid tree and exchanged sides are tried,
// too.
void ContourTracker::reconsider(const Frame& now, const ContourObservation& seen,
                                const ContourTrackingResult& track) {
  const bool started = now.stamp_ns < reconsider_until_ns_;
  const bool uncertain = started || track.status == ContourTrackingStatus::kLimbLost;
  const bool doubtful = uncertain || qualityOf(track.fit) < kUsualQuality;
  if (!doubtful || now.stamp_ns < next_reconsideration_ns_ || hypotheses_.hasAlternative()) return;
  next_reconsideration_ns_ = nextInstant(now.stamp_ns, kReconsiderInterval_ns);
  std::vector<ContourPose> others;
  const PoseTree& tree = now.products.ofThisFrame().tree;
  const auto of_tree = poseFromPoseTree(tree);
  if (of_tree && (uncertain || tree.valid()) &&
      limbsDiffer(*contour_body_, track.fit.pose, *of_tree))
    others.push_back(*of_tree);
  if (started) {
    others.push_back(mirrored(*contour_body_, track.fit.pose));
    others.push_back(withLegsSwapped(*contour_body_, track.fit.pose));
  }
  if (others.empty()) return;
  hypotheses_.proposeAlternative(now.stamp_ns, seen, *contour_body_, others);
}

BodyPose ContourTracker::reported(const ActiveTrack& active) {
  BodyPose pose;
  pose.status = active.switched || !reported_ ? PoseStatus::kReinitialized : PoseStatus::kTracked;
  reported_ = true;
  searching_since_ns_.reset();
  converter_->convert(active.track.fit.pose, pose.T_world_body, pose.angles);
  reportEvidence(active.track.fit, limb_agreement_, pose);
  widenExpectedErrors(*body_, person_, pose);
  if (shape_estimator_)
    pose.reason = measuringProgress() + (pose.reason.empty() ? "" : "; " + pose.reason);
  return pose;
}

void ContourTracker::doubt(int64_t stamp_ns) {
  doubted_until_ns_ = stamp_ns + kDoubt_ns;
  accepted_ = false;
  next_check_ns_ = next_reconsideration_ns_ = 0;
}

bool ContourTracker::isDoubted(int64_t stamp_ns, const ContourFit& fit) const {
  return stamp_ns < doubted_until_ns_ && !usual_quality_.includes(qualityOf(fit));
}

bool ContourTracker::isBelieved() const {
  return accepted_ && agreement_ > kMinAgreement;
}

bool ContourTracker::isReportable(const Frame& now, const ContourObservation& seen) const {
  if (!isBelieved() || !shape_estimator_) return isBelieved();
  const bool checked = !now.regions.needsColors() || color_confirmations_ > 0;
  return hypotheses_.isUnambiguous() && (reported_ || (checked && still_contours_.showLife(seen)));
}

BodyPose ContourTracker::unaccepted(const ContourFit& fit) const {
  BodyPose pose;
  if (fit.overlap <= kMinOverlap)
    pose.reason = overlapTooSmall(fit);
  else if (agreement_ <= kMinAgreement)
    pose.reason = "colours show a person where the silhouettes show background";
  else if (accepted_ && hypotheses_.isUnambiguous())
    pose.reason = measuringProgress();
  else
    pose.reason = whyUncertain(hypotheses_);
  return pose;
}

void ContourTracker::take(const RegionObservation& found) {
  agreement_ = found.agreement;
  limb_agreement_ = found.limb_agreement;
}

void ContourTracker::learn(const Frame& now, const ActiveTrack& active) {
  if (now.stamp_ns < next_learning_ns_ && !active.switched) return;
  next_learning_ns_ = nextInstant(now.stamp_ns, kLearningInterval_ns);
  observer_.learn(now.regions, *contour_body_, active.track.fit.pose);
}

ActiveTrack ContourTracker::follow(const Frame& now, RegionObservation& found) {
  ActiveTrack active = hypotheses_.update(now.stamp_ns, found.seen, *contour_body_,
                                          onlyFollows(now) ? Effort::kFollow : Effort::kSearch);
  if (active.track.status == ContourTrackingStatus::kLost) {
    doubt(now.stamp_ns);
    active = start(now);
    accepted_ = isAccepted(found.seen, active.track.fit);
    reported_ = false;
    return active;
  }
  active = takeCheck(now, active);
  if (needsCheck(now)) active = check(now, active);
  accepted_ = accepted_ || isAccepted(found.seen, active.track.fit);
  if (onlyFollows(now)) return active;
  searchLimbs(now, found, active);
  reconsider(now, found.seen, active.track);
  return active;
}

BodyPose ContourTracker::update(const TrackerInput& now) {
  observer_.check(now.masks);
  if (stamp_ && now.stamp_ns <= *stamp_) reset();
  const int64_t gap_ns = stamp_ ? now.stamp_ns - *stamp_ : 0;
  if (gap_ns > kLongGap_ns && double(gap_ns) > kLonger * double(gap_ns_)) doubt(now.stamp_ns);
  gap_ns_ = gap_ns;
  stamp_ = now.stamp_ns;
  const bool follows = hypotheses_.predict(now.stamp_ns).has_value();
  if (!follows && (now.images_awaited || restsFromSearching(now))) {
    still_contours_.watch(now.stamp_ns, now.images, now.masks);
    BodyPose still_lost;
    still_lost.reason = now.images_awaited ? kImagesAwaited : lost_reason_;
    return still_lost;
  }
  const auto hull = [&]() -> const VisualHull& {
    return follows ? now.products.newestHull() : now.products.forStart().hull;
  };
  const std::vector<cv::Mat> masks = withoutStrayParts(now.masks, hull, still_contours_.rig());
  still_contours_.watch(now.stamp_ns, now.images, masks);
  return updateFrom({now.stamp_ns, now.products, now.behind, {now.images, masks}, now.later_s});
}

bool ContourTracker::restsFromSearching(const TrackerInput& now) const {
  if (now.stamp_ns >= next_start_ns_) return false;
  return somebody_there_ || now.products.newestHull().voxels.empty();
}

BodyPose ContourTracker::lost(const ContourObservation& seen, const ContourFit& fit) {
  BodyPose pose;
  pose.reason = lost_reason_ = whyLost(seen, fit, initializer_error_);
  return pose;
}

BodyPose ContourTracker::updateFrom(const Frame& now) {
  RegionObservation found = observe(now);
  if (const auto motion = hypotheses_.motion(now.stamp_ns))
    shiftViews(*contour_body_, *motion, now.later_s, &found.seen);
  still_contours_.weigh(found.seen);
  take(found);
  if (agreement_ < kLostAgreement) hypotheses_.lose();
  const ActiveTrack active = follow(now, found);
  if (active.switched) reconsider_until_ns_ = now.stamp_ns + kReconsiderAfterStart_ns;
  const ContourFit& fit = active.track.fit;
  if (active.track.status == ContourTrackingStatus::kLost) return lost(found.seen, fit);
  learn(now, active);
  still_contours_.compare(found.seen, *contour_body_, fit.pose);
  if (measure(now.stamp_ns, found.seen, fit)) {
    BodyPose pose;
    pose.reason = "the body has just been measured";
    return pose;
  }
  if (isDoubted(now.stamp_ns, fit)) {
    hypotheses_.searchSoon();
    BodyPose pose;
    pose.reason = kDoubtful;
    return pose;
  }
  if (now.stamp_ns >= doubted_until_ns_ && isBelieved()) usual_quality_.add(qualityOf(fit));
  return isReportable(now, found.seen) ? reported(active) : unaccepted(fit);
}

}  // namespace markerless_mocap
