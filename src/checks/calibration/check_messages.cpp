#include <algorithm>
#include <cmath>

#include "checks/calibration/check_calibration.h"
#include "checks/text/sentence.h"

namespace markerless_mocap {
namespace {

bool isZero(const SeenInfo& info) {
  return info.K.isZero() || info.width == 0 || info.height == 0;
}

void checkInfo(const SeenCamera& camera, Findings* findings) {
  if (camera.infos.empty()) {
    findings->push_back({"camera_info_missing", camera.name, Severity::kError,
                         "there are images but no camera_info",
                         "record " + camera.name +
                             "/camera_info; a driver takes it from the file "
                             "at camera_info_url, which calibrate_rig writes; or pass --rig"});
    return;
  }
  const SeenInfo& info = camera.infos.front();
  if (isZero(info))
    findings->push_back({"camera_info_zero", camera.name, Severity::kError,
                         info.K.isZero() ? std::string("all of K is 0")
                                         : sentence("the size is %d x %d", info.width, info.height),
                         "the camera is not calibrated, or its driver did not find the calibration "
                         "(camera_info_url): calibrate_rig writes one"});
  else if (!info.problem.empty())
    findings->push_back({"camera_info_unusable", camera.name, Severity::kError, info.problem,
                         "calibrate at the size and with the lens model that are used "
                         "(calibrate_rig), or turn binning and region of interest off"});
}

/// Of one size, if all images have it.
void checkSizes(const SeenCamera& camera, Findings* findings) {
  const SeenImage* first = nullptr;
  int others = 0;
  const SeenImage* other = nullptr;
  for (const SeenImage& image : camera.images) {
    if (image.width == 0) continue;
    if (!first) first = &image;
    if (image.width == first->width && image.height == first->height) continue;
    if (!other) other = &image;
    ++others;
  }
  if (other)
    findings->push_back(
        {"image_size_changes", camera.name, Severity::kError,
         sentence("%d of %zu images are not %d x %d; from %.1f s on they are %d x %d", others,
                  camera.images.size(), first->width, first->height,
                  1e-9 * double(other->received_ns - camera.images.front().received_ns),
                  other->width, other->height),
         "leave the camera's settings alone while recording, and calibrate for one size"});
  if (!first || camera.infos.empty() || isZero(camera.infos.front())) return;
  const SeenInfo& info = camera.infos.front();
  if (info.width == first->width && info.height == first->height) return;
  const bool turned = info.width == first->height && info.height == first->width;
  findings->push_back(
      {"camera_info_size", camera.name, Severity::kError,
       sentence("camera_info is for %d x %d, the images are %d x %d", info.width, info.height,
                first->width, first->height),
       turned
           ? "the images are turned by 90 degrees: turn them back, or calibrate as they are"
           : "record at the size of the calibration, or calibrate at the size of the recording"});
}

void checkChanges(const SeenCamera& camera, Findings* findings) {
  if (camera.infos.size() < 2) return;
  double most = 0;
  bool same_lens = true;
  for (const SeenInfo& info : camera.infos) {
    most = std::max(most, (info.K - camera.infos.front().K).cwiseAbs().maxCoeff());
    same_lens = same_lens && info.D == camera.infos.front().D;
  }
  const double since =
      1e-9 * double(camera.infos[1].received_ns - camera.infos.front().received_ns);
  findings->push_back(
      {"camera_info_changes", camera.name, Severity::kError,
       sentence("camera_info changes %zu times, first after %.1f s; K by up to %.1f px%s",
                camera.infos.size() - 1, since, most, same_lens ? "" : ", and D, too"),
       "switch autofocus and zoom off; let one node only publish this camera_info"});
}

/// A K of another size, or in other units, is far from what lenses have.
void checkPlausible(const SeenCamera& camera, Findings* findings) {
  if (camera.infos.empty() || isZero(camera.infos.front())) return;
  const SeenInfo& info = camera.infos.front();
  const double fx = info.K(0, 0) / info.width, aspect = info.K(1, 1) / info.K(0, 0);
  const double cx = info.K(0, 2) / info.width, cy = info.K(1, 2) / info.height;
  const auto central = [](double at) { return at > 0.25 && at < 0.75; };
  if (fx > 0.2 && fx < 8 && aspect > 0.8 && aspect < 1.25 && central(cx) && central(cy)) return;
  findings->push_back(
      {"camera_info_implausible", camera.name, Severity::kError,
       sentence("fx %.1f, fy %.1f, centre at %.1f, %.1f px do not suit images of %d x %d",
                info.K(0, 0), info.K(1, 1), info.K(0, 2), info.K(1, 2), info.width, info.height),
       "the calibration is of another image size, or not in pixels: multiply K by the ratio of the "
       "sizes, or calibrate again"});
}

}  // namespace

std::optional<CameraCalibration> calibrationOf(const SeenCamera& camera) {
  if (camera.infos.empty() || isZero(camera.infos.front()) || !camera.T_world_camera)
    return std::nullopt;
  const SeenInfo& info = camera.infos.front();
  if (!info.problem.empty()) return std::nullopt;
  CameraCalibration calibration;
  calibration.name = camera.name;
  calibration.width = info.width;
  calibration.height = info.height;
  calibration.K = info.K;
  calibration.D = info.D;
  calibration.lens = info.lens;
  calibration.time_offset = info.time_offset;
  calibration.T_world_camera = *camera.T_world_camera;
  return calibration;
}

void checkMessages(const SeenRig& rig, Findings* findings) {
  for (const SeenCamera& camera : rig.cameras) {
    if (camera.images.empty())
      findings->push_back({"images_missing", camera.name, Severity::kError,
                           "there is camera_info but there are no images",
                           "record " + camera.name + "/image_raw or image_raw/compressed"});
    if (camera.unreadable > 0)
      findings->push_back(
          {"images_unreadable", camera.name, Severity::kWarning,
           sentence("%d of %zu images cannot be decoded", camera.unreadable, camera.images.size()),
           "look at the encoding, and for damage of the bag (rosbag check)"});
    checkInfo(camera, findings);
    checkSizes(camera, findings);
    checkChanges(camera, findings);
    checkPlausible(camera, findings);
    if (!camera.infos.empty() && !camera.T_world_camera)
      findings->push_back(
          {"tf_missing", camera.name, Severity::kError,
           camera.pose_problem.empty() ? "there is no transform" : camera.pose_problem,
           "start or record the transform (calibrate_rig writes cameras.launch; "
           "record /tf_static), or pass --rig"});
  }
}

}  // namespace markerless_mocap
