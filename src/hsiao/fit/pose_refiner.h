#pragma once

#include <cstdint>
#include <vector>

#include "hsiao/fit/hierarchical_fitter.h"
#include "hsiao/fit/hull_field.h"
#include "hsiao/model/profile_shape.h"
#include "hsiao/fit/skeleton_error.h"

namespace markerless_mocap {

/// Settings of the refinement.
struct RefinerSettings {
  int iterations = 10;
  int surface_points = 600;     ///< surface voxels used
  double curve_weight = 1.0;    ///< of the part curves
  double surface_weight = 1.0;  ///< of the hull's surface
  double inside_weight = 1.0;   ///< of body outside the hull
};

/// What one instant offers to fit to. All must outlive the refinement.
struct RefinerData {
  const SkeletonError* curves;
  const BodyParts* parts;
  const VisualHull* hull;
  const HullField* field;
};

/// A refined vector and its weighted mean of squared deviations.
struct Refinement {
  HsiaoVector v;
  double cost = 0.0;
};

/// Last step of the fine-tuning: Levenberg-Marquardt on three deviations at once: curve samples
/// from the bones (those of Eq. 3-27), surface voxels of the hull from the body's nearest surface,
/// and body that sticks out of the hull.
class PoseRefiner {
 public:
  PoseRefiner(const HsiaoProfile& profile, const ProfileShape& shape,
              const RefinerSettings& settings);

  /// \param range the result stays inside
  Refinement refine(const HsiaoVector& start, const HsiaoRange& range,
                    const RefinerData& data) const;

 private:
  struct Correspondence {
    Eigen::Vector3d point;
    int cone;
    double weight;
  };
  struct Problem;
  void associate(const HsiaoFrames& frames, Problem& problem) const;
  void deviations(const HsiaoVector& v, const Problem& problem, Eigen::VectorXd& out) const;

  const HsiaoProfile* profile_;
  const ProfileShape* shape_;
  RefinerSettings settings_;
};

}  // namespace markerless_mocap
