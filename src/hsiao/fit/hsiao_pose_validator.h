#pragma once

#include <array>

#include "hsiao/fit/hsiao_skeleton_error.h"
#include "hsiao/fit/hull_distance_field.h"
#include "hsiao/model/hsiao_body_shape.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// The data of one frame that the model is fitted to. Parts and hull must outlive it.
struct HsiaoObservation {
  HsiaoObservation(const HsiaoBodyModel& body_model, const BodyParts& the_parts,
                   const VisualHull& the_hull, const HsiaoOptions& options)
      : parts(the_parts),
        hull(the_hull),
        curves(body_model, the_parts, options.samples_per_curve, options.part_error == "published"),
        field(the_hull) {}

  const BodyParts& parts;
  const VisualHull& hull;
  HsiaoSkeletonError curves;
  HullDistanceField field;
};

/// Decides whether a fitted pose can be reported and which parts are seen.
class HsiaoPoseValidator {
 public:
  HsiaoPoseValidator(const HsiaoBodyModel& body_model, const HsiaoBodyShape& shape,
                     const HsiaoOptions& options);

  /// Error of each part of the model, metres; infinite for a part without data.
  std::array<double, kPartCount> partErrors(const HsiaoFrames& frames,
                                            const HsiaoObservation& now) const;

  /// A pose with all but root and angles: kTracked, or kLost with the reason.
  BodyPose validate(const HsiaoVector& v, const HsiaoObservation& now) const;

 private:
  std::string rejectionReason(const BodyPose& pose, bool has_torso) const;

  const HsiaoBodyModel* body_model_;
  const HsiaoBodyShape* shape_;
  HsiaoOptions options_;
};

}  // namespace markerless_mocap
