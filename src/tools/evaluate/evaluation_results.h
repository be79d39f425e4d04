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

/// What a tracker said about one instant.
struct ResultFrame {
  int64_t stamp_ns = 0;
  FrameStatus status = FrameStatus::kMissing;
  std::string reason;
  LinkPoses T_world_link;  ///< NaN where a link is not seen; empty without a pose
  /// Expected errors of thorax, head, wrists, ankles, metres; NaN where not told.
  std::array<double, 6> part_sigma_m{NAN, NAN, NAN, NAN, NAN, NAN};
};

/// What a bag says that a tracker found.
struct ResultRecord {
  std::string body_id;
  std::string world_frame;
  std::shared_ptr<const BodyModel> body;
  bool has_description = false;     ///< `body` is the tracker's own; else only its names are of use
  bool has_status = false;          ///< there is a /pose
  std::vector<ResultFrame> frames;  ///< in the order of time
  JointTrack joints;                ///< bodyPointNames() of the frames with a pose
  std::vector<AngleFrame> angles;   ///< of the frames with a pose
  std::vector<double> latencies;    ///< from stamp to record, s, of each pose
};

/// Reads /tf and /tf_static, /pose (a lost frame has no estimate, whatever tf says), joint states
/// and the body's URDF. Throws std::runtime_error with one sentence: the bag cannot be read, has
/// no body or several ones and `id` does not choose.
/// \param id empty: the only body there is
ResultRecord readResults(const std::string& path, const std::string& id);

}  // namespace markerless_mocap
