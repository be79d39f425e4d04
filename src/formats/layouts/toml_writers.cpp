#include <sstream>

#include "formats/parts/camera_parts.h"

#include "text/number_text.h"

namespace markerless_mocap {
namespace {

/// How one program's TOML differs from the others'.
struct Dialect {
  const char* format;
  double unit = 1.0;  ///< metres
  bool float_size = false;
  bool says_fisheye = false;  ///< of every lens
};

/// A number as TOML's float: Python's reader wants all entries of an array to be of one type.
std::string floatText(double value) {
  const std::string text = numberText(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string arrayText(const std::vector<double>& values, size_t per_row = 0) {
  std::string out = "[";
  for (size_t i = 0; i < values.size(); ++i) {
    const bool row_starts = per_row > 0 && i % per_row == 0;
    out += (i > 0 ? ", " : "") + std::string(row_starts ? "[" : "") + floatText(values[i]);
    if (per_row > 0 && (i + 1) % per_row == 0) out += "]";
  }
  return out + "]";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return out + '"';
}

std::string sizeText(const CameraCalibration& camera, const Dialect& dialect) {
  if (dialect.float_size) return arrayText({double(camera.width), double(camera.height)});
  return '[' + std::to_string(camera.width) + ", " + std::to_string(camera.height) + ']';
}

/// size, matrix and distortions, alike in all dialects; "fisheye" where the dialect says it or the
/// lens is one.
std::string lensText(const CameraCalibration& camera, const Dialect& dialect) {
  const bool rational = camera.D.size() == 8, fisheye = camera.lens == LensType::kFisheye;
  const std::string kind = fisheye                ? "fisheye = true\n"
                           : dialect.says_fisheye ? "fisheye = false\n"
                                                  : "";
  return "size = " + sizeText(camera, dialect) + "\nmatrix = " + arrayText(rowsOf(camera.K), 3) +
         "\ndistortions = " +
         arrayText(fisheye ? fisheyeDistortion(camera)
                           : distortionOfLength(camera, rational ? 8 : 5, dialect.format)) +
         '\n' + kind;
}

std::string anyAniposeText(const std::vector<CameraCalibration>& rig, const Dialect& dialect,
                           bool keys_are_names, const char* end) {
  std::string out;
  for (size_t i = 0; i < rig.size(); ++i) {
    const Eigen::Isometry3d T = rig[i].T_world_camera.inverse();
    const std::string key = keys_are_names ? quoted(rig[i].name) : "cam_" + std::to_string(i);
    out += '[' + key + "]\nname = " + quoted(rig[i].name) + '\n' + lensText(rig[i], dialect) +
           "rotation = " + arrayText(rowsOf(rotationVector(T.linear()))) +
           "\ntranslation = " + arrayText(rowsOf(Eigen::Vector3d(T.translation() / dialect.unit))) +
           "\n\n";
  }
  return out + end;
}

}  // namespace

std::vector<TextFile> writeAniposeFiles(const std::vector<CameraCalibration>& rig) {
  return {{"", anyAniposeText(rig, {"anipose TOML"}, false, "[metadata]\n")}};
}

std::vector<TextFile> writeFreeMoCapFiles(const std::vector<CameraCalibration>& rig) {
  return {{"", anyAniposeText(rig, {"FreeMoCap TOML", 0.001}, false,
                              "[metadata]\nunits = \"millimetres\"\n")}};
}

std::vector<TextFile> writePose2SimFiles(const std::vector<CameraCalibration>& rig) {
  return {{"", anyAniposeText(rig, {"Pose2Sim TOML", 1.0, true, true}, true,
                              "[metadata]\nadjusted = false\nerror = 0.0\n")}};
}

std::vector<TextFile> writeCaliscopeFiles(const std::vector<CameraCalibration>& rig) {
  std::string out;
  for (size_t i = 0; i < rig.size(); ++i) {
    const Eigen::Isometry3d T = rig[i].T_world_camera.inverse();
    const std::string number = std::to_string(i);
    out += "[cameras." + number + "]\ncam_id = " + number +
           "\nrotation_count = 0\nignore = false\n" + lensText(rig[i], {"caliscope TOML"}) +
           "translation = " + arrayText(rowsOf(T.translation())) +
           "\nrotation = " + arrayText(rowsOf(T.linear()), 3) + "\n\n";
  }
  return {{"", out}};
}

}  // namespace markerless_mocap
