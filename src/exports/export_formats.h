#pragma once

#include <string>
#include <vector>

#include "exports/export_skeleton.h"
#include "exports/person_motion.h"
#include "exports/point_names.h"

/// Files of other programs. docs/export.md describes the conventions of each.
namespace markerless_mocap {

/// Biovision Hierarchy: y up, the person at rest stands in a T-pose and faces +z.
/// \param units_per_metre 100: centimetres, the custom of animation programs
std::string bvhOf(const PersonMotion& motion, const ExportSkeleton& skeleton,
                  double units_per_metre);

/// glTF 2.0, binary: y up, the person at rest faces +z, metres. A skin, its joints, one animation.
std::string glbOf(const PersonMotion& motion, const ExportSkeleton& skeleton);

/// OpenSim's marker file: x as the world, y up, z the world's -y, millimetres. A gap is an empty
/// field.
std::string trcOf(const PersonMotion& motion, const std::vector<NamedPoint>& points,
                  const std::string& file_name);

/// C3D, Intel floats: axes of the world, z up, millimetres. A gap has the residual -1; what was
/// filled 0; else it is the expected error of the part's end in whole millimetres, at least 1.
std::string c3dOf(const PersonMotion& motion, const std::vector<NamedPoint>& points);

/// OpenSim's motion file: coordinates of the model of Rajagopal et al. 2016, degrees and metres. A
/// gap is "nan".
std::string motOf(const PersonMotion& motion, const std::string& name);

/// One row per frame and point: stamp and time in s, place in m, quaternion of the point's link in
/// the world, expected error of the part's end in m. A gap has empty fields.
std::string pointsCsvOf(const PersonMotion& motion, const std::vector<NamedPoint>& points);

/// One row per frame and joint of the URDF, angles in degrees.
std::string anglesCsvOf(const PersonMotion& motion);

/// joint, from and to in s, "filled" or "not seen", for formats that cannot say it themselves.
std::string gapsCsvOf(const PersonMotion& motion, const ExportSkeleton& skeleton);

}  // namespace markerless_mocap
