#include "markerless_mocap/hsiao/hsiao_options.h"

#include <cmath>

namespace markerless_mocap {
namespace {

// Joint and axis of theta_1 to theta_16 (Hsiao 2008, Table 3-2).
constexpr const char* kAngleKeys[kHsiaoAngles] = {
    "neck_x",          "neck_y",           "left_shoulder_x", "right_shoulder_x",
    "left_shoulder_y", "right_shoulder_y", "left_shoulder_z", "right_shoulder_z",
    "left_elbow",      "right_elbow",      "left_hip_x",      "right_hip_x",
    "left_hip_y",      "right_hip_y",      "left_knee",       "right_knee"};

void visitMethod(HsiaoOptions& o, OptionVisitor& v) {
  v.field("search", o.search, {"guided", "published"},
          "how the swarms are staged; guided: arms and legs are first fitted alone, the facing "
          "directions are given by the limbs, and the last pose is followed in one stage; "
          "published: the stages of Hsiao 2008, Table 3-3 only, with the spin searched from stage "
          "2 on, also around the last pose");
  v.field("part_error", o.part_error, {"aligned", "published"},
          "how part curves are compared with the model; aligned: from the outer end of each limb, "
          "with parts of the same kind; published: the whole curve with the whole part, any part "
          "with any (Hsiao 2008, Eq. 3-27)");
  v.field("use_hull", o.use_hull,
          "refine and judge poses by the hull, too; false: by the part curves alone, as in Hsiao "
          "2008");
}

void visitSwarm(HsiaoOptions& o, OptionVisitor& v) {
  v.field("samples_per_curve", o.samples_per_curve, 4, 200,
          "number of points compared along each part curve");
  v.field("particles_per_parameter", o.particles_per_parameter, 0.5, 50.0,
          "particles of a swarm stage per parameter that it searches");
  v.field("iterations_per_parameter", o.iterations_per_parameter, 0.5, 50.0,
          "iterations of a swarm stage per parameter that it searches");
  v.field("fine_tune_particles", o.fine_tune_particles, 2, 1000,
          "particles when one part is fine-tuned");
  v.field("fine_tune_iterations", o.fine_tune_iterations, 1, 1000,
          "iterations when one part is fine-tuned");
  v.field("inertia", o.inertia, 0.0, 1.0,
          "t1 of Hsiao 2008, 3.2.2.2: part of its velocity that a particle keeps");
  v.field("cognitive_weight", o.cognitive_weight, 0.0, 4.0,
          "t2: pull towards the particle's own best position");
  v.field("social_weight", o.social_weight, 0.0, 4.0,
          "t3: pull towards the best position of all particles");
  v.field(
      "initial_headings", o.initial_headings, 2, 16,
      "number of facing directions tried; 2: as left and right of the limbs say, and the reverse");
  v.field("initialization_attempts", o.initialization_attempts, 1, 50,
          "number of searches with different seeds at a start; the method contour uses one");
  v.field("refinement_iterations", o.refinement_iterations, 0, 100,
          "steps of the final refinement by curves and hull");
  v.field("refinement_surface_points", o.refinement_surface_points, 50, 100000,
          "number of surface voxels of the hull that the refinement uses");
}

void visitJudgement(HsiaoOptions& o, OptionVisitor& v) {
  v.field("max_root_speed", o.max_root_speed, 0.1, 20.0,
          "largest speed of the trunk in the temporal search, m/s");
  v.field("max_joint_velocity", o.max_joint_velocity, 0.5, 60.0,
          "largest rate of change of a joint angle in the temporal search, rad/s");
  v.field("reset_threshold", o.reset_threshold, 0.0, 1.0,
          "the temporal pose is dropped when its error exceeds the basic search's by this, m");
  v.field("max_skeleton_error", o.max_skeleton_error, 0.01, 1.0,
          "a pose with a larger skeleton error is reported as lost, m");
  v.field("max_limb_error", o.max_limb_error, 0.01, 1.0,
          "a limb with a larger error counts as not seen, m");
  v.field("hull_margin", o.hull_margin, 0.0, 0.5,
          "distance from the body up to which a hull voxel counts as explained, m");
  v.field("min_hull_explained", o.min_hull_explained, 0.0, 1.0,
          "fraction of the hull that the body must explain");
  v.field("min_body_in_hull", o.min_body_in_hull, 0.0, 1.0,
          "fraction of the body's volume that must be in the hull");
  v.field("max_pose_age", o.max_pose_age, 0.0, 10.0,
          "time for which the last pose guides the search, s");
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

void HsiaoLimits::visit(OptionVisitor& v) {
  for (int k = 0; k < kHsiaoAngles; ++k)
    v.range(kAngleKeys[k], lower[k], upper[k], -2 * M_PI, 2 * M_PI,
            "smallest and largest angle, rad; equal: the joint does not move");
}

void HsiaoOptions::visit(OptionVisitor& v) {
  v.field("seed", seed, 0, 1000000000, "seed of the random numbers");
  visitMethod(*this, v);
  visitSwarm(*this, v);
  visitJudgement(*this, v);
  v.section("joint_limits", joint_limits,
            "range of each joint angle (defaults: Hsiao 2008, Table 3-4), [min, max], rad");
}

void HsiaoOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
