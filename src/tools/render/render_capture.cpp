#include "tools/render/render_capture.h"

#include <std_msgs/String.h>

#include <stdexcept>

#include "camera/rig_calibrations.h"
#include "capture/ground_truth.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/truth_conversions.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/common/person_urdf.h"
#include "tools/common/progress.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFirstStamp = 1000'000'000'000;  // nanoseconds
const std::string kTruth = "/ground_truth/";

[[noreturn]] void refuse(const std::string& option, const std::string& value,
                         const std::string& allowed) {
  throw std::invalid_argument(option + " is \"" + value + "\", allowed are " + allowed);
}

rosbag::CompressionType compressionOf(const std::string& name) {
  if (name == "lz4") return rosbag::compression::LZ4;
  if (name == "none") return rosbag::compression::Uncompressed;
  refuse("compression", name, "lz4 and none");
}

/// As in CameraBagWriter: 0 stands for raw images.
int qualityOf(const RenderOptions& options) {
  if (options.images != "raw" && options.images != "jpeg" && options.images != "none")
    refuse("images", options.images, "raw, jpeg and none");
  if (options.jpeg_quality < 1 || options.jpeg_quality > 100)
    refuse("jpeg quality", std::to_string(options.jpeg_quality), "1 to 100");
  return options.images == "jpeg" ? options.jpeg_quality : 0;
}

/// Writes one frame set after another.
class CaptureWriter {
 public:
  CaptureWriter(const RenderOptions& options, const VirtualStudio& studio)
      : studio_(studio),
        images_(options.images != "none"),
        masks_(options.masks),
        bag_(options.output, calibrationsOf(studio.rig()), qualityOf(options),
             compressionOf(options.compression)) {
    bag_.writeTransforms(kFirstStamp);
    std_msgs::String urdf;
    urdf.data = studio.urdf();
    bag_.bag().writeLatched(kTruth + "human_description", rosTime(kFirstStamp), urdf);
  }

  /// Returns the number of missing images.
  int write(const StudioFrameSet& frame_set) {
    const int64_t stamp = kFirstStamp + frame_set.time_ns;
    std_msgs::Header header;
    header.stamp = rosTime(stamp);
    int dropped = 0;
    for (size_t i = 0; i < frame_set.masks.size(); ++i) {
      const std::string& name = studio_.rig()[i].name();
      header.frame_id = opticalFrame(name);
      bag_.bag().write(kTruth + name + "/silhouette", header.stamp,
                       messageFromMat(frame_set.masks[i], header));
      dropped += frame_set.images[i].empty();
      if (frame_set.images[i].empty()) continue;
      bag_.write(stamp, i, images_ ? frame_set.images[i] : cv::Mat(),
                 masks_ ? frame_set.silhouettes[i] : cv::Mat());
    }
    header.frame_id = "world";
    if (frame_set.person) writeTruth(frame_set, header);
    return dropped;
  }

  void commit() { bag_.commit(); }

 private:
  void writeTruth(const StudioFrameSet& frame_set, const std_msgs::Header& header) {
    bag_.bag().write(kTruth + "joints", header.stamp,
                     messageFromPoints(groundTruthNames(), frame_set.points, header));
    bag_.bag().write(kTruth + "joint_states", header.stamp,
                     messageFromAngles(studio_.body(), frame_set.body.angles, header));
  }

  const VirtualStudio& studio_;
  bool images_, masks_;
  CameraBagWriter bag_;
};

}  // namespace

RenderSummary renderCapture(const RenderOptions& options, std::ostream* notes, bool terminal) {
  const VirtualStudio studio(options.studio, options.files, options.body_id);
  CaptureWriter writer(options, studio);
  RenderSummary summary;
  summary.cameras = int(studio.rig().size());
  summary.frame_sets = studio.frameSetCount();
  summary.background = options.studio.background_frames;
  summary.stature = studio.stature();
  summary.seconds = summary.frame_sets / options.studio.fps;
  Progress progress("render_capture", notes, terminal);
  for (int i = 0; i < summary.frame_sets; ++i) {
    if (options.interrupted())
      throw std::runtime_error("interrupted, " + options.output + " is not written");
    summary.dropped += writer.write(studio.render(i));
    progress.update(double(i + 1) / summary.frame_sets);
  }
  progress.finish();
  if (!options.rig_out.empty()) writeRig(options.rig_out, calibrationsOf(studio.rig()));
  writer.commit();
  return summary;
}

void print(const RenderSummary& summary, std::ostream& out) {
  out << summary.cameras << " cameras, " << summary.frame_sets << " frame sets in "
      << summary.seconds << " s, the first " << summary.background << " show the empty room\n"
      << "the person is " << summary.stature << " m tall\n";
  if (summary.dropped > 0) out << summary.dropped << " images are missing, as requested\n";
}

}  // namespace markerless_mocap
