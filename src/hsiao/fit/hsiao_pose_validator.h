#pragma once

#include <array>

#include "hsiao/fit/hsiao_skeleton_error.h"
#include "hsiao/fit/hull_distance_field.h"
#include "hsiao/model/hsiao_body_shape.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// Everything one instant offers to fit to. Parts and hull must outlive it.
struct HsiaoObservation {
  HsiaoObservation(const HsiaoBodyModel& profile, const BodyParts& the_parts,
                   const VisualHull& the_hull, int samples)
      : parts(the_parts), hull(the_hull), curves(profile, the_parts, samples), field(the_hull) {}

  const BodyParts& parts;
  const VisualHull& hull;
  HsiaoSkeletonError curves;
  HullDistanceField field;
};

/// Says whether a fitted pose can be claimed, and which parts are in view.
class HsiaoPoseValidator {
 public:
  HsiaoPoseValidator(const HsiaoBodyModel& profile, const HsiaoBodyShape& shape,
                     const HsiaoOptions& options);

  /// Error of each part of the model, metres; infinite for one without data.
  std::array<double, kPartCount> partErrors(const HsiaoFrames& frames,
                                            const HsiaoObservation& now) const;

  /// The pose without root and angles: kTracked, or kLost with the reason.
  BodyPose judge(const HsiaoVector& v, const HsiaoObservation& now) const;

 private:
  std::string rejectionReason(const BodyPose& pose, bool has_torso) const;

  const HsiaoBodyModel* profile_;
  const HsiaoBodyShape* shape_;
  HsiaoOptions options_;
};

}  // namespace markerless_mocap
