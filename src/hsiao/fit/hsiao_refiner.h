#pragma once

#include <cstdint>
#include <vector>

#include "hsiao/fit/hsiao_hierarchical_fitter.h"
#include "hsiao/fit/hsiao_skeleton_error.h"
#include "hsiao/fit/hull_distance_field.h"
#include "hsiao/model/hsiao_body_shape.h"

namespace markerless_mocap {

/// Settings of the refinement.
struct HsiaoRefinerSettings {
  int iterations = 10;
  int refinement_surface_points = 600;  ///< surface voxels used
  double curve_weight = 1.0;            ///< of the part curves
  double surface_weight = 1.0;          ///< of the hull's surface
  double inside_weight = 1.0;           ///< of body outside the hull
};

/// What one instant offers to fit to. All must outlive the refinement.
struct HsiaoRefinerData {
  const HsiaoSkeletonError* curves;
  const BodyParts* parts;
  const VisualHull* hull;
  const HullDistanceField* field;
};

/// A refined vector and its weighted mean of squared deviations.
struct HsiaoRefinement {
  HsiaoVector v;
  double cost = 0.0;
};

/// Last step of the fine-tuning: Levenberg-Marquardt on three deviations at once: curve samples
/// from the bones (those of Eq. 3-27), surface voxels of the hull from the body's nearest surface,
/// and body that sticks out of the hull.
class HsiaoRefiner {
 public:
  HsiaoRefiner(const HsiaoBodyModel& profile, const HsiaoBodyShape& shape,
               const HsiaoRefinerSettings& settings);

  /// \param range the result stays inside
  HsiaoRefinement refine(const HsiaoVector& start, const HsiaoBounds& range,
                         const HsiaoRefinerData& data) const;

 private:
  struct Correspondence {
    Eigen::Vector3d point;
    int cone;
    double weight;
  };
  struct Problem;
  void associate(const HsiaoFrames& frames, Problem& problem) const;
  void deviations(const HsiaoVector& v, const Problem& problem, Eigen::VectorXd& out) const;

  const HsiaoBodyModel* profile_;
  const HsiaoBodyShape* shape_;
  HsiaoRefinerSettings settings_;
};

}  // namespace markerless_mocap
