#pragma once

#include <memory>
#include <string>
#include <vector>

#include "capture/scene/lit_scene.h"
#include "capture/scene/room_events.h"
#include "capture/scene/studio_motion.h"
#include "capture/virtual_studio.h"
#include "character/character.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// A person with a motion and a position in the room.
struct Actor {
  Character character;
  LoopedMotion motion;
  double phase = 0.0;  ///< offset of the motion in time, seconds
  /// Rotation and translation of the motion.
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();

  HumanPose at(double seconds) const;
  SceneObject seenAt(double seconds) const;
};

/// A time of the film.
struct FilmTime {
  double motion = 0.0;  ///< seconds of the motion, which repeats
  double since = 0.0;   ///< seconds since the person came; below 0 the room is empty
  bool people = false;  ///< whether the actors are in the room

  FilmTime later(double seconds) const { return {motion + seconds, since + seconds, people}; }
};

/// The people and the furniture in front of the cameras, with the ground truth of the first person.
class StudioScene {
 public:
  /// \param room gives the colour of camouflage and the places of things on the walls
  /// \param body_id id of the retargeted URDF body
  StudioScene(const StudioOptions& options, const StudioFiles& files, const TexturedRoom& room,
              const std::string& body_id);

  const BodyModel& body() const { return *body_; }
  const std::string& urdf() const { return urdf_; }
  double stature() const { return actors_.front().character.skeleton.stature; }
  /// Duration of the motion, s.
  double duration() const { return actors_.front().motion.duration(); }
  /// Frame sets in one period of the motion.
  int framesPerRound() const { return int(states_.size()); }
  const BodyState& bodyAt(int frame) const { return states_[size_t(frame)]; }
  std::vector<Eigen::Vector3d> pointsAt(double seconds) const;

  std::vector<SceneObject> objectsAt(const FilmTime& time) const;
  RoomLight lightAt(const FilmTime& time) const { return events_.lightAt(time.since); }

 private:
  void drive(double fps);

  RoomEvents events_;
  std::vector<Actor> actors_;
  std::unique_ptr<const Actor> bystander_;
  std::string urdf_;
  std::shared_ptr<const BodyModel> body_;
  std::vector<BodyState> states_;  ///< by frame of the first person's period
};

}  // namespace markerless_mocap
