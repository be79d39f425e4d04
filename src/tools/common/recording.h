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

/// Settings for reading a recording.
struct RecordingOptions {
  std::vector<std::string> cameras;  ///< empty: all
  /// Use recorded silhouettes as masks. If false, they are used only for cameras without images.
  bool use_masks = false;
  std::string world_frame = "world";
  /// Rig file that replaces camera_info and tf; empty: none.
  std::string rig;
  /// Stamps closer than this belong to one frame set, s; more apart if the cameras are not in step.
  double stamp_tolerance = 0.005;
  double start = 0.0;                                         ///< seconds after the first image
  double duration = std::numeric_limits<double>::infinity();  ///< seconds
};

/// A message with an image or a silhouette, not yet decoded; exactly one of the two is set.
struct RecordedImage {
  sensor_msgs::Image::ConstPtr raw;
  sensor_msgs::CompressedImage::ConstPtr compressed;
};

/// A bag of several cameras, read frame set by frame set. No frame is dropped.
class Recording {
 public:
  /// Reads cameras, calibrations and transforms. Throws std::runtime_error or
  /// std::invalid_argument; the message says what the bag lacks.
  Recording(const std::string& path, const RecordingOptions& options);

  const CameraRig& rig() const { return rig_; }
  const std::vector<RecordedCamera>& cameras() const {
    return cameras_;
  }  ///< in the order of the
     ///< rig
  /// True if all cameras have silhouettes in the bag, whether they are used or not.
  bool hasMasks() const;
  /// All static transforms of the bag, in one message.
  const tf2_msgs::TFMessage& staticTransforms() const { return static_transforms_; }

  /// The next frame set in the order of time; empty after the last one. Missing frames are empty.
  /// Throws std::runtime_error if there are no images after the start, or if the bag is damaged.
  std::optional<FrameSet> next();
  /// Passes over about so many frame sets without reading them: one more or less where images are
  /// missing. The next frame set may then lack images.
  void skip(int frame_sets);
  /// For each camera, the number of its images before the start.
  std::vector<size_t> imagesBefore();
  /// About as many frame sets as the recording has; 0 if it has none.
  int expectedFrameSets();
  /// Fraction of the recording that has been read, 0 to 1.
  double fractionRead() const;

  const AssemblerCounts& counts() const { return counts_; }
  /// Sentences about cameras that lag or were left out of frame sets.
  std::vector<std::string> timingRemarks() const;
  /// Number of images that could not be decoded; they are missing in their frame sets.
  int unreadable() const { return unreadable_; }
  const std::string& firstUnreadable() const { return first_unreadable_; }

 private:
  using Assembler = FrameSetAssembler<RecordedImage>;
  struct Stream {
    std::string topic;
    size_t camera;
    bool is_mask;
    bool has_fitted = false;  ///< whether its last usable image had the camera's size
  };

  void readRig();
  void useRigFile();
  void listStreams();
  void startReading();
  void startJoining();
  /// Tells the assembler the next stamps, so that cameras out of step are joined from the start.
  void lookAhead();
  AssemblerOptions assembly() const;
  std::vector<double> offsets() const;  ///< of the streams' clocks, s
  void readMessage();
  /// Throws std::invalid_argument if an image differs in size from its camera and those before.
  void checkSize(size_t stream, const cv::Mat& pixels);
  /// The image of the current message; empty if it cannot be read, which is counted.
  std::optional<RecordedImage> readImage();
  FrameSet frameSetOf(const Assembler::FrameSet& frame_set);

  RecordingOptions options_;
  rosbag::Bag bag_;
  std::vector<RecordedCamera> cameras_;
  std::vector<Stream> streams_;
  CameraRig rig_;
  tf2_msgs::TFMessage static_transforms_;
  std::map<std::string, size_t> stream_of_topic_;
  std::unique_ptr<rosbag::View> view_;  ///< null before the first frame set is read
  rosbag::View::iterator message_;      ///< next message of the view
  size_t messages_read_ = 0;
  std::unique_ptr<Assembler> assembler_;
  std::deque<Assembler::FrameSet> ready_;  ///< complete frame sets that have not been returned yet
  AssemblerCounts counts_;
  int unreadable_ = 0;
  std::string first_unreadable_;
};

}  // namespace markerless_mocap
