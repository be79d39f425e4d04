#include <limits>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "files/text_file.h"
#include "markerless_mocap/formats/calibration_files.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/common/progress.h"
#include "tools/import/camera_files.h"
#include "tools/import/import_recording.h"

namespace markerless_mocap {
namespace {

constexpr double kDefaultFps = 25.0;

/// Files of one camera; one list may be empty.
struct CameraFiles {
  std::string name, matrix;
  std::vector<std::string> images, masks;

  size_t frame_sets() const { return std::max(images.size(), masks.size()); }
  const std::string& first() const { return images.empty() ? masks[0] : images[0]; }
};

std::vector<std::string> filesOf(int number, const std::string& pattern,
                                 const std::map<int, std::vector<std::string>>& files) {
  if (pattern.empty()) return {};
  const auto found = files.find(number);
  if (found == files.end())
    throw std::runtime_error("camera " + std::to_string(number) +
                             " has a matrix but no file that matches " + pattern);
  return found->second;
}

void checkCounts(const std::vector<CameraFiles>& cameras) {
  const size_t frame_sets = cameras.front().frame_sets();
  for (const CameraFiles& camera : cameras)
    for (const auto* files : {&camera.images, &camera.masks})
      if (!files->empty() && files->size() != frame_sets)
        throw std::runtime_error(camera.name + " has " + std::to_string(files->size()) +
                                 " images or masks, " + cameras.front().name + " has " +
                                 std::to_string(frame_sets));
}

std::vector<CameraFiles> listFiles(const MatricesInput& input) {
  if (input.images.empty() && input.masks.empty())
    throw std::invalid_argument("neither images nor masks are given");
  using Files = std::map<int, std::vector<std::string>>;
  const Files matrices = filesByCamera(input.matrices);
  const Files images = input.images.empty() ? Files{} : filesByCamera(input.images);
  const Files masks = input.masks.empty() ? Files{} : filesByCamera(input.masks);
  std::vector<CameraFiles> cameras;
  for (const auto& [number, files] : matrices) {
    if (files.size() != 1)
      throw std::runtime_error("camera " + std::to_string(number) + " has " +
                               std::to_string(files.size()) + " files that match " +
                               input.matrices + ", wanted is one");
    cameras.push_back({"cam" + std::to_string(number), files.front(),
                       filesOf(number, input.images, images), filesOf(number, input.masks, masks)});
  }
  checkCounts(cameras);
  return cameras;
}

cv::Mat readImage(const std::string& path, int flags) {
  checkRegularFile(path, "the image " + path, std::numeric_limits<uintmax_t>::max());
  cv::Mat image = cv::imread(path, flags);
  if (image.empty()) throw std::runtime_error("cannot read the image " + path);
  return image;
}

CameraCalibration calibrationOf(const CameraFiles& files, const WorldTransform& world) {
  CameraCalibration calibration = readCameraCalibration(files.matrix);
  const cv::Mat first = readImage(files.first(), cv::IMREAD_COLOR);
  calibration.name = files.name;
  calibration.width = first.cols;
  calibration.height = first.rows;
  return world.apply(calibration);
}

void writeFrameSet(const std::vector<CameraFiles>& cameras, size_t frame_set, int64_t stamp_ns,
                   CameraBagWriter* bag) {
  for (size_t i = 0; i < cameras.size(); ++i) {
    cv::Mat image, mask;
    if (!cameras[i].images.empty())
      image = readImage(cameras[i].images[frame_set], cv::IMREAD_COLOR);
    if (!cameras[i].masks.empty())
      mask = maskOfThreeValues(readImage(cameras[i].masks[frame_set], cv::IMREAD_GRAYSCALE));
    bag->write(stamp_ns, i, image, mask);
  }
}

}  // namespace

ImportResult importMatrices(const MatricesInput& input, const ImportOptions& options,
                            std::ostream* notes, bool terminal) {
  options.validate();
  const std::vector<CameraFiles> cameras = listFiles(input);
  ImportResult result;
  result.fps = options.fps > 0.0 ? options.fps : kDefaultFps;
  result.frame_sets = int(cameras.front().frame_sets());
  for (const CameraFiles& camera : cameras)
    result.cameras.push_back(calibrationOf(camera, options.world));
  result.warnings = calibrationWarnings(result.cameras);

  CameraBagWriter bag(options.output, result.cameras, options.jpeg_quality);
  Progress progress("import_recording", notes, terminal);
  bag.writeTransforms(options.stampOf(0, result.fps));
  for (int k = 0; k < result.frame_sets; ++k) {
    writeFrameSet(cameras, k, options.stampOf(k, result.fps), &bag);
    progress.update(double(k + 1) / result.frame_sets);
  }
  progress.finish();
  bag.commit();
  return result;
}

}  // namespace markerless_mocap
