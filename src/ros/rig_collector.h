#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <tf2/buffer_core.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "ros/lacking_cameras.h"

namespace markerless_mocap {

/// What RigCollector::settle() did with the rig.
enum class RigChange {
  kNone,
  kWhileUsed,   ///< the rig of before may be used until all is made for the new one
  kAfterPause,  ///< the rig of before is wrong
};

/// Collects camera_info until the rig is known, and watches whether it changes. A rig file replaces
/// camera_info and tf.
class RigCollector {
 public:
  /// \param cameras names, in the order of the rig
  /// \param world_frame frame of the rig
  /// \param rig_file instead of camera_info and tf; empty: none. Throws as readRig() and
  ///   camerasNamed().
  /// \param required if so many cameras are known, settle() does not wait for the others for long
  RigCollector(std::vector<std::string> cameras, std::string world_frame,
               const std::string& rig_file = "", size_t required = SIZE_MAX);

  const std::vector<std::string>& cameras() const { return cameras_; }
  /// True if the rig comes from a file: no camera_info is needed.
  bool isFromFile() const { return file_.has_value(); }
  /// Message about cameras of the file that are not in `cameras`; empty if there are none.
  const std::string& unusedCameras() const { return unused_cameras_; }
  /// Time offset of each camera in the rig file, s; empty without a file or without offsets.
  std::vector<double> timeOffsets() const;
  /// Stores the message; returns true if it is the camera's first and the rig was waiting for it.
  /// Everything else is taken over by settle().
  bool add(size_t camera, const sensor_msgs::CameraInfo& info);
  bool has(size_t camera) const { return infos_.at(camera).has_value(); }

  /// Message about what is missing: cameras without camera_info, or a frame that tf has never
  /// connected to the world. Empty if nothing is missing.
  std::string missing(const tf2::BufferCore& tf) const;

  /// Whether tf places a camera by way of this frame.
  bool dependsOn(const std::string& frame, const tf2::BufferCore& tf) const;

  /// Cameras that are left out, as too little is known of them, are blindCamera(). Throws
  /// std::invalid_argument with the message of missing(), or as calibrationFromMessage().
  CameraRig rig(const tf2::BufferCore& tf) const;

  /// Size of the images that the camera sends, px: camera_info of another size is not taken over
  /// in place of one that fits.
  void noteImageSize(size_t camera, int width, int height);
  /// Takes over camera_info and poses that differ from those of the rig and have stayed the same
  /// for half a second. A camera_info that no camera has, that changes all the time, or whose frame
  /// tf does not connect to the world, is not.
  /// Where enough cameras are known, those that are not are left out after a while, until they are.
  /// After half a second without a call the present ones are taken over at once, as at the start:
  /// nobody has watched whether they stayed. To be called whenever the rig is used.
  /// \param now s, by a clock that is never set
  /// \param remarks a sentence is appended for each change and each refusal
  RigChange settle(const tf2::BufferCore& tf, double now, std::vector<std::string>* remarks);
  /// Why what the camera sends must not be used, after settle(): its pose or its lens has changed
  /// noticeably, and has not been taken over yet, or too little is known of it. Empty: it may be
  /// used.
  const std::string& doubtOf(size_t camera) const { return doubts_.at(camera); }

 private:
  struct Candidate {
    sensor_msgs::CameraInfo info;
    std::optional<double> since;  ///< s; none: settle() has not seen it yet
    std::string refusal;          ///< why it is no camera's; empty: it may be
    bool misleads = false;        ///< the lens that is used is not that of the images
  };
  /// Changes of camera_info in a row that did not stay.
  struct Wandering {
    int changes = 0;
    bool told = false;
    double last = 0.0;  ///< s
  };
  struct Placed {
    geometry_msgs::Transform used, seen;
    double seen_since = 0.0, used_until = 0.0;  ///< s
  };
  bool settleInfo(size_t camera, const tf2::BufferCore& tf, double now,
                  std::vector<std::string>* remarks);
  /// Tells of a camera_info that changes all the time.
  void watchWandering(size_t camera, double now, std::vector<std::string>* remarks);
  /// Takes over a candidate that has stayed; returns false if it cannot be.
  bool takeInfo(size_t camera, const tf2::BufferCore& tf, std::vector<std::string>* remarks);
  bool settlePose(size_t camera, const tf2::BufferCore& tf, double now,
                  std::vector<std::string>* remarks);
  /// Sees a candidate for the first time.
  void judge(size_t camera, double now, Candidate* candidate);
  /// Whether images from the pose that was seen last mislead if they are used.
  bool misleads(size_t camera, const Placed& placed) const;
  /// Why the camera_info cannot be taken over; empty if it can.
  std::string refusalOf(size_t camera, const sensor_msgs::CameraInfo& info) const;
  /// Why a camera cannot change to this frame; empty if it can.
  std::string frameRefusal(size_t camera, const std::string& frame,
                           const tf2::BufferCore& tf) const;
  /// Where tf places a camera. Returns why it does not, or why no camera can be there; empty if
  /// one can.
  std::string findPose(size_t camera, const tf2::BufferCore& tf,
                       geometry_msgs::Transform* pose) const;
  /// What is not known of a camera that the rig needs; empty: nothing.
  std::string lackOf(size_t camera, const tf2::BufferCore& tf) const;
  /// Why the place of the frame that a camera_info names is not known; empty if it is.
  std::string unplaced(size_t camera, const std::string& frame, const tf2::BufferCore& tf) const;

  std::vector<std::string> cameras_;
  std::string world_frame_;
  LackingCameras lacking_;
  std::vector<std::optional<sensor_msgs::CameraInfo>> infos_;
  std::vector<std::optional<Candidate>> candidates_;  ///< by camera
  std::vector<Wandering> wanderings_;                 ///< by camera
  std::vector<std::optional<Placed>> placed_;         ///< by camera
  std::vector<std::string> doubts_;                   ///< by camera
  std::vector<std::pair<int, int>> image_sizes_;      ///< by camera; 0: not known
  std::optional<double> last_look_;                   ///< s, of settle()
  double rest_ = 0.0;                                 ///< s that a change must have stayed
  std::optional<CameraRig> file_;                     ///< the rig of the file, if there is one
  std::string unused_cameras_;
};

}  // namespace markerless_mocap
