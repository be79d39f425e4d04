#pragma once

#include <Eigen/Core>
#include <cmath>
#include <deque>
#include <limits>

/// The place between a and b that is nearest to the origin.
inline Eigen::Vector3d nearestToOrigin(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d way = b - a;
  const double share = way.squaredNorm() > 0 ? -a.dot(way) / way.squaredNorm() : 0.0;
  return a + std::fmin(std::fmax(share, 0.0), 1.0) * way;
}

/// \param distance m, certain \param speed towards the robot, m/s, NaN if not known
/// \return s, infinite if the distance does not decrease, NaN if that is not known
inline double timeToContact(double distance, double speed) {
  if (std::isnan(distance) || std::isnan(speed)) return std::numeric_limits<double>::quiet_NaN();
  if (!(speed > 0)) return std::numeric_limits<double>::infinity();
  return std::fmax(0.0, distance) / speed;
}

/// How fast a distance decreases: slope of the line through what was measured in the last 0.15 s.
class ClosingSpeed {
 public:
  /// \param time s \param distance m \return m/s, NaN as long as less than 0.06 s were measured
  double add(double time, double distance) {
    samples_.emplace_back(time, distance);
    while (time - samples_.front().x() > kWindow) samples_.pop_front();
    if (time - samples_.front().x() < kLeast) return std::numeric_limits<double>::quiet_NaN();
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& sample : samples_) mean += sample / double(samples_.size());
    double products = 0.0, squares = 0.0;
    for (const Eigen::Vector2d& sample : samples_) {
      products += (sample.x() - mean.x()) * (sample.y() - mean.y());
      squares += (sample.x() - mean.x()) * (sample.x() - mean.x());
    }
    return -products / squares;
  }

 private:
  static constexpr double kWindow = 0.15, kLeast = 0.06;
  std::deque<Eigen::Vector2d> samples_;
};
