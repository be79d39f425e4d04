#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "evaluation/angle_error.h"
#include "evaluation/joint_track.h"
#include "evaluation/tracking_continuity.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Result of a tracker in one frame.
struct ResultFrame {
  int64_t stamp_ns = 0;
  FrameStatus status = FrameStatus::kMissing;
  std::string reason;
  LinkPoses T_world_link;  ///< NaN if a link is not seen; empty without a pose
  /// Estimated standard deviations of thorax, head, wrists, ankles, metres; NaN if unknown.
  std::array<double, 6> part_sigma_m{NAN, NAN, NAN, NAN, NAN, NAN};
};

/// Results of a tracker in a bag.
struct ResultRecord {
  std::string body_id;
  std::string world_frame;
  std::shared_ptr<const BodyModel> body;
  bool has_description = false;     ///< true: `body` is the tracked body; false: only its names are
                                    ///< valid
  bool has_status = false;          ///< the bag has the topic /pose
  std::vector<ResultFrame> frames;  ///< in the order of time
  JointTrack joints;                ///< bodyPointNames() of the frames with a pose
  std::vector<AngleFrame> angles;   ///< of the frames with a pose
  std::vector<double> latencies;    ///< record time minus stamp of each pose, s
};

/// Reads /tf and /tf_static, /pose (a lost frame has no estimate even if tf has one), joint states
/// and the URDF of the body. Throws std::runtime_error if the bag cannot be read, or if it has no
/// body, or several bodies and none of them is `id`.
/// \param id empty: the only body
/// \param urdf text that replaces the bag's description; empty: the bag's
ResultRecord readResults(const std::string& path, const std::string& id,
                         const std::string& urdf = "");

/// The name of a joint without the id that REP-155 appends: "l_elbow_person1" becomes "l_elbow".
std::string withoutId(const std::string& name);

}  // namespace markerless_mocap
