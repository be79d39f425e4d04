#include "options/renamed_options.h"

#include <array>
#include <stdexcept>

namespace markerless_mocap {
namespace {

struct RenamedKey {
  const char* stage;
  const char* old_key;
  const char* new_key;  ///< below the stage
};

struct RenamedValue {
  const char* stage;
  const char* key;
  const char* old_value;
  const char* new_value;
};

constexpr RenamedKey kRenamedKeys[] = {
    {"silhouette", "shadow_darkest", "min_shadow_brightness"},
    {"silhouette", "stale_share", "stale_fraction"},
    {"body_segmentation", "highest_cost", "max_cost"},
    {"body_segmentation", "least_litres", "min_litres"},
    {"body_segmentation", "most_litres", "max_litres"},
    {"pose_tree", "least_rank", "min_rank"},
    {"pose_tree", "least_validity", "min_validity"},
    {"pose_fitting", "stature_deviation", "stature_sigma"},
    {"pose_fitting", "measuring_poses", "shape_poses"},
    {"pose_fitting", "filter", "filter/enabled"},
    {"pose_fitting", "filter_cutoff", "filter/cutoff"},
    {"pose_fitting", "filter_beta", "filter/beta"},
    {"pose_fitting", "seed", "hsiao/seed"},
    {"pose_fitting", "curve_samples", "hsiao/samples_per_curve"},
    {"pose_fitting", "particles_per_parameter", "hsiao/particles_per_parameter"},
    {"pose_fitting", "iterations_per_parameter", "hsiao/iterations_per_parameter"},
    {"pose_fitting", "tune_particles", "hsiao/fine_tune_particles"},
    {"pose_fitting", "tune_iterations", "hsiao/fine_tune_iterations"},
    {"pose_fitting", "spin_starts", "hsiao/initial_headings"},
    {"pose_fitting", "start_attempts", "hsiao/initialization_attempts"},
    {"pose_fitting", "refine_iterations", "hsiao/refinement_iterations"},
    {"pose_fitting", "surface_points", "hsiao/refinement_surface_points"},
    {"pose_fitting", "highest_speed", "hsiao/max_root_speed"},
    {"pose_fitting", "highest_turn_rate", "hsiao/max_joint_velocity"},
    {"pose_fitting", "reset_threshold", "hsiao/reset_threshold"},
    {"pose_fitting", "highest_error", "hsiao/max_skeleton_error"},
    {"pose_fitting", "highest_limb_error", "hsiao/max_limb_error"},
    {"pose_fitting", "explained_margin", "hsiao/hull_margin"},
    {"pose_fitting", "least_hull_explained", "hsiao/min_hull_explained"},
    {"pose_fitting", "least_body_in_hull", "hsiao/min_body_in_hull"},
    {"pose_fitting", "memory", "hsiao/max_pose_age"},
    {"pose_fitting", "contour_rays", "contour/rays"},
    {"pose_fitting", "contour_iterations", "contour/iterations"},
    {"pose_fitting", "contour_sigma", "contour/ray_sigma"},
    {"pose_fitting", "contour_contour_weight", "contour/effective_rays"},
    {"pose_fitting", "contour_containment_weight", "contour/containment_weight"},
    {"pose_fitting", "contour_outlier_first", "contour/robust_scale_initial"},
    {"pose_fitting", "contour_outlier_last", "contour/robust_scale_final"},
    {"pose_fitting", "contour_turn_rate", "contour/joint_velocity_sigma"},
    {"pose_fitting", "contour_move_rate", "contour/root_velocity_sigma"},
    {"pose_fitting", "sppso_search", "fleischmann/search"},
    {"pose_fitting", "sppso_evaluations_factor", "fleischmann/particle_factor"},
    {"pose_fitting", "sppso_last_particles", "fleischmann/final_stage_particles"},
    {"pose_fitting", "sppso_last_iterations", "fleischmann/final_stage_iterations"},
    {"pose_fitting", "sppso_edges", "fleischmann/use_edges"},
    {"pose_fitting", "sppso_torso_top", "fleischmann/use_torso_top_edge"},
    {"pose_fitting", "sppso_keep_start", "fleischmann/include_start_particle"},
    {"pose_fitting", "sppso_prediction", "fleischmann/prediction_fraction"},
    {"pose_fitting", "sppso_sigma_factor", "fleischmann/sigma_factor"},
    {"pose_fitting", "sppso_collision", "fleischmann/collision_fraction"},
    {"pose_fitting", "sppso_least_fitness", "fleischmann/min_silhouette_fitness"},
    {"pose_fitting", "sppso_seed", "fleischmann/seed"},
    {"pose_fitting", "sppso_reduction", "fleischmann/downsampling"},
    {"pose_fitting", "sppso_edge_threshold", "fleischmann/edge_threshold"},
    {"pose_fitting", "sppso_edge_reach", "fleischmann/edge_dilation"},
    {"pose_fitting", "sppso_edge_blur", "fleischmann/edge_blur_sigma"},
    {"pose_fitting", "sppso_edge_samples", "fleischmann/samples_per_edge"},
    {"pose_fitting", "sppso_least_silhouette", "fleischmann/min_silhouette_pixels"},
    {"virtual_studio", "noise_levels", "noise_stddev"},
    {"virtual_studio", "second_person", "second_person_distance"},
    {"virtual_studio", "chair", "chair_distance"},
    {"virtual_studio", "stage", "volume_half_width"},
    {"virtual_studio", "look_seed", "appearance_seed"},
};

// Each had two keys of pose_fitting, <joint>_lowest and <joint>_highest.
constexpr const char* kJointLimits[] = {
    "neck_x",          "neck_y",           "left_shoulder_x", "right_shoulder_x",
    "left_shoulder_y", "right_shoulder_y", "left_shoulder_z", "right_shoulder_z",
    "left_elbow",      "right_elbow",      "left_hip_x",      "right_hip_x",
    "left_hip_y",      "right_hip_y",      "left_knee",       "right_knee"};

constexpr RenamedValue kRenamedValues[] = {
    {"pose_fitting", "method", "skeleton", "hsiao"},
    {"pose_fitting", "method", "sppso", "fleischmann"},
};

[[noreturn]] void throwRenamed(const OptionPath& path, const std::string& now) {
  throw std::invalid_argument(path.where + "/" + path.key + " is now " + now);
}

void throwIfJointLimit(const OptionPath& path) {
  if (path.stage != "pose_fitting") return;
  for (const std::string joint : kJointLimits) {
    const std::string now = path.where + "/hsiao/joint_limits/" + joint + ", a pair [min, max]";
    if (path.key == joint + "_lowest") throwRenamed(path, "the first number of " + now);
    if (path.key == joint + "_highest") throwRenamed(path, "the second number of " + now);
  }
}

}  // namespace

void throwIfKeyWasRenamed(const OptionPath& path) {
  for (const RenamedKey& renamed : kRenamedKeys)
    if (path.stage == renamed.stage && path.key == renamed.old_key)
      throwRenamed(path, path.where + "/" + renamed.new_key);
  throwIfJointLimit(path);
}

void throwIfValueWasRenamed(const OptionPath& path, const std::string& value) {
  for (const RenamedValue& renamed : kRenamedValues)
    if (path.stage == renamed.stage && path.key == renamed.key && value == renamed.old_value)
      throw std::invalid_argument(path.where + "/" + path.key + " is \"" + value +
                                  "\", which is now \"" + renamed.new_value + "\"");
}

}  // namespace markerless_mocap
