#include <stdexcept>

#include "files/whole_file.h"
#include "nodes/visual_hull/hull_stage.h"
#include "ros/volume_file.h"

namespace markerless_mocap {

void HullStage::advertiseServices() {
  services_.onSwitch("set_running", [this](bool runs) -> std::string {
    runs_ = runs;
    return runs ? "hulls are carved" : "no more hulls are carved";
  });
  services_.onTrigger("save_volume", [this] { return saveVolume(); });
}

std::string HullStage::saveVolume() const {
  const std::string& file = node_options_.volume_file;
  if (file.empty())
    throw std::invalid_argument("volume_file is empty, allowed is the file to write to");
  writeWholeFile(file, volumeText(live_.options()));
  return "saved in " + file;
}

}  // namespace markerless_mocap
