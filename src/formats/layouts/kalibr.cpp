// Kalibr's camchain: github.com/ethz-asl/kalibr/wiki/yaml-formats. Each camera has its pose
// relative to the one before it.
#include <sstream>

#include "formats/parts/camera_parts.h"
#include "formats/parts/yaml_parts.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

constexpr const char* kFormat = "Kalibr camchain";

std::string keyOf(size_t camera) {
  return "cam" + std::to_string(camera);
}

void checkModel(const YAML::Node& camera, const char* key, const std::string& allowed,
                const std::string& where) {
  const std::string value = yamlRequired(camera, key, where).as<std::string>("");
  if (value != allowed)
    throwFormatError(where, std::string("'") + key + "' is " + value + ", allowed is " + allowed);
}

/// "cam0" of "/cam0/image_raw"; empty if there is no topic.
std::string nameFromTopic(const YAML::Node& camera) {
  std::string topic = camera["rostopic"].as<std::string>("");
  if (!topic.empty() && topic[0] == '/') topic.erase(0, 1);
  const size_t slash = topic.find("/image");
  return slash == std::string::npos ? topic : topic.substr(0, slash);
}

Eigen::Isometry3d stepIn(const YAML::Node& camera, const std::string& where) {
  const auto v = yamlNumbers(yamlRequired(camera, "T_cn_cnm1", where), "T_cn_cnm1", where);
  checkNumbers(v, 16, "'T_cn_cnm1'", where);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotationFrom({v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10]}, where);
  T.translation() << v[3], v[7], v[11];
  return T;
}

CameraCalibration cameraIn(const YAML::Node& node, const std::string& where) {
  checkModel(node, "camera_model", "pinhole", where);
  CameraCalibration camera;
  camera.name = nameFromTopic(node);
  const auto f = yamlNumbers(yamlRequired(node, "intrinsics", where), "intrinsics", where);
  checkNumbers(f, 4, "'intrinsics'", where);
  camera.K = cameraMatrixFrom({f[0], 0, f[2], 0, f[1], f[3], 0, 0, 1}, where);
  const std::string model = node["distortion_model"].as<std::string>("");
  if (model != "none") {
    if (model == "equidistant")
      camera.lens = LensType::kFisheye;
    else if (model != "radtan")
      throwFormatError(
          where, "'distortion_model' is " + model + ", allowed are radtan, equidistant and none");
    camera.D =
        yamlNumbers(yamlRequired(node, "distortion_coeffs", where), "distortion_coeffs", where);
    checkNumbers(camera.D, 4, "'distortion_coeffs'", where);
  }
  const YAML::Node size = yamlRequired(node, "resolution", where);
  if (!size.IsSequence() || size.size() != 2)
    throwFormatError(where, "'resolution' is not [width, height]");
  camera.width = yamlPixels(size[0], "resolution", where);
  camera.height = yamlPixels(size[1], "resolution", where);
  return camera;
}

/// Topics may be missing, or the same for two cameras.
void giveNames(std::vector<CameraCalibration>* cameras) {
  bool distinct = true;
  for (size_t i = 0; i < cameras->size(); ++i) {
    distinct = distinct && !(*cameras)[i].name.empty();
    for (size_t j = 0; j < i; ++j) distinct = distinct && (*cameras)[i].name != (*cameras)[j].name;
  }
  for (size_t i = 0; !distinct && i < cameras->size(); ++i) (*cameras)[i].name = keyOf(i);
}

std::string cameraText(const CameraCalibration& camera, size_t index,
                       const Eigen::Isometry3d* previous) {
  checkNoSkew(camera, kFormat);
  const Eigen::Matrix3d& K = camera.K;
  const bool fisheye = camera.lens == LensType::kFisheye;
  std::ostringstream out;
  out << keyOf(index) << ":\n  camera_model: pinhole\n  intrinsics: ["
      << numbersText(std::array{K(0, 0), K(1, 1), K(0, 2), K(1, 2)})
      << "]\n  distortion_model: " << (fisheye ? "equidistant" : "radtan")
      << "\n  distortion_coeffs: ["
      << numbersText(fisheye ? fisheyeDistortion(camera) : distortionOfLength(camera, 4, kFormat))
      << "]\n";
  if (previous) {
    const Eigen::Matrix4d T = (camera.T_world_camera.inverse() * *previous).matrix();
    out << "  T_cn_cnm1:\n";
    for (int r = 0; r < 4; ++r)
      out << "  - [" << numbersText(std::array{T(r, 0), T(r, 1), T(r, 2), T(r, 3)}) << "]\n";
  }
  out << "  resolution: [" << camera.width << ", " << camera.height
      << "]\n  rostopic: " << yamlQuoted('/' + camera.name + "/image_raw") << '\n';
  return out.str();
}

}  // namespace

bool isKalibrText(const std::string& text) {
  const auto root = yamlMap(text);
  if (!root) return false;
  const YAML::Node first = (*root)[keyOf(0)];
  return first && first.IsMap() && first["camera_model"] && first["intrinsics"];
}

CalibrationSet readKalibrFiles(const std::vector<TextFile>& files) {
  if (files.size() != 1)
    throwFormatError(files[1].path,
                     "this is a second camchain beside " + files[0].path + ", allowed is one");
  const YAML::Node root = *yamlMap(files[0].text);
  CalibrationSet set;
  set.metres_per_unit = 1.0;
  Eigen::Isometry3d T_camera_world = Eigen::Isometry3d::Identity();
  for (size_t i = 0; root[keyOf(i)]; ++i) {
    const std::string where = files[0].path + ", " + keyOf(i);
    set.cameras.push_back(cameraIn(root[keyOf(i)], where));
    if (i > 0) T_camera_world = stepIn(root[keyOf(i)], where) * T_camera_world;
    set.cameras.back().T_world_camera = T_camera_world.inverse();
  }
  giveNames(&set.cameras);
  set.remarks.push_back("a camchain has no world: the world is the optical frame of " +
                        set.cameras.front().name);
  return set;
}

std::vector<TextFile> writeKalibrFiles(const std::vector<CameraCalibration>& rig) {
  std::string out;
  for (size_t i = 0; i < rig.size(); ++i)
    out += cameraText(rig[i], i, i > 0 ? &rig[i - 1].T_world_camera : nullptr);
  return {{"", out}};
}

}  // namespace markerless_mocap
