#include "markerless_mocap/hsiao/hsiao_options.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace markerless_mocap {
namespace {

// Joint and axis of theta_1 to theta_16 (Hsiao 2008, Table 3-2).
constexpr const char* kAngleKeys[kHsiaoAngles][2] = {
    {"neck_x_lowest", "neck_x_highest"},
    {"neck_y_lowest", "neck_y_highest"},
    {"left_shoulder_x_lowest", "left_shoulder_x_highest"},
    {"right_shoulder_x_lowest", "right_shoulder_x_highest"},
    {"left_shoulder_y_lowest", "left_shoulder_y_highest"},
    {"right_shoulder_y_lowest", "right_shoulder_y_highest"},
    {"left_shoulder_z_lowest", "left_shoulder_z_highest"},
    {"right_shoulder_z_lowest", "right_shoulder_z_highest"},
    {"left_elbow_lowest", "left_elbow_highest"},
    {"right_elbow_lowest", "right_elbow_highest"},
    {"left_hip_x_lowest", "left_hip_x_highest"},
    {"right_hip_x_lowest", "right_hip_x_highest"},
    {"left_hip_y_lowest", "left_hip_y_highest"},
    {"right_hip_y_lowest", "right_hip_y_highest"},
    {"left_knee_lowest", "left_knee_highest"},
    {"right_knee_lowest", "right_knee_highest"}};

void visitSwarm(HsiaoOptions& o, OptionVisitor& v) {
  v.field("curve_samples", o.curve_samples, 4, 200, "points compared along each part curve");
  v.field("particles_per_parameter", o.particles_per_parameter, 0.5, 50.0,
          "particles of a swarm stage for each parameter that it searches");
  v.field("iterations_per_parameter", o.iterations_per_parameter, 0.5, 50.0,
          "iterations of a swarm stage for each parameter that it searches");
  v.field("fine_tune_particles", o.fine_tune_particles, 2, 1000,
          "particles when one part is tuned");
  v.field("fine_tune_iterations", o.fine_tune_iterations, 1, 1000,
          "iterations when one part is tuned");
  v.field("initial_headings", o.initial_headings, 2, 16,
          "facing directions tried; two are the limbs' left and right, and the reverse");
  v.field("initialization_attempts", o.initialization_attempts, 1, 50,
          "searches with other seeds at a start; contour takes one");
  v.field("refinement_iterations", o.refinement_iterations, 0, 100,
          "steps of the final refinement against curves and hull");
  v.field("refinement_surface_points", o.refinement_surface_points, 50, 100000,
          "surface voxels of the hull used by the refinement");
}

void visitJudgement(HsiaoOptions& o, OptionVisitor& v) {
  v.field("max_root_speed", o.max_root_speed, 0.1, 20.0,
          "speed of the trunk that the temporal search allows for, m/s");
  v.field("max_joint_velocity", o.max_joint_velocity, 0.5, 60.0,
          "rate of change of a joint angle that the temporal search allows for, rad/s");
  v.field("reset_threshold", o.reset_threshold, 0.0, 1.0,
          "the temporal pose is dropped when its error exceeds the basic one's by this, m");
  v.field("max_skeleton_error", o.max_skeleton_error, 0.01, 1.0,
          "skeleton error above which a pose is not claimed, m");
  v.field("max_limb_error", o.max_limb_error, 0.01, 1.0,
          "error of one limb above which that limb counts as not seen, m");
  v.field("hull_margin", o.hull_margin, 0.0, 0.5,
          "distance from the body within which a hull voxel counts as explained, m");
  v.field("min_hull_explained", o.min_hull_explained, 0.0, 1.0,
          "share of the hull that the body must explain");
  v.field("min_body_in_hull", o.min_body_in_hull, 0.0, 1.0,
          "share of the body's volume that must lie in the hull");
  v.field("memory", o.max_pose_age, 0.0, 10.0, "time for which the last pose guides the search, s");
}

}  // namespace

HsiaoLimits HsiaoLimits::fromThesis() {
  const double pi = M_PI;
  HsiaoLimits limits;
  limits.lower = {-pi / 2, -pi / 2, -pi,     -pi,     -pi, -pi / 2, -pi / 2, -3 * pi / 4,
                  -pi,     0,       -pi / 3, -pi / 2, -pi, -pi,     0,       0};
  limits.upper = {pi / 2, pi / 2, pi,     pi,     pi / 2, pi,     3 * pi / 4, pi / 2,
                  0,      pi,     pi / 2, pi / 3, pi / 2, pi / 2, pi,         pi};
  return limits;
}

void HsiaoOptions::visit(OptionVisitor& v) {
  v.field("seed", seed, 0, 1000000000, "start of the random numbers");
  visitSwarm(*this, v);
  visitJudgement(*this, v);
  for (int k = 0; k < kHsiaoAngles; ++k) {
    v.field(kAngleKeys[k][0], limits.lower[k], -2 * M_PI, 2 * M_PI,
            "lowest angle of this joint, rad; equal to the highest, it does not move");
    v.field(kAngleKeys[k][1], limits.upper[k], -2 * M_PI, 2 * M_PI,
            "highest angle of this joint, rad");
  }
}

void HsiaoOptions::validate() const {
  checkFields(*this);
  for (int k = 0; k < kHsiaoAngles; ++k)
    if (limits.lower[k] > limits.upper[k])
      throw std::invalid_argument(std::string(kStage) + "/" + kAngleKeys[k][0] + " is " +
                                  std::to_string(limits.lower[k]) + ", allowed is up to " +
                                  kAngleKeys[k][1] + ", which is " +
                                  std::to_string(limits.upper[k]));
}

}  // namespace markerless_mocap
