#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>

#include <Eigen/Geometry>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "nodes/common/catch_up_queue.h"
#include "nodes/common/stage_status.h"
#include "options/settings.h"

namespace markerless_mocap {

/// The volume as interactive markers on hull/volume: two corners to drag, and a menu. A corner that
/// is let go changes the settings in a thread of its own, as that may take a second.
class VolumeHandles {
 public:
  /// What the handles do. Exceptions are told as remarks, and the handles go back.
  struct Actions {
    std::function<void(const SettingChanges&)> change;
    std::function<std::string()> save;
  };

  /// \param topic full name \param frame of the volume \param status must outlive this object
  VolumeHandles(const std::string& topic, const std::string& frame, Actions actions,
                StageStatus* status);
  ~VolumeHandles();
  VolumeHandles(const VolumeHandles&) = delete;
  VolumeHandles& operator=(const VolumeHandles&) = delete;

  /// Shows the volume that is used. Thread-safe. \param box m in the frame
  void show(const Eigen::AlignedBox3d& box);

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;
  void receive(const Feedback& feedback);
  void work();
  /// Runs an action; if it fails, the reason is told and the handles go back.
  void attempt(const std::function<void()>& action);

  const std::string frame_;
  const Actions actions_;
  StageStatus* status_;
  std::mutex show_mutex_, mutex_;
  Eigen::AlignedBox3d box_;  ///< that is used; empty: none yet
  CatchUpQueue<std::function<void()>> queue_;
  interactive_markers::MenuHandler menu_;
  interactive_markers::InteractiveMarkerServer server_;
  std::thread worker_;
};

}  // namespace markerless_mocap
