// TOML of anipose, caliscope, FreeMoCap and Pose2Sim: a table per camera with size, matrix,
// distortions, rotation (rotation vector, or a matrix in caliscope) and translation, world to
// camera.
#include <algorithm>

#include "files/toml_text.h"
#include "formats/parts/camera_parts.h"

namespace markerless_mocap {
namespace {

struct CameraTable {
  std::string key;
  const toml::table* table;
};

/// Tables with a camera matrix, at the top or in [cameras], in the order of the file.
std::vector<CameraTable> cameraTables(const toml::table& root) {
  std::vector<CameraTable> found;
  const auto collect = [&](const toml::table& table) {
    for (const auto& [key, value] : table)
      if (const toml::table* camera = value.as_table(); camera && camera->contains("matrix"))
        found.push_back({std::string(key.str()), camera});
  };
  collect(root);
  if (const toml::table* cameras = root["cameras"].as_table()) collect(*cameras);
  std::sort(found.begin(), found.end(), [](const CameraTable& a, const CameraTable& b) {
    return a.table->source().begin.line < b.table->source().begin.line;
  });
  return found;
}

void collectNumbers(const toml::node& node, const std::string& key, const std::string& where,
                    std::vector<double>* values) {
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& entry : *array) collectNumbers(entry, key, where, values);
  } else if (const auto number = node.value<double>()) {
    values->push_back(*number);
  } else {
    throwFormatError(where, "'" + key + "' has an entry that is no number");
  }
}

/// Numbers of an array, row by row; empty if the key is missing.
std::vector<double> numbersOf(const toml::table& camera, const std::string& key,
                              const std::string& where) {
  std::vector<double> values;
  if (const toml::node* node = camera.get(key)) collectNumbers(*node, key, where, &values);
  return values;
}

std::string nameOf(const CameraTable& camera, bool caliscope) {
  if (caliscope) return "cam_" + camera.key;
  if (const auto name = (*camera.table)["name"].value<std::string>(); name && !name->empty())
    return *name;
  return camera.key;
}

CameraCalibration cameraIn(const CameraTable& entry, bool caliscope, const std::string& path) {
  const toml::table& table = *entry.table;
  const std::string where = path + ", camera " + entry.key;
  CameraCalibration camera;
  camera.name = nameOf(entry, caliscope);
  if (table["fisheye"].value_or(false)) camera.lens = LensType::kFisheye;
  const auto size = numbersOf(table, "size", where);
  if (!size.empty()) {
    checkNumbers(size, 2, "'size'", where);
    camera.width = pixelsFrom(size[0], "size", where);
    camera.height = pixelsFrom(size[1], "size", where);
  }
  camera.K = cameraMatrixFrom(numbersOf(table, "matrix", where), where);
  camera.D = numbersOf(table, "distortions", where);
  const auto t = numbersOf(table, "translation", where);
  checkNumbers(t, 3, "'translation'", where);
  camera.T_world_camera = poseFromWorldToCamera(
      rotationFrom(numbersOf(table, "rotation", where), where), {t[0], t[1], t[2]});
  return camera;
}

/// caliscope says "nan" or nothing for a camera whose pose it did not find.
bool hasPose(const toml::table& camera) {
  const auto holds = [&](const char* key) {
    const toml::array* array = camera[key].as_array();
    return array && !array->empty();
  };
  return holds("rotation") && holds("translation");
}

CalibrationFormat formatOf(const toml::table& root) {
  if (root["cameras"].is_table()) return CalibrationFormat::kCaliscope;
  const toml::node_view metadata = root["metadata"];
  if (metadata["units"].value_or(std::string()) == "millimetres")
    return CalibrationFormat::kFreeMoCap;
  for (const char* key :
       {"charuco_square_size", "date_time_calibrated", "path_to_recorded_videos_folder"})
    if (metadata[key]) return CalibrationFormat::kFreeMoCap;
  // anipose says it of fisheyes only, and its cameras are cam_0, cam_1, ...
  for (const auto& [key, value] : root)
    if (const toml::table* table = value.as_table(); table && table->contains("fisheye"))
      if (key.str().rfind("cam_", 0) != 0 || !(*table)["fisheye"].value_or(false))
        return CalibrationFormat::kPose2Sim;
  return CalibrationFormat::kAnipose;
}

void setUnit(CalibrationSet* set) {
  if (set->format == CalibrationFormat::kFreeMoCap)
    set->metres_per_unit = 0.001;
  else if (set->format != CalibrationFormat::kAnipose)
    set->metres_per_unit = 1.0;
}

}  // namespace

bool isTomlText(const std::string& text) {
  constexpr size_t kLongest = 4u << 20;  // a calibration is shorter
  if (text.size() > kLongest || text.find("matrix") == std::string::npos ||
      text.find('[') == std::string::npos || text.find('=') == std::string::npos ||
      text.find("<?xml") != std::string::npos)
    return false;
  try {
    return !cameraTables(toml::parse(text)).empty();
  } catch (const toml::parse_error&) {
    return text.find("distortions") != std::string::npos;  // meant as one
  }
}

CalibrationSet readTomlFiles(const std::vector<TextFile>& files) {
  if (files.size() != 1)
    throwFormatError(files[1].path,
                     "this is a second calibration beside " + files[0].path + ", allowed is one");
  const toml::table root = tomlFrom(files[0].text, files[0].path);
  CalibrationSet set;
  set.format = formatOf(root);
  setUnit(&set);
  const bool caliscope = set.format == CalibrationFormat::kCaliscope;
  for (const CameraTable& camera : cameraTables(root)) {
    const std::string name = nameOf(camera, caliscope);
    if ((*camera.table)["ignore"].value_or(false))
      set.remarks.push_back("camera " + name + " is left out, the file says to ignore it");
    else if (!hasPose(*camera.table))
      set.remarks.push_back("camera " + name + " is left out, it has no rotation or translation");
    else
      set.cameras.push_back(cameraIn(camera, caliscope, files[0].path));
  }
  return set;
}

}  // namespace markerless_mocap
