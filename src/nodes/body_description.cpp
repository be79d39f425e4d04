#include "nodes/body_description.h"

#include <ros/param.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "markerless_mocap/contour/sizes_file.h"

namespace markerless_mocap {

BodyDescription::~BodyDescription() {
  if (set_) ros::param::del(parameter_);
}

void BodyDescription::set(const TrackedBody& body) {
  ros::param::set(parameter_, body.urdf);
  set_ = true;
}

void writeBodyFile(const std::string& path, const ContourSizes& sizes) {
  const std::string unfinished = path + ".part";
  std::ofstream file(unfinished);
  file << sizesText(sizes);
  file.close();
  if (!file || std::rename(unfinished.c_str(), path.c_str()) != 0)
    throw std::runtime_error("cannot write the body file " + path);
}

}  // namespace markerless_mocap
