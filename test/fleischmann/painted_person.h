#pragma once

#include <vector>

#include "evaluation/body_silhouette.h"
#include "fleischmann/fleischmann_fitness.h"

namespace markerless_mocap {

/// What cameras see of a grey person before a brighter wall. The person is the URDF body with all
/// its round cones, hands, feet and neck among them, painted by the evaluation's own code: neither
/// the renderer nor the ten cones of the fitness.
inline std::vector<FleischmannView> paintedViews(const CameraRig& rig, const BodyModel& model,
                                                 const Eigen::Isometry3d& T_world_body,
                                                 const Eigen::VectorXd& angles) {
  LinkPoses T_world_link;
  model.forwardKinematics(T_world_body, angles, T_world_link);
  std::vector<FleischmannView> views;
  for (const Camera& camera : rig) {
    FleischmannView view;
    view.silhouette = bodySilhouette(model, T_world_link, camera);
    view.image = cv::Mat(view.silhouette.size(), CV_8UC1, cv::Scalar(160));
    view.image.setTo(70, view.silhouette);
    views.push_back(view);
  }
  return views;
}

}  // namespace markerless_mocap
