#pragma once

#include <array>

#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "hsiao/fit/hull_field.h"
#include "hsiao/model/profile_shape.h"
#include "hsiao/fit/skeleton_error.h"

namespace markerless_mocap {

/// Everything one instant offers to fit to. Parts and hull must outlive it.
struct FittingInstant {
  FittingInstant(const HsiaoProfile& profile, const BodyParts& the_parts,
                 const VisualHull& the_hull, int samples)
      : parts(the_parts), hull(the_hull), curves(profile, the_parts, samples), field(the_hull) {}

  const BodyParts& parts;
  const VisualHull& hull;
  SkeletonError curves;
  HullField field;
};

/// Says whether a fitted pose can be claimed, and which parts are in view.
class PoseJudge {
 public:
  PoseJudge(const HsiaoProfile& profile, const ProfileShape& shape, const FittingOptions& options);

  /// Error of each part of the model, metres; infinite for one without data.
  std::array<double, kPartCount> partErrors(const HsiaoFrames& frames,
                                            const FittingInstant& now) const;

  /// The pose without root and angles: kTracked, or kLost with the reason.
  BodyPose judge(const HsiaoVector& v, const FittingInstant& now) const;

 private:
  std::string objection(const BodyPose& pose, bool has_torso) const;

  const HsiaoProfile* profile_;
  const ProfileShape* shape_;
  FittingOptions options_;
};

}  // namespace markerless_mocap
