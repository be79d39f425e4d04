#pragma once

#include <string>

namespace markerless_mocap {

// Texts of data files of the package, built into the library (cmake/resources.cmake).
std::string humanUrdfTemplate();        ///< urdf/human.urdf.in
std::string contourBodyYaml();          ///< models/contour_body.yaml
std::string motionStatisticsYaml();     ///< models/motion_statistics.yaml
std::string poseTreeExtremitiesYaml();  ///< models/pose_tree_extremities.yaml
std::string poseTreeValidityYaml();     ///< models/pose_tree_validity.yaml

}  // namespace markerless_mocap
