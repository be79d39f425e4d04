#pragma once

#include <memory>
#include <optional>
#include <string>

#include "contour/contour_urdf_converter.h"
#include "contour/measure/online_shape_estimator.h"
#include "markerless_mocap/contour/contour_options.h"
#include "markerless_mocap/tracking/person_options.h"
#include "markerless_mocap/tracking/person_resources.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {

/// The body of the person: a mean body of some stature, until enough poses have been seen to
/// measure the person's own.
class MeasuredPerson {
 public:
  /// Throws std::invalid_argument if the URDF template describes no suitable body.
  MeasuredPerson(const CameraRig& rig, PersonResources resources, const PersonOptions& person,
                 const ContourOptions& options);

  const PersonResources& resources() const { return resources_; }
  const PersonOptions& options() const { return options_; }
  const std::shared_ptr<const TrackedBody>& tracked() const { return tracked_; }
  const ContourBody& body() const { return *body_; }
  /// To the joint angles of the body.
  ContourUrdfConverter& converter() { return *converter_; }
  const ContourUrdfConverter& converter() const { return *converter_; }
  /// The mean body of this stature, metres.
  ContourBody meanBody(double stature) const;
  /// Of the mean body that is used until the person is measured, metres.
  double stature() const { return stature_; }

  /// False if the body is the person's own, or shall stay the mean one.
  bool isBeingMeasured() const { return estimator_.has_value(); }
  /// What the user is told meanwhile.
  std::string progress() const;

  // The following functions do nothing unless the person is being measured.

  /// Takes the mean body of this stature, metres.
  void setStature(double stature);
  /// \param usable the pose is right
  void add(int64_t stamp_ns, const ContourObservation& seen, const ContourFit& fit, bool usable);
  /// Measures from the frames seen so far.
  void measureNow();
  /// Takes the person's own body if it has been estimated meanwhile; returns whether it has.
  bool takeMeasured();

 private:
  void setBody(std::shared_ptr<const TrackedBody> body);

  PersonResources resources_;
  PersonOptions options_;
  double stature_;
  std::shared_ptr<const TrackedBody> tracked_;
  std::optional<ContourBody> body_;  ///< with the shape of tracked_
  std::optional<ContourUrdfConverter> converter_;
  std::optional<OnlineShapeEstimator> estimator_;
};

}  // namespace markerless_mocap
