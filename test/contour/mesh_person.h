#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "capture/studio_fixture.h"
#include "capture/virtual_studio.h"
#include "contour/contour_urdf_converter.h"

namespace markerless_mocap {

/// A person who is not the fitted body: the virtual studio's skinned mesh, with exact masks and
/// exact joints. Whirls with the arms away from the body.
class MeshPerson {
 public:
  static constexpr double kStature = 1.64;  ///< metres

  struct Sight {
    std::vector<cv::Mat> masks;  ///< by camera
    Eigen::Matrix3Xd joints;     ///< the fifteen of markerNames(), world, metres
    ContourPose pose;            ///< about the person's: that of a URDF body driven by it
  };

  explicit MeshPerson(const char* cameras) : studio_(options(cameras), packageFiles(), "person1") {}
  const CameraRig& rig() const { return studio_.rig(); }

  /// Four instants per second, from 0.
  Sight at(int instant) const {
    StudioFrameSet filmed = studio_.render(instant);
    Sight sight;
    sight.masks = std::move(filmed.masks);
    sight.joints.resize(3, 15);
    for (Eigen::Index i = 0; i < 15; ++i) sight.joints.col(i) = filmed.points[size_t(i)];
    const ContourUrdfConverter converter(std::make_shared<BodyModel>(studio_.body()));
    sight.pose = converter.poseOf(filmed.body.T_world_body, filmed.body.angles);
    return sight;
  }

 private:
  static StudioOptions options(const char* cameras) {
    StudioOptions options;
    options.motion = "whirling_dance";
    options.motion_start = 1.0;
    options.rig = cameras;
    options.width = 320;
    options.height = 240;
    options.fps = 4;
    options.background_frames = 0;
    options.character.stature = kStature;
    options.character.male = 0.2;
    return options;
  }

  VirtualStudio studio_;
};

}  // namespace markerless_mocap
