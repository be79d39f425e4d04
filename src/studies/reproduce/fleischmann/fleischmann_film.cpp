#include "studies/reproduce/fleischmann/fleischmann_film.h"

#include <sensor_msgs/Image.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "capture/ground_truth.h"
#include "capture/virtual_studio.h"
#include "resources/resources.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/package_files.h"
#include "studies/common/true_parameters.h"
#include "tools/common/bag_io.h"
#include "tools/common/studio_settings.h"

namespace markerless_mocap {
namespace {

constexpr int kTiny = 16;                          // pixels; the images are not used
constexpr int64_t kFirstStamp = 1000'000'000'000;  // of render_capture, nanoseconds

Eigen::Matrix3Xd markersOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd markers(3, Eigen::Index(markerNames().size()));
  for (Eigen::Index m = 0; m < markers.cols(); ++m) markers.col(m) = points[size_t(m)];
  return markers;
}

std::string maskTopic(const std::string& camera) {
  return "/ground_truth/" + camera + "/silhouette";
}

std::vector<std::string> maskTopics(const CameraRig& rig) {
  std::vector<std::string> topics;
  for (const Camera& camera : rig) topics.push_back(maskTopic(camera.name()));
  return topics;
}

}  // namespace

FilmTruth filmTruth(const Capture& capture) {
  StudioOptions studio = readStudioOptions("", capture.studio);
  studio.width = studio.height = kTiny;
  const VirtualStudio stage(studio, {humanUrdfTemplate(), packageFile("config/motions")},
                            "person1");
  FilmTruth truth;
  truth.body = std::make_shared<const BodyModel>(stage.body());
  truth.joints.names = markerNames();
  TrueParameters parameters(*truth.body);
  for (int i = studio.background_frames; i < stage.frameSetCount(); ++i) {
    const StudioFrameSet now = stage.render(i);
    truth.poses.push_back(parameters.follow(now.body));
    truth.joints.add(kFirstStamp + now.time_ns, markersOf(now.points));
  }
  return truth;
}

/// Reads the exact masks of one frame after another.
struct FilmReader::ExactMasks {
  ExactMasks(const std::string& path, const CameraRig& rig) : topics(maskTopics(rig)) {
    openForReading(path, bag);
    view = std::make_unique<rosbag::View>(bag, rosbag::TopicQuery(topics));
    at = view->begin();
  }

  /// The masks with this stamp, in the order of the rig; empty where there is none.
  std::vector<cv::Mat> of(int64_t stamp_ns) {
    std::vector<cv::Mat> masks(topics.size());
    for (; at != view->end() && nanosecondsOf(at->getTime()) <= stamp_ns; ++at) {
      if (nanosecondsOf(at->getTime()) < stamp_ns) continue;
      const auto camera = std::find(topics.begin(), topics.end(), at->getTopic());
      if (const auto message = messageOf<sensor_msgs::Image>(*at))
        masks[size_t(camera - topics.begin())] = matFromMessage(*message);
    }
    return masks;
  }

  std::vector<std::string> topics;
  rosbag::Bag bag;
  std::unique_ptr<rosbag::View> view;
  rosbag::View::iterator at;
};

FilmReader::FilmReader(const std::string& bag, bool exact)
    : recording_(bag, [] {
        RecordingOptions options;
        options.use_masks = true;
        return options;
      }()) {
  if (exact) exact_ = std::make_unique<ExactMasks>(bag, recording_.rig());
}

FilmReader::~FilmReader() = default;

std::optional<FilmFrame> FilmReader::next() {
  const std::optional<FrameSet> frame_set = recording_.next();
  if (!frame_set) return std::nullopt;
  FilmFrame frame;
  frame.stamp_ns = frame_set->stamp_ns;
  std::vector<cv::Mat> exact;
  if (exact_) exact = exact_->of(frame.stamp_ns);
  for (size_t i = 0; i < frame_set->frames.size(); ++i) {
    const CameraFrame& seen = frame_set->frames[i];
    FleischmannView view;
    // A missing image is missing with its exact mask, too.
    if (!seen.image.empty() && !seen.mask.empty()) {
      view.silhouette = (exact_ ? exact[i] : seen.mask).clone();
      cv::cvtColor(seen.image, view.image, cv::COLOR_BGR2GRAY);
    }
    frame.views.push_back(std::move(view));
  }
  return frame;
}

FilmFrame frameOf(const Capture& capture, size_t number, bool exact) {
  FilmReader reader(capture.bag, exact);
  std::optional<FilmFrame> frame = reader.next();
  for (size_t i = 0; i < number && frame; ++i) frame = reader.next();
  if (!frame) throw std::runtime_error(capture.bag + " has no frame " + std::to_string(number));
  return *frame;
}

}  // namespace markerless_mocap
