#pragma once

#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "pages/page.h"
#include "pages/player_hulls.h"
#include "tools/common/player_views.h"
#include "tools/common/result_record.h"

namespace markerless_mocap {

/// What the player of a page shows. Pointers may be null: nothing of that kind.
struct PlayerContent {
  const BodyModel* body = nullptr;  ///< never null
  bool shape_known = true;          ///< false: of the body only its links are valid
  const std::vector<ResultFrame>* frames = nullptr;  ///< never null; ascending stamps
  const CameraRig* rig = nullptr;
  const PlayerHulls* hulls = nullptr;
  const PlayerViews* views = nullptr;
  const JointTrack* truth = nullptr;  ///< of the same frames, with markerNames() and tipNames()
  /// Frames to go to, beside those that are lost: {"frame", "frames", "what", "why"}.
  std::vector<Json> events;
};

/// The states of a frame as bands show them, by FrameStatus.
const std::vector<BandState>& frameStates();

/// The player: body, hull, skeleton and cameras in space, the views, and a line of time on which it
/// can be played and all plots over time have their cursor.
Json playerPart(const PlayerContent& content);

/// Nothing if no frame has a pose: joint angles, speeds, feet on the floor, expected errors and a
/// table of steps and ranges of motion.
void addMotionPlots(const BodyModel& body, const std::vector<ResultFrame>& frames, Page* page);

/// Seconds since the first frame.
std::vector<double> secondsOf(const std::vector<ResultFrame>& frames);

}  // namespace markerless_mocap
