#pragma once

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "checks/check_rig.h"
#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// Arguments of check_recording.
struct CheckArguments {
  std::string bag;                   ///< empty: live topics
  std::vector<std::string> cameras;  ///< empty: all
  std::string rig;                   ///< rig file in place of camera_info and tf; empty: none
  std::string world_frame = "world";
  /// s, from the first image on, in which silhouettes are looked for; of the rest, only messages,
  /// stamps and 24 pictures are looked at.
  double seconds = 60.0;
  double live = 0.0;    ///< s to listen to the topics of a running system; 0: a bag
  bool repeat = false;  ///< live, until the program is ended, and into /diagnostics
};

/// What is wrong with a recording or with live topics, and what could not be judged.
struct CheckResult {
  std::string source;  ///< the bag, or "live"
  std::vector<std::string> cameras;
  double seconds = 0;  ///< length
  Findings findings;
  std::vector<std::string> not_checked;
};

/// Reads a bag. Throws std::runtime_error or std::invalid_argument if there is no bag, or no camera
/// in it, or an argument is wrong.
SeenRig readSeenRig(const CheckArguments& arguments, const PipelineOptions& pipeline,
                    std::ostream* notes, bool terminal);

/// Listens to live topics for CheckArguments::live seconds. With `repeat`, again and again, each
/// time publishing on /diagnostics, until ROS shuts down. Throws std::runtime_error if there is no
/// camera, or if ROS shuts down before the first check. ros::init() must have been called.
CheckResult checkLive(const CheckArguments& arguments, const PipelineOptions& pipeline);

CheckResult resultOf(const SeenRig& rig, const std::string& source);

/// Whether anything is wrong: an error or a warning, no mere note.
bool isAnythingWrong(const CheckResult& result);

/// A list for people.
void print(const CheckResult& result, std::ostream& out);
/// The same as JSON.
std::string jsonOf(const CheckResult& result);

}  // namespace markerless_mocap
