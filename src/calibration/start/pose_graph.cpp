#include "calibration/start/pose_graph.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <map>

namespace markerless_mocap {
namespace {

constexpr double kAngle = 3.0 * M_PI / 180;  // within which relative poses agree

/// Half a turn about the middle of the board.
Eigen::Isometry3d halfTurn(const Board& board) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear().diagonal() << -1, -1, 1;
  T.translation() << 2 * board.centre(), 0;
  return T;
}

struct Candidate {
  Eigen::Isometry3d pose;
  double distance;  ///< m, from the cameras to the board
  size_t instant;
};

bool agree(const Candidate& one, const Candidate& other) {
  const double angle =
      Eigen::AngleAxisd(one.pose.linear().transpose() * other.pose.linear()).angle();
  const double apart = (one.pose.translation() - other.pose.translation()).norm();
  return angle < kAngle && apart < 0.01 + 0.05 * std::max(one.distance, other.distance);
}

Eigen::Isometry3d meanPose(const std::vector<const Candidate*>& candidates) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Isometry3d mean = Eigen::Isometry3d::Identity();
  for (const Candidate* one : candidates) {
    sum += one->pose.linear();
    mean.translation() += one->pose.translation() / double(candidates.size());
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  mean.linear() = svd.matrixU() * svd.matrixV().transpose();
  return mean;
}

/// The mean of the candidates near the one that most others are near to.
void settle(const std::vector<Candidate>& candidates, CameraPair* pair) {
  std::vector<const Candidate*> most;
  for (const Candidate& one : candidates) {
    std::vector<const Candidate*> near;
    for (const Candidate& other : candidates)
      if (agree(one, other)) near.push_back(&other);
    if (near.size() > most.size()) most = near;
  }
  pair->agreeing = int(most.size());
  pair->a_b = meanPose(most);
}

const ViewSight* viewOf(const Instant& instant, size_t camera) {
  for (const ViewSight& view : instant.views)
    if (view.camera == camera && view.used) return &view;
  return nullptr;
}

CameraPair pairOf(const Board& board, const RigState& state, const std::vector<BoardPose>& poses,
                  size_t a, size_t b) {
  CameraPair pair;
  pair.a = a;
  pair.b = b;
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < state.instants.size(); ++i) {
    const ViewSight* in_a = viewOf(state.instants[i], a);
    const ViewSight* in_b = viewOf(state.instants[i], b);
    if (!in_a || !in_b || !std::isfinite(poses[in_a->view].rms + poses[in_b->view].rms)) continue;
    ++pair.shared;
    const Eigen::Isometry3d &A = poses[in_a->view].camera_board,
                            &B = poses[in_b->view].camera_board;
    const double distance = std::max(A.translation().norm(), B.translation().norm());
    candidates.push_back({A * B.inverse(), distance, i});
    if (board.looksSameTurned())
      candidates.push_back({A * halfTurn(board) * B.inverse(), distance, i});
  }
  if (!candidates.empty()) settle(candidates, &pair);
  return pair;
}

/// Mean distance of a view's corners from where a pose of the board puts them, pixels.
double meanError(const RigState& state, const Board& board, const Instant& instant,
                 const ViewSight& view) {
  double sum = 0;
  for (const CornerSight& corner : view.corners) {
    const double error = residualOf(state, board, instant, view, corner).norm();
    sum += std::isfinite(error) ? error : 1e6;
  }
  return sum / double(view.corners.size());
}

void turnLikeTheFirst(const RigState& state, const Board& board, const Instant& instant,
                      ViewSight* view) {
  ViewSight turned = *view;
  const int last = int(board.corners().size()) - 1;
  for (CornerSight& corner : turned.corners) corner.id = last - corner.id;
  if (meanError(state, board, instant, turned) < meanError(state, board, instant, *view))
    *view = turned;
}

/// Pose of the board by the view that shows most of it.
void placeBoard(const Board& board, const std::vector<BoardPose>& poses, const RigState& state,
                Instant* instant) {
  const ViewSight* best = nullptr;
  for (const ViewSight& view : instant->views)
    if (std::isfinite(poses[view.view].rms) &&
        (!best || view.corners.size() > best->corners.size()))
      best = &view;
  instant->located = best != nullptr;
  if (!best) return;
  const Eigen::Isometry3d camera_world = isometry(state.cameras[best->camera].camera_world);
  instant->world_board = poseVector(camera_world.inverse() * poses[best->view].camera_board);
  if (!board.looksSameTurned()) return;
  for (ViewSight& view : instant->views)
    if (&view != best) turnLikeTheFirst(state, board, *instant, &view);
}

size_t largestGroup(const std::vector<size_t>& groups) {
  std::map<size_t, int> sizes;
  for (const size_t group : groups) ++sizes[group];
  return std::max_element(sizes.begin(), sizes.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

std::vector<CameraPair> cameraPairs(const Board& board, const RigState& state,
                                    const std::vector<BoardPose>& poses) {
  std::vector<CameraPair> pairs;
  for (size_t a = 0; a < state.cameras.size(); ++a)
    for (size_t b = a + 1; b < state.cameras.size(); ++b) {
      const CameraPair pair = pairOf(board, state, poses, a, b);
      if (pair.shared > 0) pairs.push_back(pair);
    }
  return pairs;
}

std::vector<size_t> placeCameras(const Board& board, const std::vector<CameraPair>& pairs,
                                 const std::vector<BoardPose>& poses, RigState* state) {
  const size_t cameras = state->cameras.size();
  std::vector<Link> links;
  for (const CameraPair& pair : pairs) links.push_back({pair.a, pair.b, double(pair.agreeing)});
  std::vector<size_t> groups = groupsOf(cameras, links);
  const size_t largest = largestGroup(groups);
  for (size_t group = 0; group < cameras; ++group) {
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) continue;
    const size_t root = strongestNode(links, groups, group);
    state->cameras[root].camera_world.setZero();
    for (const TreeStep& step : spanningTree(cameras, links, root)) {
      const CameraPair& pair = pairs[step.link];
      const Eigen::Isometry3d child_parent = pair.a == step.child ? pair.a_b : pair.a_b.inverse();
      state->cameras[step.child].camera_world =
          poseVector(child_parent * isometry(state->cameras[step.parent].camera_world));
    }
  }
  for (size_t i = 0; i < cameras; ++i) state->cameras[i].located = groups[i] == largest;
  placeBoards(board, poses, state);
  return groups;
}

void placeBoards(const Board& board, const std::vector<BoardPose>& poses, RigState* state) {
  for (Instant& instant : state->instants) placeBoard(board, poses, *state, &instant);
}

}  // namespace markerless_mocap
