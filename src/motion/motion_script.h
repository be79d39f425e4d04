#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"
#include "motion/script/script_tracks.h"

namespace markerless_mocap {

/// Relative position of both feet.
struct Stance {
  double width = 0.09;   ///< distance between the ankles, fraction of the stature
  double stagger = 0.0;  ///< left foot ahead of the right one, fraction of the stature
};

/// One section of the path over the floor.
struct Move {
  enum class Kind {
    kStand,
    kGo,     ///< along an arc, facing along it
    kShift,  ///< straight in any direction while turning
    kJump,   ///< with both feet
  };
  Kind kind = Kind::kStand;
  double seconds = 0.0;
  double forward =
      0.0;            ///< metres, relative to the start of the move; for kGo the length of the arc
  double left = 0.0;  ///< metres
  double turn = 0.0;  ///< radians, positive to the left
  int steps = 0;      ///< 0: the natural number
  enum class First { kNatural, kLeft, kRight };
  First first = First::kNatural;  ///< foot that steps first
  bool run = false;
  double tuck = 0.0;  ///< of a jump: how far the feet are drawn up, fraction of the stature
  Stance stance;      ///< at the end of the move
};

/// A gesture of a foot that leaves the floor and returns to its position.
struct FootGesture {
  bool left = false;
  /// Motion of the ankle forward, outward and up as fractions of the stature, and toes up in
  /// degrees; begins and ends with zeros.
  ScriptCurve keys;
};

/// An authored motion for a person of any size. Lengths of gestures are fractions of the stature;
/// the path over the floor is in metres.
struct MotionScript {
  std::string name;
  double seconds = 0.0;
  double start_x = 0.0, start_y = 0.0;  ///< metres
  double start_heading = 0.0;           ///< radians, 0: faces +x
  Stance start_stance;
  std::vector<Move> path;  ///< if it is shorter than `seconds`, the person stands at the end
  std::vector<FootGesture> gestures;
  std::array<ScriptCurve, kTrackCount> tracks;

  const ScriptCurve& track(Track track) const { return tracks[size_t(track)]; }
};

/// Reads a motion of config/motions. Throws std::invalid_argument with file, key and allowed values
/// if the file cannot be read or is not valid.
MotionScript readMotionScript(const std::string& file);
/// The same from text.
/// \param name name of the file, for error messages
MotionScript parseMotionScript(const std::string& text, const std::string& name);

/// Generates the motion of a person of a given size who performs a script: planted feet, arm swing,
/// balance, breathing. Deterministic.
/// \param fps poses per second, 10 to 1000
/// Throws std::invalid_argument if fps is out of range, or if a gesture lifts a foot during a step.
MotionClip performMotion(const MotionScript& script, const HumanSkeleton& skeleton,
                         double fps = 120.0);

}  // namespace markerless_mocap
