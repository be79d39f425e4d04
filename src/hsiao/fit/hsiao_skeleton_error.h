#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "hsiao/model/hsiao_body_model.h"
#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// Row: part of the data; column: part of the model; both by PartLabel.
using PartMatrix = Eigen::Matrix<double, kPartCount, kPartCount>;
/// Model part of each data part; -1 for a data part left out.
using PartAssignment = std::array<int, kPartCount>;

/// Fingers are too thin for most hulls: an arm's curve ends about this share of the arm before
/// their tips.
constexpr double kFingerShare = 0.145;

/// The smaller of the two pairings (same order, reversed) of summed distances, per point
/// (Hsiao 2008, Eq. 3-27). Both hold `count` > 0 points.
double pairedDistance(const Eigen::Vector3d* a, const Eigen::Vector3d* b, int count);

/// One-to-one assignment of data parts to model parts with the least sum. Infinite entries are
/// forbidden; a data part whose entries are all infinite is left out.
PartAssignment assignParts(const PartMatrix& error);

/// The evaluation function of Hsiao 2008, 3.2.2.1, for one instant's part curves.
///
/// A limb's or head's curve is laid along the bones from the tip, as far as it reaches: where a
/// curve begins at the torso depends on how the hull was cut, where it ends does not. The middle of
/// the torso's curve is laid on its bone and may slide along it a little. Only parts of one kind
/// are paired (head to head, arms among arms), since the data parts are labelled.
class HsiaoSkeletonError {
 public:
  /// \param samples points per part, at least 2
  /// Parts that are not seen or have fewer than two points are left out, and but for legs those
  /// that are not whole.
  HsiaoSkeletonError(const HsiaoBodyModel& profile, const BodyParts& parts, int samples);

  bool has(PartLabel part) const { return !data_[size_t(part)].empty(); }
  /// Sampled points of a data part, metres, from the torso to the tip.
  const std::vector<Eigen::Vector3d>& samples(PartLabel part) const { return data_[size_t(part)]; }

  /// The sample of a seen limb that lies where the bones' node `n` should be.
  const Eigen::Vector3d& atNode(PartLabel part, int n) const;

  /// The model's counterparts of samples(data) on the bones of `model`, a part of the same kind.
  void modelSamples(const HsiaoFrames& frames, PartLabel data, PartLabel model,
                    std::vector<Eigen::Vector3d>& out) const;

  /// Errors of all pairs, metres; infinite where a pair is not allowed or not active.
  PartMatrix matrix(const HsiaoFrames& frames, const std::array<bool, kPartCount>& active) const;

  /// Mean over the active seen parts of the assigned errors, metres; 0 if there is none.
  double operator()(const HsiaoFrames& frames, const std::array<bool, kPartCount>& active) const;

 private:
  struct BoneSample {
    int bone;      // from node `bone` to the next
    double share;  // of its length
  };
  using BoneSamples = std::vector<BoneSample>;
  void take(PartLabel part, const std::vector<Eigen::Vector3d>& curve, int samples);

  const HsiaoBodyModel* profile_;
  std::array<std::vector<Eigen::Vector3d>, kPartCount> data_;
  std::array<BoneSamples, kPartCount> on_bones_;  // by data part; left and right bones are alike
};

}  // namespace markerless_mocap
