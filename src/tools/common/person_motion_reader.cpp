#include "tools/common/person_motion_reader.h"

#include <stdexcept>
#include <utility>

#include "ros/package_files.h"
#include "tools/common/result_record.h"

namespace markerless_mocap {

PersonMotion readPersonMotion(const std::string& path, const std::string& id,
                              const std::string& urdf_file) {
  ResultRecord record =
      readResults(path, id, urdf_file.empty() ? std::string() : readText(urdf_file));
  const std::string& body = record.body_id;
  if (!record.has_description && urdf_file.empty())
    throw std::runtime_error(path + " has no URDF of the body " + body +
                             ": give it by --urdf (rosparam get /human_description_" + body +
                             " prints it while the nodes run)");
  std::vector<PersonFrame> frames;
  for (ResultFrame& result : record.frames) {
    PersonFrame frame;
    frame.stamp_ns = result.stamp_ns;
    frame.T_world_link = std::move(result.T_world_link);
    frame.part_sigma_m = result.part_sigma_m;
    frames.push_back(std::move(frame));
  }
  try {
    return personMotion(record.body, std::move(frames));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace markerless_mocap
