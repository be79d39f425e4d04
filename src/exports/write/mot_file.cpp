#include <limits>

#include "body/davenport_angles.h"
#include "exports/export_formats.h"
#include "exports/write/axes.h"
#include "exports/write/number_text.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kDegrees = 180.0 / M_PI;

/// A joint of the model of Rajagopal et al. 2016 ("Full-body musculoskeletal model for
/// muscle-driven simulation of human gait"): rotations about z, x and y of the parent, in this
/// order; a name may be empty. The model counts adduction and rotation of a left limb towards the
/// middle: its axes are -x and -y. Knees bend about -z.
struct ModelJoint {
  const char *parent, *child;  ///< links; an empty parent is the ground
  const char* coordinates[3];
  double signs[3];
};
constexpr ModelJoint kJoints[] = {
    {"", "body", {"pelvis_tilt", "pelvis_list", "pelvis_rotation"}, {1, 1, 1}},
    {"body", "torso", {"lumbar_extension", "lumbar_bending", "lumbar_rotation"}, {1, 1, 1}},
    {"body", "r_hip", {"hip_flexion_r", "hip_adduction_r", "hip_rotation_r"}, {1, 1, 1}},
    {"r_hip", "r_knee", {"knee_angle_r", "", ""}, {-1, 1, 1}},
    {"r_knee", "r_ankle", {"ankle_angle_r", "", ""}, {1, 1, 1}},
    {"body", "l_hip", {"hip_flexion_l", "hip_adduction_l", "hip_rotation_l"}, {1, -1, -1}},
    {"l_hip", "l_knee", {"knee_angle_l", "", ""}, {-1, 1, 1}},
    {"l_knee", "l_ankle", {"ankle_angle_l", "", ""}, {1, 1, 1}},
    {"torso", "r_shoulder", {"arm_flex_r", "arm_add_r", "arm_rot_r"}, {1, 1, 1}},
    {"r_shoulder", "r_elbow", {"elbow_flex_r", "", ""}, {1, 1, 1}},
    {"torso", "l_shoulder", {"arm_flex_l", "arm_add_l", "arm_rot_l"}, {1, -1, -1}},
    {"l_shoulder", "l_elbow", {"elbow_flex_l", "", ""}, {1, 1, 1}},
};

Eigen::Matrix3d rotationOf(const ModelJoint& joint, const BodyModel& body,
                           const PersonFrame& frame) {
  Eigen::Matrix3d R = frame.T_world_link[size_t(body.linkIndex(joint.child))].linear();
  if (*joint.parent)
    R = frame.T_world_link[size_t(body.linkIndex(joint.parent))].linear().transpose() * R;
  return opensimFromWorld() * R * opensimFromWorld().transpose();
}

/// Of the two solutions the one nearest to that of the last frame, radians.
Vector3d anglesOf(const Eigen::Matrix3d& R, const Vector3d& last) {
  constexpr double kFree = std::numeric_limits<double>::max();
  return davenportAngles(R, {Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY()}, last, -kFree,
                         kFree);
}

std::string headerText(const PersonMotion& motion, const std::string& name) {
  std::string labels = "time\tpelvis_tx\tpelvis_ty\tpelvis_tz";
  int columns = 4;
  for (const ModelJoint& joint : kJoints)
    for (const char* coordinate : joint.coordinates) {
      if (!*coordinate) continue;
      labels += std::string("\t") + coordinate;
      ++columns;
    }
  std::string out = name + "\nversion=1\nnRows=" + std::to_string(motion.frames.size()) +
                    "\nnColumns=" + std::to_string(columns) + "\ninDegrees=yes\n\n";
  if (motion.fill_s > 0)
    out += "Gaps of up to " + numberText(1e3 * motion.fill_s, 0) +
           " ms were filled by cubic splines.\n";
  return out + "Units are degrees and metres. What was not seen is nan.\nendheader\n" + labels +
         '\n';
}

std::string numberOrNan(double value) {
  return std::isfinite(value) ? numberText(value, 6) : "nan";
}

}  // namespace

std::string motOf(const PersonMotion& motion, const std::string& name) {
  std::string out = headerText(motion, name);
  std::vector<Vector3d> last(std::size(kJoints), Vector3d::Zero());
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    const PersonFrame& frame = motion.frames[f];
    const Vector3d pelvis = opensimFromWorld() * frame.T_world_link[0].translation();
    out += numberText(motion.seconds(f), 6);
    for (const double value : pelvis) out += '\t' + numberOrNan(value);
    for (size_t j = 0; j < std::size(kJoints); ++j) {
      const Eigen::Matrix3d R = rotationOf(kJoints[j], *motion.body, frame);
      if (R.allFinite()) last[j] = anglesOf(R, last[j]);
      for (int axis = 0; axis < 3; ++axis)
        if (*kJoints[j].coordinates[axis])
          out +=
              '\t' + numberOrNan(R.allFinite() ? kDegrees * kJoints[j].signs[axis] * last[j][axis]
                                               : double(NAN));
    }
    out += '\n';
  }
  return out;
}

}  // namespace markerless_mocap
