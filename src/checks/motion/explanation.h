#pragma once

#include <string>
#include <vector>

#include "checks/motion/rig_model.h"

namespace markerless_mocap {

enum class ExplanationKind {
  kRotationInverted,     ///< the rotation is that of the inverse pose
  kTranslationInverted,  ///< the translation is that of the inverse pose
  kPoseInverted,
  kBodyAxes,  ///< x forward, y left, z up in place of the optical axes
  kUpsideDown,
  kMirrored,
  kExchanged,
  kTimeOffset,
  kDrift,
  kTurned,
  kFocalLength,
  kDistortion,
};

/// A change of the rig's model with which the silhouettes agree.
struct Explanation {
  ExplanationKind kind = ExplanationKind::kTurned;
  std::vector<size_t> cameras;   ///< that are changed; all of them: the whole rig
  RigModel model;                ///< changed
  double gain = 0;               ///< loss that it takes away, summed over rays
  double amount = 0;             ///< s, s/s, rad, factor, or change of k1; as the kind has it
  std::vector<double> amounts;   ///< of each camera, where all are changed differently
  double deviation = 0;          ///< of the amount, between parts of the recording; 0: not known
  std::vector<size_t> instead;   ///< cameras of another change of this kind that is nearly as good
  double before = 0, after = 0;  ///< median residual of these cameras, px of their images
};

/// One camera at a round of the search: its rays, and points by all others.
struct CameraState {
  size_t camera = 0;
  Rays rays;
  std::vector<std::optional<Eigen::Vector3d>> points;
  CameraLoss loss;
};

/// All cameras of a model, each with points by all others.
std::vector<CameraState> statesOf(const RigSight& sight, const RigModel& model);

/// Clocks that are seconds apart, as of films that were started by hand: all at once, as points
/// need cameras that agree. \param model is changed; none if the motion of the person does not show
/// them with certainty
std::vector<Explanation> undoWideOffsets(const RigSight& sight, RigModel* model);

/// Candidates for one camera or the whole rig; appended to `out` if they explain anything.
void tryPoses(const RigSight& sight, const RigModel& model, const CameraState& state,
              std::vector<Explanation>* out);
void tryClock(const RigSight& sight, const RigModel& model, const CameraState& state,
              std::vector<Explanation>* out);
void tryTurn(const RigSight& sight, const RigModel& model, const CameraState& state,
             std::vector<Explanation>* out);
/// All cameras at once, by a small turn each.
void tryAllTurns(const RigSight& sight, const RigModel& model,
                 const std::vector<CameraState>& states, std::vector<Explanation>* out);
void tryLens(const RigSight& sight, const RigModel& model, const CameraState& state,
             std::vector<Explanation>* out);
void tryExchanges(const RigSight& sight, const RigModel& model,
                  const std::vector<CameraState>& states, std::vector<Explanation>* out);
void tryWholeRig(const RigSight& sight, const RigModel& model,
                 const std::vector<CameraState>& states, std::vector<Explanation>* out);

/// The pose with a mistake of this kind undone; kinds that are no mistake of the pose: as given.
Eigen::Isometry3d undone(ExplanationKind kind, const Eigen::Isometry3d& T_world_camera);

/// All explanations that silhouettes demand, the strongest first. \param final the rig with all of
/// them applied \param left what is left then
std::vector<Explanation> explain(const RigSight& sight, const RigModel& given, RigModel* final,
                                 std::vector<CameraState>* left);

}  // namespace markerless_mocap
