#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/adjust/rig_state.h"

namespace markerless_mocap {

// Parameters of a camera: translation and rotation of its frame (in its own axes), intrinsics,
// time.
constexpr int kPose = 0, kIntrinsics = 6, kTime = 18, kPerCamera = 19;

/// One instant without the pose of its board: what it says of the cameras that saw it.
struct InstantPart {
  std::vector<int> at;  ///< parameters
  Eigen::MatrixXd normal;
  Eigen::VectorXd gradient;
};

/// One known point in one image.
struct PointPart {
  int at = 0;  ///< first parameter of its camera
  Eigen::Matrix<double, 2, kPerCamera> slopes;
  double squares = 0.0;   ///< square pixels
  double weight = 1.0;    ///< of the robust loss
  double variance = 1.0;  ///< square pixels
  bool stated = false;    ///< the variance
};

/// The normal equations of the cameras, the boards' poses eliminated, in units of the variance of
/// a corner's coordinate, and what each instant gives to them.
class RigNormalEquations {
 public:
  /// \param free the parameters that were estimated; board and state must outlive this
  RigNormalEquations(const Board& board, const RigState& state, const std::vector<int>& free);

  /// Square pixels, of a coordinate of a corner.
  double cornerVariance() const { return variance_; }

  /// Square pixels, of points that state none. The guess of one pixel counts as two residuals, so
  /// that few points that happen to fit are not believed. Source: Helmert's estimate of variance
  /// components.
  double pointVariance() const;

  /// Square pixels: variance of corners that, were they independent, let the axes of the lenses be
  /// as uncertain as they are.
  double viewVariance() const;

  /// Covariance of the free parameters; rows and columns of the others are 0. With enough instants
  /// their scatter counts, so that errors which a view's corners share do.
  Eigen::MatrixXd covariance() const;

 private:
  struct Slopes {
    Eigen::Vector2d residual;
    Eigen::Matrix<double, 2, kPerCamera> camera;
    Eigen::Matrix<double, 2, 6> board;
    double weight;
  };

  void addInstant(const Instant& instant);
  Slopes slopesAt(const Instant& instant, const ViewSight& view, const CornerSight& corner) const;
  void addPoint(const KnownPoint& point);
  /// What is known of a lens without views. Coefficients that the chosen model leaves at 0 may be
  /// as large as in common lenses, so far as the views allow it.
  void addPriors(int index);
  void invert();

  const Board& board_;
  const RigState& state_;
  int size_;
  std::vector<int> free_;
  Eigen::MatrixXd normal_;         ///< of the corners
  Eigen::MatrixXd known_;          ///< of points and priors
  Eigen::VectorXd known_scatter_;  ///< of priors, beyond that of corners
  Eigen::MatrixXd covariance_;     ///< if all corners are independent
  std::vector<InstantPart> instants_;
  std::vector<PointPart> points_;
  double squares_ = 0.0, residuals_ = 0.0, variance_ = 0.0;
};

}  // namespace markerless_mocap
