#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "exports/person_motion.h"

namespace markerless_mocap {

/// A point of the person and its name in a file.
struct NamedPoint {
  std::string name;
  /// bodyPointNames(), waist, torso, l_clavicle, r_clavicle; empty: the body has no such point, it
  /// stays a gap
  std::string point;
  std::string towards;    ///< second point, empty: none
  double fraction = 0.0;  ///< of the way from `point` to `towards`
};

/// "package", "motionbuilder", "opensim", "h36m", "smpl", "coco"
const std::vector<std::string>& nameSets();

/// All points of a set in its own order. Throws std::invalid_argument if there is no such set; the
/// message names all.
const std::vector<NamedPoint>& pointNames(const std::string& set);

/// The points with these names, in this order. Throws std::invalid_argument for a name that the
/// set does not have; the message names all.
std::vector<NamedPoint> choosePoints(const std::string& set, const std::vector<std::string>& names);

/// Name of a point in a set, else its name in motionbuilder's.
std::string nameOfPoint(const std::string& set, const std::string& point);

/// Places of points in the world, metres, as columns; NaN: not seen.
Eigen::Matrix3Xd placesOf(const std::vector<NamedPoint>& points, const BodyModel& body,
                          const PersonFrame& frame);

/// The link that a point is fixed to; -1: the body has no such point.
int linkOf(const NamedPoint& point, const BodyModel& body);

/// Expected error of the end of the part that a point belongs to, metres; NaN: unknown.
double expectedError(const NamedPoint& point, const PersonFrame& frame);

}  // namespace markerless_mocap
