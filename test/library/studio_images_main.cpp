// Films the virtual studio for installed_library: studio_images FOLDER MOTIONS_FOLDER FPS writes
// rig.yaml, <camera>/%04d.png and truth.txt, whose lines are those of examples/track_images.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "capture/ground_truth.h"
#include "capture/virtual_studio.h"
#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/tracking/person_resources.h"

namespace {

using namespace markerless_mocap;
namespace fs = std::filesystem;

StudioOptions optionsAt(double fps) {
  StudioOptions options;
  options.rig = "ring4";
  options.width = 320;
  options.height = 240;
  options.fps = fps;
  options.duration = 6.0;
  return options;
}

void writeImage(const fs::path& folder, int frame, const cv::Mat& image) {
  char name[16];
  std::snprintf(name, sizeof name, "%04d.png", frame);
  if (!cv::imwrite((folder / name).string(), image, {cv::IMWRITE_PNG_COMPRESSION, 1}))
    throw std::runtime_error("cannot write to " + folder.string());
}

void film(const fs::path& folder, const std::string& motions_folder, double fps) {
  const VirtualStudio studio(
      optionsAt(fps), {PersonResources::standard().urdf_template, motions_folder}, "person1");
  std::vector<CameraCalibration> rig;
  for (const Camera& camera : studio.rig()) {
    rig.push_back(camera.calibration());
    fs::create_directories(folder / camera.name());
  }
  writeRig((folder / "rig.yaml").string(), rig);
  std::ofstream truth(folder / "truth.txt");
  for (int frame = 0; frame < studio.frameSetCount(); ++frame) {
    const StudioFrameSet set = studio.render(frame);
    for (size_t i = 0; i < rig.size(); ++i) writeImage(folder / rig[i].name, frame, set.images[i]);
    for (size_t i = 0; i < set.points.size(); ++i)
      truth << frame << ' ' << groundTruthNames()[i] << ' ' << set.points[i].transpose() << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) throw std::runtime_error("usage: studio_images FOLDER MOTIONS_FOLDER FPS");
  film(argv[1], argv[2], std::stod(argv[3]));
} catch (const std::exception& error) {
  std::cerr << "studio_images: " << error.what() << '\n';
  return 1;
}
