#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"
#include "motion/script/script_tracks.h"

namespace markerless_mocap {

/// How both feet stand.
struct Stance {
  double width = 0.09;   ///< between the ankles, share of the stature
  double stagger = 0.0;  ///< left foot before the right one, share of the stature
};

/// One leg of the way over the floor.
struct Move {
  enum class Kind {
    kStand,
    kGo,     ///< along an arc, facing where it leads
    kShift,  ///< straight in any direction while turning
    kJump,   ///< off with both feet, through the air
  };
  Kind kind = Kind::kStand;
  double seconds = 0.0;
  double forward = 0.0;  ///< metres, seen from where the move begins; of kGo the arc's length
  double left = 0.0;     ///< metres
  double turn = 0.0;     ///< radians, left is positive
  int steps = 0;         ///< 0 picks the natural number
  enum class First { kNatural, kLeft, kRight };
  First first = First::kNatural;  ///< foot that steps first
  bool run = false;
  double tuck = 0.0;  ///< jump: how far the feet are drawn up, share of the stature
  Stance stance;      ///< if it ends here
};

/// A foot that leaves the floor and comes back to where it stood.
struct FootGesture {
  bool left = false;
  /// Ankle forward, outward, up as shares of the stature and toes up in degrees; begins and ends
  /// with zeros.
  ScriptCurve keys;
};

/// An authored motion that fits a person of any size: lengths of the body's gestures are shares of
/// the stature, the way over the floor is in metres.
struct MotionScript {
  std::string name;
  double seconds = 0.0;
  double start_x = 0.0, start_y = 0.0;  ///< metres
  double start_heading = 0.0;           ///< radians, 0 faces +x
  Stance start_stance;
  std::vector<Move> path;  ///< if it is shorter than `seconds` the person stands in the end
  std::vector<FootGesture> gestures;
  std::array<ScriptCurve, kTrackCount> tracks;

  const ScriptCurve& track(Track track) const { return tracks[size_t(track)]; }
};

/// Reads a motion of config/motions. Throws std::invalid_argument with file, key and what is
/// allowed if the file cannot be read or understood.
MotionScript readMotionScript(const std::string& file);
/// The same from text. \param name stands for the file in sentences
MotionScript parseMotionScript(const std::string& text, const std::string& name);

/// A person of this size performs the script: plants the feet, swings the arms, keeps the balance,
/// breathes. Same arguments give the same clip. \param fps poses per second, 10 to 1000. Throws
/// std::invalid_argument if fps is outside or if a gesture lifts a foot that is just stepping.
MotionClip performMotion(const MotionScript& script, const HumanSkeleton& skeleton,
                         double fps = 120.0);

}  // namespace markerless_mocap
