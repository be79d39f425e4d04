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
  int refinement_surface_points = 600;  ///< maximum number of surface voxels in the fit
};

/// The data of one frame. All pointers must stay valid during the refinement.
struct HsiaoRefinerData {
  const HsiaoSkeletonError* curves;
  const BodyParts* parts;
  const VisualHull* hull;
  const HullDistanceField* field;
};

/// Refined parameters and their weighted mean squared residual.
struct HsiaoRefinement {
  HsiaoVector v;
  double cost = 0.0;
};

/// Last step of the fine tuning (not in the thesis): Levenberg-Marquardt on three kinds of
/// residuals: distance of curve samples from the bones (as in Eq. 3-27), distance of the hull's
/// surface voxels from the body, and distance of body points outside the hull.
class HsiaoRefiner {
 public:
  HsiaoRefiner(const HsiaoBodyModel& body_model, const HsiaoBodyShape& shape,
               const HsiaoRefinerSettings& settings);

  /// \param range bounds of the result
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
  void associateSurface(const HsiaoFrames& frames, Problem& problem) const;
  void associateCurve(const HsiaoFrames& frames, int part, Problem& problem) const;
  void residuals(const HsiaoVector& v, const Problem& problem, Eigen::VectorXd& out) const;
  /// Derivatives of the residuals by differences. \param here the residuals at v
  Eigen::MatrixXd slopes(const HsiaoVector& v, const Problem& problem,
                         const Eigen::VectorXd& here) const;
  /// The vector within bounds, with the neck at its distance from the centre.
  HsiaoVector inRange(const HsiaoVector& wanted, const HsiaoBounds& range) const;

  const HsiaoBodyModel* body_model_;
  const HsiaoBodyShape* shape_;
  HsiaoRefinerSettings settings_;
};

}  // namespace markerless_mocap
