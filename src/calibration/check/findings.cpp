#include "calibration/check/findings.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

/// Part of the image's 8 x 8 cells in which a corner was seen.
double coverageOf(const CalibratedCamera& camera) {
  constexpr int kCells = 8;
  std::set<int> seen;
  for (const ViewError& view : camera.views)
    for (const CornerError& corner : view.corners) {
      const int x = int(corner.pixel.x() * kCells / camera.calibration.width);
      const int y = int(corner.pixel.y() * kCells / camera.calibration.height);
      seen.insert(std::clamp(y, 0, kCells - 1) * kCells + std::clamp(x, 0, kCells - 1));
    }
  return double(seen.size()) / (kCells * kCells);
}

ViewError errorOf(const Board& board, const RigState& state, const Instant& instant,
                  const ViewSight& view) {
  ViewError error;
  error.instant = instant.time;
  error.time = view.time;
  error.used = view.used;
  double sum = 0;
  for (const CornerSight& corner : view.corners) {
    const Eigen::Vector2d r = residualOf(state, board, instant, view, corner);
    error.corners.push_back({corner.pixel, r, corner.used && view.used});
    sum += r.squaredNorm();
  }
  error.rms = instant.located ? std::sqrt(sum / double(view.corners.size())) : NAN;
  return error;
}

/// Sums of squares over the corners used.
struct SquareSum {
  double sum = 0.0;
  int count = 0;

  void add(const ViewError& view) {
    if (!std::isfinite(view.rms)) return;
    for (const CornerError& corner : view.corners)
      if (corner.used) {
        sum += corner.residual.squaredNorm();
        ++count;
      }
  }
  double rms() const { return count == 0 ? 0.0 : std::sqrt(sum / count); }
};

double rmsOfPoints(const RigState& state) {
  double sum = 0;
  int count = 0;
  for (const KnownPoint& point : state.points)
    for (const auto& [index, pixel] : point.pixels) {
      const CameraState& camera = state.cameras[index];
      Eigen::Vector2d r;
      PointResidual{point.position, pixel, typeOf(camera.lens)}(
          camera.intrinsics.data(), camera.camera_world.data(), r.data());
      sum += r.squaredNorm();
      ++count;
    }
  return count == 0 ? 0.0 : std::sqrt(sum / count);
}

CalibratedCamera cameraOf(const CameraToCalibrate& camera, const CameraState& state) {
  CalibratedCamera out;
  out.calibration.name = camera.name;
  out.calibration.width = camera.width;
  out.calibration.height = camera.height;
  setIntrinsics(state.intrinsics, state.lens, &out.calibration);
  out.calibration.T_world_camera = isometry(state.camera_world).inverse();
  out.lens = state.lens;
  out.time_offset = state.time_offset;
  return out;
}

}  // namespace

RigCalibration summarise(const Board& board, const CalibrationInput& input, const RigState& state) {
  RigCalibration result;
  for (size_t i = 0; i < state.cameras.size(); ++i)
    result.cameras.push_back(cameraOf(input.cameras[i], state.cameras[i]));
  for (const Instant& instant : state.instants) {
    result.instants += instant.located;
    for (const ViewSight& view : instant.views) {
      result.cameras[view.camera].views.push_back(errorOf(board, state, instant, view));
      result.cameras[view.camera].views.back().alone = input.views[view.view].alone;
    }
  }
  SquareSum all;
  for (CalibratedCamera& camera : result.cameras) {
    std::sort(camera.views.begin(), camera.views.end(),
              [](const ViewError& a, const ViewError& b) { return a.time < b.time; });
    SquareSum own;
    for (const ViewError& view : camera.views) {
      own.add(view);
      all.add(view);
    }
    camera.rms = own.rms();
    camera.coverage = coverageOf(camera);
  }
  result.rms = all.rms();
  result.points_rms = rmsOfPoints(state);
  result.floor_known = input.floor.has_value() || !input.points.empty();
  return result;
}

double middleOffset(const RigCalibration& result) {
  std::vector<double> offsets;
  for (const CalibratedCamera& camera : result.cameras) offsets.push_back(camera.time_offset);
  return medianOf(offsets);
}

void keepOffsets(RigCalibration* result) {
  const double middle = middleOffset(*result);
  for (CalibratedCamera& camera : result->cameras)
    camera.calibration.time_offset = camera.time_offset - middle;
}

void putFloorUnderWalk(const CalibrationInput& input, RigCalibration* result) {
  CameraRig cameras;
  std::vector<double> offsets;
  for (const CalibratedCamera& camera : result->cameras) {
    cameras.emplace_back(camera.calibration);
    offsets.push_back(camera.time_offset);
  }
  result->walk = floorFromWalk(cameras, input.walk(offsets));
  result->floor_known = true;
  for (CalibratedCamera& camera : result->cameras) {
    Eigen::Isometry3d& pose = camera.calibration.T_world_camera;
    pose = result->walk->new_old * pose;
    pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  }
}

}  // namespace markerless_mocap
