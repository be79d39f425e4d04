#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/contour/contour_sizes.h"
#include "markerless_mocap/fitting/body_pose.h"
#include "markerless_mocap/fitting/motion_statistics.h"
#include "markerless_mocap/fitting/tracker_options.h"
#include "markerless_mocap/hull/visual_hull.h"
#include "markerless_mocap/skeleton/pose_tree.h"

namespace markerless_mocap {

/// What the stages made of one instant. All must outlive the call it is given to.
struct TrackingInstant {
  int64_t stamp_ns;                    ///< capture time
  const std::vector<cv::Mat>& masks;   ///< by camera, CV_8UC1 0 | 255; empty where missing
  const std::vector<cv::Mat>& images;  ///< by camera, grey or BGR; empty where missing
  const VisualHull& hull;
  const BodyParts& parts;
  const PoseTree& tree;
};

/// The person that is followed.
struct TrackedBody {
  std::string urdf;
  std::shared_ptr<const BodyModel> model;
  /// Of the body that contours are fitted with.
  ContourSizes sizes;
  bool measured = false;  ///< sizes are this person's, else those of people of the stature
};

/// What a tracker is made from beside options.
struct TrackerSources {
  std::string body_id = "person1";
  std::string urdf_template;                             ///< text of urdf/human.urdf.in
  ContourTemplate people = ContourTemplate::handMade();  ///< better: config/contour_body.yaml
  MotionStatistics motion;               ///< config/motion_statistics.yaml; for sppso
  std::optional<ContourSizes> measured;  ///< sizes of this person from an earlier run
  bool in_background = false;  ///< the body is measured while instants go on; else update() waits
};

/// Follows one person from instant to instant by one of the methods. Not thread-safe.
class BodyTracker {
 public:
  virtual ~BodyTracker() = default;
  /// \param now stamps that do not rise restart the track. Throws std::invalid_argument on masks or
  ///   images that do not fit the rig
  virtual BodyPose update(const TrackingInstant& now) = 0;
  virtual void reset() = 0;
  /// Measures the body from what has been seen so far, however little, instead of waiting for more.
  virtual void measureNow() {}
  /// The person's body now; it changes when it has been measured, within update() only.
  virtual const std::shared_ptr<const TrackedBody>& body() const = 0;
};

/// Throws std::invalid_argument on options out of range, a URDF template that gives no body, or a
/// rig without cameras for a method that needs their masks.
std::unique_ptr<BodyTracker> makeBodyTracker(const CameraRig& rig, const TrackerSources& sources,
                                             const TrackerOptions& options);

}  // namespace markerless_mocap
