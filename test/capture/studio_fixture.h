#pragma once

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "capture/virtual_studio.h"
#include "error_text_of.h"
#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

inline std::string humanTemplate() {
  std::ifstream file(std::string(MOCAP_SOURCE_DIR) + "/urdf/human.urdf.in");
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline std::shared_ptr<const BodyModel> human() {
  const BodyProportions proportions = BodyProportions::fromStature(1.75);
  return std::make_shared<BodyModel>(
      BodyModel::fromUrdf(fillUrdfTemplate(humanTemplate(), "person1", proportions), "person1"));
}

inline StudioFiles packageFiles() {
  return {humanTemplate(), std::string(MOCAP_SOURCE_DIR) + "/config/motions"};
}

inline StudioOptions smallStudio() {
  StudioOptions options;
  options.rig = "ring4";
  options.width = 160;
  options.height = 120;
  options.background_frames = 3;
  options.duration = 2.0;
  return options;
}

}  // namespace markerless_mocap
