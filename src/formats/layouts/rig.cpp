#include "formats/parts/layout.h"
#include "formats/parts/yaml_parts.h"
#include "markerless_mocap/camera/rig_file.h"

namespace markerless_mocap {

bool isRigText(const std::string& text) {
  const auto root = yamlMap(text);
  return root && (*root)["cameras"] && (*root)["cameras"].IsSequence();
}

CalibrationSet readRigFiles(const std::vector<TextFile>& files) {
  if (files.size() != 1)
    throw std::invalid_argument(files[1].path + ": this is a second rig file beside " +
                                files[0].path + ", allowed is one");
  CalibrationSet set;
  set.cameras = rigFromText(files[0].text, files[0].path);
  set.metres_per_unit = 1.0;
  return set;
}

std::vector<TextFile> writeRigFiles(const std::vector<CameraCalibration>& rig) {
  return {{"", rigText(rig)}};
}

}  // namespace markerless_mocap
