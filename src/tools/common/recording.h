#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/frame_set_assembler.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "tools/common/recorded_cameras.h"

namespace markerless_mocap {

/// What to read from a recording.
struct RecordingOptions {
  std::vector<std::string> cameras;  ///< empty: all
  /// Take the recorded silhouettes as masks. Without it they are used only for cameras that have
  /// no images.
  bool use_masks = false;
  std::string world_frame = "world";
  /// Rig file that calibrates the cameras in place of camera_info and tf; empty: none.
  std::string rig;
  double start = 0.0;                                         ///< seconds after the first image
  double duration = std::numeric_limits<double>::infinity();  ///< seconds
};

/// One image or silhouette message, not yet decoded; one of the two is set.
struct RecordedImage {
  sensor_msgs::Image::ConstPtr raw;
  sensor_msgs::CompressedImage::ConstPtr compressed;
};

/// A bag of several cameras, read instant by instant; no frame is left out.
class Recording {
 public:
  /// Reads cameras, calibrations and transforms. Throws std::runtime_error or
  /// std::invalid_argument with one sentence that says what the bag lacks.
  Recording(const std::string& path, const RecordingOptions& options);

  const CameraRig& rig() const { return rig_; }
  const std::vector<RecordedCamera>& cameras() const { return cameras_; }  ///< as in the rig
  /// Whether every camera has silhouettes in the bag, asked for or not.
  bool hasMasks() const;
  /// Static transforms as they stand in the bag, all in one message.
  const tf2_msgs::TFMessage& staticTransforms() const { return static_transforms_; }

  /// The next instant in the order of time, nothing after the last; the frames of cameras that are
  /// missing are empty. Throws std::runtime_error if there are no images where reading begins, or
  /// the bag turns out to be damaged.
  std::optional<FrameSet> next();
  /// Share of the recording that has been read, 0..1.
  double fractionRead() const;

  const AssemblerCounts& counts() const { return counts_; }
  /// Images that could not be decoded; their cameras were missing at these instants.
  int unreadable() const { return unreadable_; }
  const std::string& firstUnreadable() const { return first_unreadable_; }

 private:
  using Assembler = FrameSetAssembler<RecordedImage>;
  struct Stream {
    std::string topic;
    size_t camera;
    bool is_mask;
  };

  void readRig();
  void takeRig();
  void listStreams();
  void startReading();
  void readMessage();
  FrameSet frameSetOf(const Assembler::FrameSet& frame_set);

  RecordingOptions options_;
  rosbag::Bag bag_;
  std::vector<RecordedCamera> cameras_;
  std::vector<Stream> streams_;
  CameraRig rig_;
  tf2_msgs::TFMessage static_transforms_;
  std::map<std::string, size_t> stream_of_topic_;
  std::unique_ptr<rosbag::View> view_;  ///< none before the first instant is asked for
  rosbag::View::iterator message_;      ///< of the view, not yet read
  size_t messages_read_ = 0;
  std::unique_ptr<Assembler> assembler_;
  std::deque<Assembler::FrameSet> whole_;  ///< instants that wait to be asked for
  AssemblerCounts counts_;
  int unreadable_ = 0;
  std::string first_unreadable_;
};

}  // namespace markerless_mocap
