#include "calibration/origin/world_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <stdexcept>

#include "calibration/start/seen_ahead.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

/// The instant and view of a camera nearest to a time.
const Instant* instantNear(const RigState& state, size_t camera, double time) {
  const Instant* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Instant& instant : state.instants)
    for (const ViewSight& view : instant.views)
      if (instant.located && view.camera == camera && std::abs(view.time - time) < least) {
        least = std::abs(view.time - time);
        nearest = &instant;
      }
  return nearest;
}

/// What a camera sees of the known points, as a pinhole camera would.
struct SeenPoints {
  std::vector<cv::Point3d> places;  ///< m, world
  std::vector<cv::Point2d> pixels;
  cv::Matx33d K = cv::Matx33d::eye();
  cv::Mat D;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< from its frame to the camera's
};

SeenPoints pointsSeen(const RigState& state, size_t camera) {
  SeenPoints seen;
  for (const KnownPoint& point : state.points)
    for (const auto& [seen_by, pixel] : point.pixels)
      if (seen_by == camera) {
        seen.places.emplace_back(point.position.x(), point.position.y(), point.position.z());
        seen.pixels.emplace_back(pixel.x(), pixel.y());
      }
  const Intrinsics& in = state.cameras[camera].intrinsics;
  if (typeOf(state.cameras[camera].lens) == LensType::kPolynomial) {
    seen.K = cv::Matx33d(in[0], 0, in[2], 0, in[1], in[3], 0, 0, 1);
    seen.D = cv::Mat(1, 8, CV_64F, const_cast<double*>(in.data() + 4));
    return seen;
  }
  const AheadView ahead = seenAhead(in, seen.pixels);
  std::vector<cv::Point3d> places;
  for (const size_t i : ahead.seen) places.push_back(seen.places[i]);
  seen.places = places;
  seen.pixels = ahead.pixels;
  seen.turn = ahead.turn;
  return seen;
}

std::optional<Eigen::Isometry3d> poseByPoints(const RigState& state, size_t camera) {
  constexpr size_t kLeast = 4;
  const SeenPoints seen = pointsSeen(state, camera);
  if (seen.places.size() < kLeast) return std::nullopt;
  cv::Mat r, t;
  if (!cv::solvePnP(seen.places, seen.pixels, seen.K, seen.D, r, t, false, cv::SOLVEPNP_SQPNP))
    return std::nullopt;
  cv::solvePnPRefineLM(seen.places, seen.pixels, seen.K, seen.D, r, t);
  PoseVector pose;
  for (int i = 0; i < 3; ++i) {
    pose[i] = r.at<double>(i);
    pose[3 + i] = t.at<double>(i);
  }
  return seen.turn * isometry(pose);
}

/// Cameras of a group hold their views together, so only instants of the group move.
void moveGroup(const std::vector<size_t>& groups, size_t group, const Eigen::Isometry3d& new_old,
               RigState* state) {
  for (size_t i = 0; i < groups.size(); ++i)
    if (groups[i] == group) {
      PoseVector& pose = state->cameras[i].camera_world;
      pose = poseVector(isometry(pose) * new_old.inverse());
    }
  for (Instant& instant : state->instants)
    if (groups[instant.views.front().camera] == group)
      instant.world_board = poseVector(new_old * isometry(instant.world_board));
}

}  // namespace

void moveWorld(const Eigen::Isometry3d& new_old, RigState* state) {
  moveGroup(std::vector<size_t>(state->cameras.size(), 0), 0, new_old, state);
}

void putFloorUnderBoard(size_t camera, double time, double thickness, RigState* state) {
  const Instant* instant = instantNear(*state, camera, time);
  if (!instant) throw std::invalid_argument("the camera that shall show the floor saw no board");
  Eigen::Isometry3d floor = isometry(instant->world_board).inverse();
  floor.pretranslate(Eigen::Vector3d(0, 0, thickness));
  moveWorld(floor, state);
}

void guessFloor(const Board& board, RigState* state) {
  Eigen::Vector3d up = Eigen::Vector3d::Zero(), middle = up;
  for (const CameraState& camera : state->cameras)
    up -= isometry(camera.camera_world).linear().row(1).transpose();
  if (up.norm() < 1e-3) up = Eigen::Vector3d::UnitZ();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = shortestRotation(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  double lowest = std::numeric_limits<double>::infinity(), count = 0;
  for (const Instant& instant : state->instants) {
    if (!instant.located) continue;
    for (const Eigen::Vector2d& corner : board.corners()) {
      const Eigen::Vector3d place =
          T * (isometry(instant.world_board) * Eigen::Vector3d(corner.x(), corner.y(), 0));
      lowest = std::min(lowest, place.z());
      middle += place;
      ++count;
    }
  }
  if (count > 0) T.pretranslate(Eigen::Vector3d(-middle.x() / count, -middle.y() / count, -lowest));
  moveWorld(T, state);
}

std::vector<std::optional<Eigen::Isometry3d>> posesByPoints(const RigState& state) {
  std::vector<std::optional<Eigen::Isometry3d>> poses;
  for (size_t i = 0; i < state.cameras.size(); ++i) poses.push_back(poseByPoints(state, i));
  return poses;
}

void placeByPoints(const std::vector<size_t>& groups, RigState* state) {
  const auto poses = posesByPoints(*state);
  std::vector<bool> placed(groups.size(), false);
  for (size_t i = 0; i < groups.size(); ++i) {
    if (!poses[i] || placed[groups[i]]) continue;
    placed[groups[i]] = true;
    const Eigen::Isometry3d in_group = isometry(state->cameras[i].camera_world);
    moveGroup(groups, groups[i], poses[i]->inverse() * in_group, state);
  }
  for (size_t i = 0; i < groups.size(); ++i) state->cameras[i].located = placed[groups[i]];
}

}  // namespace markerless_mocap
