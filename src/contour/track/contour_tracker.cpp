#include "contour/contour_tracker.h"

#include <utility>

#include "contour/fit/view_times.h"
#include "contour/regions/placed_contour_body.h"
#include "contour/track/expected_error.h"
#include "contour/track/pose_report.h"
#include "contour/track/stray_parts.h"
#include "region/things_beside.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFresh_ns = 2000000000;  // after a start
constexpr int64_t kReconsiderInterval_ns = 200000000;
// A search for limbs by colour takes longer.
// It doubles after each search without success, up to the second value.
constexpr int64_t kLimbSearchInterval_ns = 200000000, kMaxLimbSearchInterval_ns = 1600000000;
// Colours change slowly.
constexpr int64_t kLearningInterval_ns = 100000000;

// A gap is long if it is so many times the last one: cameras may be slow.
constexpr double kLonger = 1.5;

// Without them a search finds little, and takes as long.
const char* const kImagesAwaited =
    "images of cameras whose background is not known have been asked for";

const char* const kDoubtful = "a person was found again, but no pose fits as well as before yet";
const char* const kFarWorse =
    "no pose fits nearly as well as before: cameras may be covered, out of focus or moved";

// Expected error of the outline of a predicted body, where colours are looked for around it.
constexpr double kPredictionError_m = 0.04;

std::string joined(const std::string& first, const std::string& second) {
  return first + (first.empty() || second.empty() ? "" : "; ") + second;
}

std::vector<bool> colored(const std::vector<cv::Mat>& images) {
  std::vector<bool> colored;
  for (const cv::Mat& image : images) colored.push_back(image.type() == CV_8UC3);
  return colored;
}

BodyPose lostBecause(std::string reason) {
  BodyPose pose;
  pose.reason = std::move(reason);
  return pose;
}

}  // namespace

ContourTracker::ContourTracker(const CameraRig& rig, PersonResources resources,
                               const PersonOptions& person, const ContourOptions& options,
                               InitializerFactory make_initializer)
    : observer_(rig, options),
      hypotheses_(rig, options),
      moving_contours_(rig.size()),
      person_(rig, std::move(resources), person, options),
      proposals_(std::move(make_initializer)),
      learning_(kLearningInterval_ns),
      reconsideration_(kReconsiderInterval_ns),
      search_in_doubt_(kReconsiderInterval_ns),
      limb_search_(kLimbSearchInterval_ns, kMaxLimbSearchInterval_ns) {
  bodyHasChanged();
}

void ContourTracker::bodyHasChanged() {
  color_check_.forget();
  trust_.forgetQuality();
  proposals_.setBody(person_.tracked()->model);
}

void ContourTracker::reset() {
  hypotheses_.lose();
  color_check_.forget();
  moving_contours_.reset();
  contradicted_.reset();
  starts_ = StartSchedule();
  learning_.dueNow();
  reconsideration_.dueNow();
  search_in_doubt_.dueNow();
  limb_search_.reset();
  fresh_until_ns_ = 0;
  trust_.endDoubt();
  proposals_.reset();
  person_.converter().reset();
  stamp_.reset();
}

void ContourTracker::noteStamp(int64_t stamp_ns) {
  if (stamp_ && stamp_ns <= *stamp_) reset();
  const int64_t gap_ns = stamp_ ? stamp_ns - *stamp_ : 0;
  if (gap_ns > kLongGap_ns && double(gap_ns) > kLonger * double(gap_ns_)) doubt(stamp_ns);
  gap_ns_ = gap_ns;
  stamp_ = stamp_ns;
}

BodyPose ContourTracker::update(const TrackerInput& now) {
  observer_.check(now.masks);
  wanted_images_.clear();
  noteStamp(now.stamp_ns);
  const std::optional<ContourPrediction> predicted = hypotheses_.predict(now.stamp_ns);
  const bool follows = predicted.has_value();
  if (!follows && (now.images_awaited || restsFromSearching(now))) {
    moving_contours_.watch(now.stamp_ns, now.images, now.masks);
    return lostBecause(now.images_awaited ? kImagesAwaited : lost_reason_);
  }
  const auto hull = [&]() -> const VisualHull& {
    return follows ? now.products.newestHull() : now.products.forStart().hull;
  };
  const ClearedMasks cleared =
      follows && is_at_person_
          ? withoutThingsBeside(now.masks, colored(now.images), observer_.rig(),
                                placedBody(person_.body(), predicted->pose), predicted->seconds)
          : ClearedMasks{withoutStrayParts(now.masks, hull(), observer_.rig()), {}};
  wanted_images_ = cleared.doubted;
  if (!goes_back_) moving_contours_.watch(now.stamp_ns, now.images, cleared.masks);
  const bool in_doubt = contradicted_.leaveAnyOf(cleared.doubted);
  return updateFrom({now.stamp_ns,
                     now.products,
                     now.behind,
                     reported_ ? now.report : Report(),
                     {now.images, cleared.masks},
                     now.later_s,
                     in_doubt ? now.masks : std::vector<cv::Mat>()});
}

BodyPose ContourTracker::updateFrom(const Frame& now) {
  RegionObservation found = observe(now);
  shift(now, found.seen);
  contradicted_.leaveOut(found.seen);
  trust_.take(found);
  if (trust_.isContradicted()) hypotheses_.lose();
  ActiveTrack active = follow(now, found);
  if (active.switched) fresh_until_ns_ = now.stamp_ns + kFresh_ns;
  const ContourFit& fit = active.track.fit;
  if (active.track.status == ContourTrackingStatus::kLost) return lost(found.seen, fit);
  const bool is_far_worse = trust_.doubtIfFarWorse(now.stamp_ns, fit);
  if (is_far_worse) starts_.searchBegins(now.stamp_ns);
  if (measure(now.stamp_ns, found.seen, fit)) return lostBecause("the body has just been measured");
  BodyPose pose = judgedPose(now, found.seen, active, is_far_worse);
  if (now.report) {
    now.report(pose);
    improve(now, found, active);
  }
  if (!is_far_worse) learn(now, active);
  return pose;
}

BodyPose ContourTracker::judgedPose(const Frame& now, const ContourObservation& seen,
                                    const ActiveTrack& active, bool is_far_worse) {
  const ContourFit& fit = active.track.fit;
  if (trust_.isDoubted(now.stamp_ns, fit)) {
    hypotheses_.searchSoon();
    return lostBecause(is_far_worse ? kFarWorse : kDoubtful);
  }
  trust_.learnQuality(now.stamp_ns, fit);
  return isReportable(now, seen) ? reported(active) : unaccepted(fit);
}

void ContourTracker::shift(const Frame& now, ContourObservation& seen) const {
  if (const auto motion = hypotheses_.motion(now.stamp_ns))
    shiftViews(person_.body(), *motion, now.later_s, &seen);
}

RegionObservation ContourTracker::observe(const Frame& now) const {
  const std::optional<ContourPrediction> predicted = hypotheses_.predict(now.stamp_ns);
  if (!predicted) return observer_.observe(now.regions);
  return observer_.observeNear(now.regions, person_.body(), predicted->pose, kPredictionError_m);
}

ActiveTrack ContourTracker::continued(const Frame& now, ContourObservation& seen) {
  const auto may_search = [&] { return !onlyFollows(now); };
  const ContourMultiHypothesisTracker before = hypotheses_;
  ActiveTrack active = hypotheses_.update(now.stamp_ns, seen, person_.body(), may_search);
  const auto contradicted = [&] {
    return active.track.status != ContourTrackingStatus::kLost &&
           contradicted_.judge(observer_.rig(), person_.body(), seen, active.track.fit);
  };
  if (!contradicted()) return active;
  contradicted_.leaveOut(seen);
  hypotheses_ = before;
  active = hypotheses_.update(now.stamp_ns, seen, person_.body(), may_search);
  contradicted();
  return active;
}

ActiveTrack ContourTracker::follow(const Frame& now, RegionObservation& found) {
  ActiveTrack active = continued(now, found.seen);
  if (active.track.status == ContourTrackingStatus::kLost) {
    if (goes_back_) return active;
    doubt(now.stamp_ns);
    contradicted_.reset();
    active = start(now);
    active.started = true;
    trust_.judgeStart(judged(found.seen, active.track.fit));
    reported_ = is_at_person_ = false;
    return active;
  }
  if (!now.report) improve(now, found, active);
  active = takeCheck(now, active);
  if (needsCheck(now, active.track.fit)) active = check(now, active);
  trust_.judge(judged(found.seen, active.track.fit));
  return active;
}

void ContourTracker::improve(const Frame& now, RegionObservation& found, ActiveTrack& active) {
  if (active.started || onlyFollows(now)) return;
  if (const auto better = hypotheses_.improve(found.seen, person_.body()))
    active.track.fit = *better;
  if (!onlyFollows(now)) searchLimbs(now, found, active);
  if (!onlyFollows(now)) searchLimbsInDoubt(now, active);
  if (!onlyFollows(now)) reconsider(now, found.seen, active.track);
}

bool ContourTracker::onlyFollows(const Frame& now) const {
  return (now.behind && now.behind()) || (color_check_.isBusy() && !reported_);
}

void ContourTracker::doubt(int64_t stamp_ns) {
  trust_.doubt(stamp_ns);
  starts_.checkNow();
  reconsideration_.dueNow();
}

void ContourTracker::learn(const Frame& now, const ActiveTrack& active) {
  if (goes_back_ || (!learning_.isDue(now.stamp_ns) && !active.switched)) return;
  learning_.done(now.stamp_ns);
  observer_.learn(now.regions, person_.body(), active.track.fit.pose);
}

bool ContourTracker::measure(int64_t stamp_ns, const ContourObservation& seen,
                             const ContourFit& fit) {
  person_.add(stamp_ns, seen, fit, trust_.isBelieved() && hypotheses_.isUnambiguous());
  return useMeasuredBody();
}

void ContourTracker::estimateShapeNow() {
  person_.measureNow();
  useMeasuredBody();
}

bool ContourTracker::useMeasuredBody() {
  if (!person_.takeMeasured()) return false;
  bodyHasChanged();
  reported_ = false;  // the next pose is that of another body
  return true;
}

JudgedPose ContourTracker::judged(const ContourObservation& seen, const ContourFit& fit) const {
  return {fit, seen, hypotheses_, moving_contours_, person_.isBeingMeasured()};
}

bool ContourTracker::isReportable(const Frame& now, const ContourObservation& seen) const {
  if (!trust_.isBelieved() || !person_.isBeingMeasured()) return trust_.isBelieved();
  const bool checked = !now.regions.needsColors() || starts_.isConfirmed();
  if (reported_) return hypotheses_.isAhead();
  return hypotheses_.isUnambiguous() && checked && moving_contours_.showLife(seen);
}

BodyPose ContourTracker::lost(const ContourObservation& seen, const ContourFit& fit) {
  lost_reason_ = whyLost(seen, fit, proposals_.initializerError());
  return lostBecause(lost_reason_);
}

BodyPose ContourTracker::unaccepted(const ContourFit& fit) const {
  const std::string reason = trust_.whyUncertain(fit, hypotheses_);
  return lostBecause(reason.empty() ? person_.progress() : reason);
}

BodyPose ContourTracker::reported(const ActiveTrack& active) {
  BodyPose pose;
  pose.status = active.switched || !reported_ ? PoseStatus::kReinitialized : PoseStatus::kTracked;
  reported_ = is_at_person_ = true;
  starts_.poseReported();
  person_.converter().convert(active.track.fit.pose, pose.T_world_body, pose.angles);
  reportEvidence(active.track.fit, trust_.limbAgreement(), pose);
  widenExpectedErrors(*person_.tracked(), person_.options(), pose);
  if (person_.isBeingMeasured()) pose.reason = joined(person_.progress(), pose.reason);
  pose.reason = joined(pose.reason, contradicted_.described(observer_.rig()));
  return pose;
}

}  // namespace markerless_mocap
