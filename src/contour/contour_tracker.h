#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contour/measure/measured_person.h"
#include "contour/regions/region_search.h"
#include "contour/track/color_check.h"
#include "contour/track/contour_multi_hypothesis_tracker.h"
#include "contour/track/contradicted_views.h"
#include "contour/track/moving_contours.h"
#include "contour/track/pose_trust.h"
#include "contour/track/search_times.h"
#include "contour/track/start_proposals.h"
#include "contour/track/start_schedule.h"
#include "markerless_mocap/tracking/body_tracker.h"

namespace markerless_mocap {

/// Fits the body to the silhouette contours of each frame. The last pose predicts the next one.
/// Without a last pose, an initializer, the pose tree and default postures propose some. An
/// alternative hypothesis is tracked while front and back, or left and right, are uncertain.
class ContourTracker : public BodyTracker {
 public:
  /// Throws std::invalid_argument if an option is out of range, if the rig has no cameras, or if
  /// the URDF template describes no suitable body.
  ContourTracker(const CameraRig& rig, PersonResources resources, const PersonOptions& person,
                 const ContourOptions& options, InitializerFactory make_initializer);
  BodyPose update(const TrackerInput& now) override;
  std::vector<bool> wantedImages() const override { return wanted_images_; }
  void prepare(size_t camera, const cv::Mat& mask) const override {
    observer_.prepare(camera, mask);
  }
  std::vector<BodyPose> followBack(const std::vector<TrackerInput>& earlier) override;
  void estimateShapeNow() override;
  void reset() override;
  const std::shared_ptr<const TrackedBody>& body() const override { return person_.tracked(); }

 private:
  using Report = std::function<void(const BodyPose&)>;
  /// A frame set; its masks show those parts only that are the person's.
  struct Frame {
    int64_t stamp_ns;
    ProductSource& products;
    const std::function<bool()>& behind;
    Report report;  ///< empty as well until the first pose: better ones make it sure
    RegionFrame regions;
    std::vector<double> later_s;         ///< by camera, as TrackerInput has it
    std::vector<cv::Mat> doubted_masks;  ///< as they came; empty if none is in doubt
  };
  /// What a search is fitted to, and the poses that it starts from.
  struct Search {
    RegionObservation found;
    std::vector<ContourPose> poses;
  };

  // One frame (contour_tracker.cpp).

  /// Notes the stamp; the poses are doubted after an unusually long gap.
  void noteStamp(int64_t stamp_ns);
  BodyPose updateFrom(const Frame& now);
  /// Says where the body is in views that are of another time.
  void shift(const Frame& now, ContourObservation& seen) const;
  /// The masks, or colours around the predicted pose.
  RegionObservation observe(const Frame& now) const;
  /// Continues the pose of the last frame or starts. \param found replaced if colours show other
  /// places of limbs
  ActiveTrack follow(const Frame& now, RegionObservation& found);
  /// Continues the pose of the last frame, without views that contradict most others. \param seen
  /// their views are removed
  ActiveTrack continued(const Frame& now, ContourObservation& seen);
  /// What is reported of this frame. \param is_far_worse the pose fits far worse than usual
  BodyPose judgedPose(const Frame& now, const ContourObservation& seen, const ActiveTrack& active,
                      bool is_far_worse);
  /// Looks for a better pose: after this one has been reported if somebody waits for it.
  void improve(const Frame& now, RegionObservation& found, ActiveTrack& active);
  /// True if by now nothing but the last pose may take time: newer frame sets wait, or a check that
  /// decides if anything is reported.
  bool onlyFollows(const Frame& now) const;
  /// For some time after a gap or a new start, a pose is reported only if it fits as well as usual.
  void doubt(int64_t stamp_ns);
  /// Learns the colours at the pose.
  void learn(const Frame& now, const ActiveTrack& active);
  /// Takes the pose for the measurement of the body. Returns true if the body has been measured
  /// now: the pose is still that of the mean body.
  bool measure(int64_t stamp_ns, const ContourObservation& seen, const ContourFit& fit);
  bool useMeasuredBody();
  /// Forgets what depends on the body.
  void bodyHasChanged();
  JudgedPose judged(const ContourObservation& seen, const ContourFit& fit) const;
  /// True if the pose may be reported. That of a mean body only after something has moved, as many
  /// things are like some body, and after another search has confirmed what colours follow; not
  /// while an alternative is followed, or fits better than what was reported before: a body that is
  /// not the person's hardly tells a wrong pose from a right one.
  bool isReportable(const Frame& now, const ContourObservation& seen) const;
  BodyPose lost(const ContourObservation& seen, const ContourFit& fit);
  BodyPose unaccepted(const ContourFit& fit) const;
  BodyPose reported(const ActiveTrack& active);

  // Back in time (contour_tracker_back.cpp).

  /// Whatever an update() changes while time goes back.
  auto state();

  // A start (contour_tracker_start.cpp).

  /// True if the last start has failed a short time ago and nobody has come since.
  bool restsFromSearching(const TrackerInput& now) const;
  ActiveTrack start(const Frame& now);
  /// Proposals of this frame set.
  std::vector<ContourPose> proposals(const Frame& now);
  /// The same, and default postures if none fits well.
  std::vector<ContourPose> completeProposals(const Frame& now, const ContourObservation& seen);
  /// Where the background is not known: the most promising poses, fitted to colours; best first.
  std::vector<RegionFit> fitsByColor(const Frame& now, const Search& search) const;
  /// Looks for bodies of other statures around the best pose, if it fits poorly. \param fits
  /// replaced by a better one. Returns whether the stature has changed.
  bool findOtherStature(const Frame& now, std::vector<RegionFit>& fits);
  /// Replaces the poses by the most promising one that colours show. Returns false if there is
  /// none.
  bool findByColor(const Frame& now, Search& search);
  /// Starts from what findByColor() has found, with the mirrored pose as alternative.
  ActiveTrack startFound(const Frame& now, const Search& search);
  /// Takes the stature that fits best, as long as the person has not been measured. Colours are not
  /// asked: they were found around a body of some stature.
  void initializeStature(const Frame& now, const std::vector<ContourPose>& poses,
                         const RobustSchedule& schedule = RobustSchedule::wide());

  // Checks of the pose that is followed (contour_tracker_check.cpp).

  /// True if the pose of a start is to be compared with that of another start now.
  bool needsCheck(const Frame& now, const ContourFit& fit) const;
  /// Starts a second time. The result confirms or replaces the pose, or leaves it as it is.
  ActiveTrack check(const Frame& now, const ActiveTrack& active);
  ActiveTrack checkByColor(const Frame& now, const ActiveTrack& active);
  /// Asks whether colours show another pose; none of those that were learned count.
  ColorQuestion question(const Frame& now, const ContourPose& pose);
  /// Takes up what a check in another thread has found, if it has ended.
  ActiveTrack takeCheck(const Frame& now, const ActiveTrack& active);
  /// Confirms the pose or replaces it.
  ActiveTrack settle(const Frame& now, const ActiveTrack& active,
                     const std::optional<RegionFit>& found);
  /// Takes other places of limbs if they agree better with colours and silhouettes.
  void searchLimbs(const Frame& now, RegionObservation& found, ActiveTrack& active);
  /// Takes other places of limbs that masks in doubt show.
  void searchLimbsInDoubt(const Frame& now, ActiveTrack& active);
  /// Takes the pose tree, or a pose with exchanged sides, as alternative to a doubtful pose.
  void reconsider(const Frame& now, const ContourObservation& seen,
                  const ContourTrackingResult& track);
  /// True for some time after a start, or after another hypothesis has become active.
  bool isFresh(const Frame& now) const { return now.stamp_ns < fresh_until_ns_; }

  RegionObserver observer_;
  ContourMultiHypothesisTracker hypotheses_;
  MovingContours moving_contours_;
  std::vector<bool> wanted_images_;  ///< by camera, of the last masks
  ContradictedViews contradicted_;
  MeasuredPerson person_;
  StartProposals proposals_;
  PoseTrust trust_;
  ColorCheck color_check_;
  StartSchedule starts_;
  SearchTimer learning_, reconsideration_, search_in_doubt_;
  PatientSearchTimer limb_search_;
  int64_t fresh_until_ns_ = 0;
  /// In time: nobody is searched for, neither colours nor motion are learned.
  bool goes_back_ = false;
  bool reported_ = false;         ///< a pose of this body has been reported since the last start
  bool is_at_person_ = false;     ///< a pose has been reported since then, perhaps of another body
  std::string lost_reason_;       ///< of the last start
  std::optional<int64_t> stamp_;  ///< of the last frame
  int64_t gap_ns_ = 0;            ///< between the last two frames
};

}  // namespace markerless_mocap
