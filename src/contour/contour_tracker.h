#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contour/contour_urdf_converter.h"
#include "contour/measure/online_shape_estimator.h"
#include "contour/regions/region_search.h"
#include "contour/track/color_check.h"
#include "contour/track/contour_multi_hypothesis_tracker.h"
#include "contour/track/still_contours.h"
#include "contour/track/usual_quality.h"
#include "markerless_mocap/contour/contour_options.h"
#include "markerless_mocap/tracking/body_tracker.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/person_resources.h"
#include "tracking/pose_initializer.h"

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
  void estimateShapeNow() override;
  void reset() override;
  const std::shared_ptr<const TrackedBody>& body() const override { return body_; }

 private:
  /// A frame set; its masks show those parts only that are the person's.
  struct Frame {
    int64_t stamp_ns;
    ProductSource& products;
    bool behind;
    RegionFrame regions;
    std::vector<double> later_s;  ///< by camera, as TrackerInput has it
  };
  BodyPose updateFrom(const Frame& now);
  /// True if the last start has failed a short time ago and nobody has come since.
  bool restsFromSearching(const TrackerInput& now) const;
  BodyPose lost(const ContourObservation& seen, const ContourFit& fit);
  /// Continues the pose of the last frame or starts. \param found replaced if colours show other
  /// places of limbs
  ActiveTrack follow(const Frame& now, RegionObservation& found);
  /// Learns the colours at the pose.
  void learn(const Frame& now, const ActiveTrack& active);
  /// What the pose of this frame comes from.
  void take(const RegionObservation& found);
  void setBody(std::shared_ptr<const TrackedBody> body);
  /// Returns true if an estimate was available.
  bool useEstimatedShape();
  /// Quality of the best fit of the mean body. \param stature metres
  double qualityAt(double stature, const ContourObservation& seen,
                   const std::vector<ContourPose>& poses, const RobustSchedule& schedule) const;
  /// Takes the stature that fits best, as long as the person has not been measured. Colours are not
  /// asked: they were found around a body of some stature.
  void initializeStature(const Frame& now, const std::vector<ContourPose>& poses,
                         const RobustSchedule& schedule = RobustSchedule::wide());
  ActiveTrack start(const Frame& now);
  /// When to check a start from this frame, and when to start again if it fails.
  void scheduleStart(const Frame& now);
  /// Time to the next search, longer the longer nothing is found; at least the given one.
  int64_t restAfterSearch(int64_t stamp_ns, int64_t least_ns) const;
  /// What a search is fitted to, and the poses that it starts from.
  struct Search {
    RegionObservation found;
    std::vector<ContourPose> poses;
  };
  /// The masks, or colours around the predicted pose.
  RegionObservation observe(const Frame& now) const;
  /// Where the background is not known: the most promising poses, fitted to colours; best first.
  std::vector<RegionFit> fitsByColor(const Frame& now, const Search& search) const;
  /// Replaces the poses by the most promising one that colours show. Returns false if there is
  /// none.
  bool findByColor(const Frame& now, Search& search);
  /// Starts from what findByColor() has found, with the mirrored pose as alternative.
  ActiveTrack startFound(const Frame& now, const Search& search);
  /// True if nothing but the last pose may take time: newer frame sets wait, or a check that
  /// decides if anything is reported.
  bool onlyFollows(const Frame& now) const;
  /// True if the pose of a start is to be compared with that of another start now.
  bool needsCheck(const Frame& now) const;
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
  /// True if a pose that was found by a search may be reported.
  bool isAccepted(const ContourObservation& seen, const ContourFit& fit) const;
  /// True if the pose has been accepted and the silhouettes of this frame set do not contradict it.
  bool isBelieved() const;
  /// Those of the initializer and of the pose tree.
  std::vector<ContourPose> proposals(const Frame& now);
  /// The same, and default postures if none fits well.
  std::vector<ContourPose> completeProposals(const Frame& now, const ContourObservation& seen);
  /// Takes other places of limbs if they agree better with colours and silhouettes.
  void searchLimbs(const Frame& now, RegionObservation& found, ActiveTrack& active);
  void reconsider(const Frame& now, const ContourObservation& seen,
                  const ContourTrackingResult& track);
  /// Takes the pose for the estimate of the body shape, if there is none yet. Returns true if the
  /// shape has been estimated now: the pose is still that of the mean body.
  bool measure(int64_t stamp_ns, const ContourObservation& seen, const ContourFit& fit);
  /// What the user is told meanwhile.
  std::string measuringProgress() const;
  /// For some time after a gap or a new start, a pose is reported only if it fits as well as usual.
  void doubt(int64_t stamp_ns);
  bool isDoubted(int64_t stamp_ns, const ContourFit& fit) const;
  /// True if the pose may be reported. That of a mean body only after something has moved, as many
  /// things are like some body, and after another search has confirmed what colours follow; not
  /// while an alternative is followed: a body that is not the person's hardly tells a wrong pose
  /// from a right one.
  bool isReportable(const Frame& now, const ContourObservation& seen) const;
  BodyPose unaccepted(const ContourFit& fit) const;
  BodyPose reported(const ActiveTrack& active);

  PersonResources resources_;
  PersonOptions person_;
  InitializerFactory make_initializer_;
  RegionObserver observer_;
  ContourMultiHypothesisTracker hypotheses_;
  StillContours still_contours_;
  // Of the last frame, see RegionMasks.
  double agreement_ = 1.0;
  std::array<double, ContourLimb::kCount> limb_agreement_{};
  bool accepted_ = false;       ///< the pose has been accepted since the last start
  bool reported_ = false;       ///< a pose has been reported since the last start
  UsualQuality usual_quality_;  ///< of poses that are not doubted
  int64_t doubted_until_ns_ = 0;
  int64_t reconsider_until_ns_ = 0, next_reconsideration_ns_ = 0, next_check_ns_ = 0;
  int64_t next_limb_search_ns_ = 0, next_start_ns_ = 0, next_learning_ns_ = 0;
  std::optional<int64_t> searching_since_ns_;       ///< no pose has been reported since
  bool somebody_there_ = false;                     ///< at the last start: a hull
  std::string lost_reason_;                         ///< of the last start
  int color_checks_ = 0, color_confirmations_ = 0;  ///< since the last start
  int64_t limb_search_interval_ns_ = 0;  ///< to the next search if this one has no success
  ColorCheck color_check_;
  std::optional<OnlineShapeEstimator> shape_estimator_;
  std::shared_ptr<const TrackedBody> body_;
  std::optional<ContourBody> contour_body_;        ///< with the shape of body_
  std::optional<ContourUrdfConverter> converter_;  ///< to the joint angles of body_
  std::unique_ptr<PoseInitializer> initializer_;   ///< proposes poses after a loss
  std::optional<int64_t> stamp_;                   ///< of the last frame
  int64_t gap_ns_ = 0;                             ///< between the last two frames
  std::string initializer_error_;                  ///< why it proposed no pose
};

}  // namespace markerless_mocap
