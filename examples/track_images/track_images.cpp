// Follows a person through one video or image sequence per camera and prints where the joints are:
//   track_images rig.yaml recording .mp4 30        reads recording/<camera>.mp4
//   track_images rig.yaml recording /%04d.png 30   reads recording/<camera>/0000.png, ...
// 30 are the frames per second. The k-th frames of all cameras belong together, the first second
// shows the empty room.
#include <iostream>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/pipeline/pipeline.h"

using namespace markerless_mocap;

void print(int frame, const PipelineResult& result) {
  if (result.learning || result.pose.status == PoseStatus::kLost) {
    std::cerr << frame << ": " << (result.learning ? "background" : result.pose.reason) << '\n';
    return;
  }
  LinkPoses T_world_link;
  const BodyModel& model = *result.body->model;
  model.forwardKinematics(result.pose.T_world_body, result.pose.angles, T_world_link);
  const std::vector<Eigen::Vector3d> joints = markerPositions(model, T_world_link);
  for (size_t i = 0; i < joints.size(); ++i)
    std::cout << frame << ' ' << markerNames()[i] << ' ' << joints[i].transpose() << '\n';
}

int main(int argc, char** argv) try {
  if (argc != 5) throw std::runtime_error("usage: track_images RIG_FILE FOLDER SUFFIX FPS");
  const std::vector<CameraCalibration> rig = readRig(argv[1]);
  const double fps = std::atof(argv[4]);
  if (!(fps > 0)) throw std::runtime_error("FPS must be a number above 0");
  Pipeline pipeline({rig.begin(), rig.end()}, PersonResources::standard(), PipelineOptions());
  std::vector<cv::VideoCapture> videos;
  for (const CameraCalibration& camera : rig) {
    const std::string path = std::string(argv[2]) + "/" + camera.name + argv[3];
    if (!videos.emplace_back(path).isOpened()) throw std::runtime_error("cannot read " + path);
  }
  for (int frame = 0;; ++frame) {
    std::vector<CameraFrame> frames(videos.size());
    for (size_t i = 0; i < videos.size(); ++i)
      if (!videos[i].read(frames[i].image)) return 0;  // a video has ended
    print(frame, pipeline.process(int64_t(frame * 1e9 / fps), frames));
  }
} catch (const std::exception& error) {
  std::cerr << "track_images: " << error.what() << '\n';
  return 1;
}
