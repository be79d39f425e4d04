#include <algorithm>
#include <filesystem>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/formats/calibration_files.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/common/progress.h"
#include "tools/import/import_recording.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

cv::VideoCapture openVideo(const fs::path& path) {
  if (!fs::is_regular_file(path)) throw std::runtime_error("there is no video " + path.string());
  cv::VideoCapture video(path.string());
  if (!video.isOpened()) throw std::runtime_error("cannot read the video " + path.string());
  return video;
}

/// The background video of one camera, followed by its video.
class CameraVideos {
 public:
  CameraVideos(const fs::path& folder, const VideosInput& input)
      : name_(folder.filename().string()), video_(openVideo(folder / input.video)) {
    if (input.background.empty()) return;
    background_ = openVideo(folder / input.background);
    background_left_ = input.background_frames;
  }

  const std::string& name() const { return name_; }
  double fps() const { return video_.get(cv::CAP_PROP_FPS); }
  int width() const { return int(video_.get(cv::CAP_PROP_FRAME_WIDTH)); }
  int height() const { return int(video_.get(cv::CAP_PROP_FRAME_HEIGHT)); }
  /// Number of frames according to the file header; 0 if unknown.
  int frames() const { return std::max(0, int(video_.get(cv::CAP_PROP_FRAME_COUNT))); }

  /// Empty after the last frame; throws if the background video is too short.
  cv::Mat next() {
    cv::Mat frame;
    if (background_left_ > 0) {
      if (!background_.read(frame))
        throw std::runtime_error("the background video of " + name_ + " ends " +
                                 std::to_string(background_left_) +
                                 " frames too early: reduce the number of background frames");
      --background_left_;
    } else {
      video_.read(frame);
    }
    return frame;
  }

 private:
  std::string name_;
  cv::VideoCapture video_, background_;
  int background_left_ = 0;
};

std::vector<fs::path> cameraFolders(const VideosInput& input) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(input.folder, error))
    if (fs::is_regular_file(entry.path() / input.video)) folders.push_back(entry.path());
  if (error) throw std::runtime_error("cannot read the folder " + input.folder);
  if (folders.empty())
    throw std::runtime_error("no folder in " + input.folder + " has a video " + input.video);
  std::sort(folders.begin(), folders.end());
  return folders;
}

CameraCalibration fromRig(const std::vector<CameraCalibration>& rig, const CameraVideos& videos,
                          const std::string& file) {
  for (const CameraCalibration& camera : rig) {
    if (camera.name != videos.name()) continue;
    if (camera.width == videos.width() && camera.height == videos.height()) return camera;
    throw std::runtime_error(
        "the video of " + camera.name + " is " + std::to_string(videos.width()) + " x " +
        std::to_string(videos.height()) + " pixels, the rig " + file + " has " +
        std::to_string(camera.width) + " x " + std::to_string(camera.height));
  }
  throw std::runtime_error("camera " + videos.name() + " is not in the rig " + file);
}

CameraCalibration calibrationOf(const fs::path& folder, const VideosInput& input,
                                const CameraVideos& videos, const WorldTransform& world) {
  if (!input.rig.empty()) return fromRig(readRig(input.rig), videos, input.rig);
  CameraCalibration calibration = readCameraCalibration((folder / input.calibration).string());
  calibration.name = videos.name();
  calibration.width = videos.width();
  calibration.height = videos.height();
  return world.apply(calibration);
}

/// The next frame of each camera; empty after the end of any video.
std::vector<cv::Mat> nextFrames(std::vector<CameraVideos>* cameras) {
  std::vector<cv::Mat> frames;
  for (CameraVideos& camera : *cameras) frames.push_back(camera.next());
  const bool ended =
      std::any_of(frames.begin(), frames.end(), [](const cv::Mat& f) { return f.empty(); });
  return ended ? std::vector<cv::Mat>() : frames;
}

/// Number of frames of the shortest video; adds a warning if others are longer.
int shortestVideo(const std::vector<CameraVideos>& cameras, std::vector<std::string>* warnings) {
  const auto [shortest, longest] =
      std::minmax_element(cameras.begin(), cameras.end(),
                          [](const auto& a, const auto& b) { return a.frames() < b.frames(); });
  if (shortest->frames() < longest->frames())
    warnings->push_back("the video of " + shortest->name() + " has " +
                        std::to_string(shortest->frames()) + " frames, that of " + longest->name() +
                        " has " + std::to_string(longest->frames()) + ": the shortest one is used");
  return shortest->frames();
}

}  // namespace

ImportResult importVideos(const VideosInput& input, const ImportOptions& options,
                          std::ostream* notes, bool terminal) {
  options.validate();
  std::vector<CameraVideos> videos;
  ImportResult result;
  for (const fs::path& folder : cameraFolders(input)) {
    videos.emplace_back(folder, input);
    result.cameras.push_back(calibrationOf(folder, input, videos.back(), options.world));
  }
  result.fps = options.fps > 0.0 ? options.fps : videos.front().fps();
  if (!(result.fps > 0.0))
    throw std::runtime_error("the videos do not contain their frame rate (--fps)");
  result.warnings = calibrationWarnings(result.cameras);
  const int shortest = shortestVideo(videos, &result.warnings);

  const int expected = shortest + (input.background.empty() ? 0 : input.background_frames);
  CameraBagWriter bag(options.output, result.cameras, options.jpeg_quality);
  Progress progress("import_recording", notes, terminal);
  bag.writeTransforms(options.stampOf(0, result.fps));
  for (auto frames = nextFrames(&videos); !frames.empty(); frames = nextFrames(&videos)) {
    const int64_t stamp = options.stampOf(result.frame_sets++, result.fps);
    for (size_t i = 0; i < frames.size(); ++i) bag.write(stamp, i, frames[i], cv::Mat());
    progress.update(double(result.frame_sets) / std::max(expected, 1));
  }
  progress.finish();
  if (result.frame_sets < expected)
    result.warnings.push_back("a video ended after " + std::to_string(result.frame_sets) +
                              " frames, background included; its header says " +
                              std::to_string(expected));
  if (result.frame_sets == 0) throw std::runtime_error("the videos have no frames");
  bag.commit();
  return result;
}

}  // namespace markerless_mocap
