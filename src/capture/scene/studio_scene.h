#pragma once

#include <memory>
#include <string>
#include <vector>

#include "capture/scene/lit_scene.h"
#include "capture/scene/studio_motion.h"
#include "capture/virtual_studio.h"
#include "character/character.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// A person with a motion of its own, put somewhere in the room.
struct Actor {
  Character character;
  LoopedMotion motion;
  double phase = 0.0;  ///< seconds by which the motion is ahead
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();  ///< turns and shifts the motion

  HumanPose at(double seconds) const;
  SceneObject seenAt(double seconds) const;
};

/// Who acts before the cameras and what stands around, with the truth about the first person.
class StudioScene {
 public:
  /// \param wall colour that camouflage goes to \param body_id of the driven URDF body
  StudioScene(const StudioOptions& options, const StudioFiles& files, const Eigen::Vector3f& wall,
              const std::string& body_id);

  const BodyModel& body() const { return *body_; }
  const std::string& urdf() const { return urdf_; }
  double stature() const { return actors_.front().character.skeleton.stature; }
  /// Length of the motion once through, s.
  double duration() const { return actors_.front().motion.duration(); }
  /// Instants from one beginning of the motion to the next.
  int framesPerRound() const { return int(states_.size()); }
  const BodyState& bodyAt(int frame) const { return states_[size_t(frame)]; }
  std::vector<Eigen::Vector3d> pointsAt(double seconds) const;

  bool hasFurniture() const { return furniture_.mesh != nullptr; }
  /// \param people whether anybody is in the room
  std::vector<SceneObject> objectsAt(double seconds, bool people) const;

 private:
  void drive(double fps);
  void placeChair(double distance);

  std::vector<Actor> actors_;
  std::string urdf_;
  std::shared_ptr<const BodyModel> body_;
  std::vector<BodyState> states_;  ///< by frame of the first person's round
  std::unique_ptr<const ColoredMesh> chair_;
  SceneObject furniture_;
};

}  // namespace markerless_mocap
