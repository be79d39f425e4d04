#include "calibration/start/seen_ahead.h"

#include <Eigen/Geometry>

#include "camera/lens_distortion.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {

AheadView seenAhead(const Intrinsics& in, const std::vector<cv::Point2d>& pixels) {
  constexpr double kBeside = 0.1;  // least cosine to the middle
  CameraCalibration calibration;
  setIntrinsics(in, LensModel::kFisheye, &calibration);
  const LensNumbers lens = lensNumbersOf(calibration);
  std::vector<Eigen::Vector3d> rays;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const cv::Point2d& pixel : pixels) {
    rays.push_back(
        undistortedDirection(lens, {(pixel.x - in[2]) / in[0], (pixel.y - in[3]) / in[1]})
            .normalized());
    middle += rays.back();
  }
  AheadView view;
  view.turn = shortestRotation(Eigen::Vector3d::UnitZ(), middle).toRotationMatrix();
  for (size_t i = 0; i < rays.size(); ++i) {
    const Eigen::Vector3d turned = view.turn.transpose() * rays[i];
    if (!(turned.z() > kBeside)) continue;
    view.pixels.emplace_back(turned.x() / turned.z(), turned.y() / turned.z());
    view.seen.push_back(i);
  }
  return view;
}

}  // namespace markerless_mocap
