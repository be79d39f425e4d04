#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "calibration/calibrate.h"

namespace markerless_mocap {

/// A board that is waved amid a ring of cameras, and its corners in their images.
class BoardScene {
 public:
  BoardOptions board;
  std::vector<CameraCalibration> cameras;
  std::vector<double> offsets;  ///< s, to be added to each camera's clock
  double rate = 10.0;           ///< views per second
  double noise = 0.3;           ///< pixels
  int loose = -1;               ///< camera that turns
  double loose_from = 1e9;      ///< s
  double loose_angle = 0.006;   ///< rad
  unsigned seed = 1;

  BoardScene() {
    board.columns = 8;
    board.rows = 6;
    board.square = 0.1;
    board.marker = 0.075;
  }

  /// Cameras of 1280 x 960 at 2.0 m and 2.8 m height on a ring that look at its middle.
  void addRing(int count, double radius = 3.5) {
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * i / count + 0.2;
      CameraCalibration camera;
      camera.name = "cam" + std::to_string(i);
      camera.width = 1280;
      camera.height = 960;
      camera.K << 900 + 10 * i, 0, 640 + 3 * i, 0, 905 + 10 * i, 470 - 2 * i, 0, 0, 1;
      camera.D = {-0.2, 0.06, 0.001, -0.0005};
      const Eigen::Vector3d place(radius * std::cos(angle), radius * std::sin(angle),
                                  i % 2 ? 2.8 : 2.0);
      const Eigen::Vector3d forward = (Eigen::Vector3d(0, 0, 0.8) - place).normalized();
      const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
      camera.T_world_camera.linear() << right, forward.cross(right), forward;
      camera.T_world_camera.translation() = place;
      cameras.push_back(camera);
      offsets.push_back(0.0);
    }
  }

  /// Pose of the board, which turns to all sides while it is carried about.
  static Eigen::Isometry3d boardAt(double t) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() << 1.8 * std::sin(0.61 * t), 1.8 * std::cos(0.47 * t),
        1.0 + 0.8 * std::sin(0.83 * t);
    T.linear() = (Eigen::AngleAxisd(0.55 * t, Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(0.6 + 0.5 * std::sin(0.9 * t), Eigen::Vector3d::UnitX()) *
                  Eigen::AngleAxisd(0.5 * std::sin(0.7 * t), Eigen::Vector3d::UnitZ()))
                     .toRotationMatrix();
    T.translate(Eigen::Vector3d(-0.4, -0.3, 0));
    return T;
  }

  /// Views of all cameras over some seconds; a camera sees the board from in front only.
  CalibrationInput input(double seconds) const {
    CalibrationInput input;
    input.board = board;
    for (const CameraCalibration& camera : cameras)
      input.cameras.push_back({camera.name, camera.width, camera.height, {}});
    std::mt19937 random(seed);
    for (size_t i = 0; i < cameras.size(); ++i)
      for (int k = 0; k < int(seconds * rate); ++k)
        if (auto view = viewAt(i, k / rate, boardAt(k / rate + offsets[i]), &random))
          input.views.push_back(*view);
    return input;
  }

  /// \param time s, clock of the camera
  std::optional<BoardView> viewAt(size_t index, double time, const Eigen::Isometry3d& world_board,
                                  std::mt19937* random) const {
    CameraCalibration calibration = cameras[index];
    if (int(index) == loose && time >= loose_from)
      calibration.T_world_camera.rotate(
          Eigen::AngleAxisd(loose_angle, Eigen::Vector3d(1, 1, 0).normalized()));
    const Camera camera(calibration);
    const Eigen::Vector3d centre = world_board * Eigen::Vector3d(board.columns * board.square / 2,
                                                                 board.rows * board.square / 2, 0);
    const Eigen::Vector3d towards = (camera.position() - centre).normalized();
    if (world_board.linear().col(2).dot(towards) < 0.35) return std::nullopt;
    std::normal_distribution<double> error(0.0, noise);
    BoardView view;
    view.camera = index;
    view.time = time;
    const Board places(board);
    for (size_t id = 0; id < places.corners().size(); ++id) {
      const Eigen::Vector2d& corner = places.corners()[id];
      const auto pixel =
          camera.projectInside(world_board * Eigen::Vector3d(corner.x(), corner.y(), 0));
      if (!pixel) continue;
      view.corners.ids.push_back(int(id));
      const double u = pixel->x() + error(*random), v = pixel->y() + error(*random);
      view.corners.pixels.emplace_back(u, v);
    }
    if (view.corners.ids.size() < 12) return std::nullopt;
    return view;
  }
};

/// How the estimated cameras lie against the true ones, both relative to the mean of all cameras.
struct RigError {
  std::vector<Eigen::Vector3d> position;   ///< m, along the axes of each camera
  std::vector<Eigen::Vector3d> direction;  ///< rad, about the axes of each camera

  double largestPosition() const { return largest(position); }
  double largestDirection() const { return largest(direction); }

 private:
  static double largest(const std::vector<Eigen::Vector3d>& errors) {
    double most = 0;
    for (const Eigen::Vector3d& error : errors) most = std::max(most, error.norm());
    return most;
  }
};

/// Errors after the rigid motion of the whole rig that makes them least: metres and radians count
/// alike, as in uncertaintiesOf().
inline RigError rigError(const RigCalibration& result,
                         const std::vector<CameraCalibration>& truth) {
  const size_t n = truth.size();
  Eigen::Isometry3d true_found = Eigen::Isometry3d::Identity();
  RigError error;
  for (int round = 0; round < 10; ++round) {
    Eigen::MatrixXd G(6 * n, 6);
    Eigen::VectorXd e(6 * n);
    for (size_t i = 0; i < n; ++i) {
      // The found camera in the frame of the true one.
      const Eigen::Isometry3d left = truth[i].T_world_camera.inverse() * true_found *
                                     result.cameras[i].calibration.T_world_camera;
      const Eigen::AngleAxisd turn(left.linear());
      e.segment<3>(6 * i) = left.translation();
      e.segment<3>(6 * i + 3) = turn.angle() * turn.axis();
      const Eigen::Matrix3d R = truth[i].T_world_camera.linear().transpose();
      const Eigen::Vector3d c = truth[i].T_world_camera.translation();
      Eigen::Matrix3d c_cross;
      c_cross << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
      G.block<3, 3>(6 * i, 0) = R;
      G.block<3, 3>(6 * i, 3) = -R * c_cross;
      G.block<3, 3>(6 * i + 3, 0).setZero();
      G.block<3, 3>(6 * i + 3, 3) = R;
    }
    // From the first camera's frame only a start; then least squares.
    if (round == 0) {
      true_found = truth[0].T_world_camera * result.cameras[0].calibration.T_world_camera.inverse();
      continue;
    }
    error = {};
    for (size_t i = 0; i < n; ++i) {
      error.position.push_back(e.segment<3>(6 * i));
      error.direction.push_back(e.segment<3>(6 * i + 3));
    }
    const Eigen::VectorXd step = -(G.transpose() * G).ldlt().solve(G.transpose() * e);
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    const Eigen::Vector3d turn = step.tail<3>();
    if (turn.norm() > 0)
      moved.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    moved.translation() = step.head<3>();
    true_found = moved * true_found;
  }
  return error;
}

}  // namespace markerless_mocap
