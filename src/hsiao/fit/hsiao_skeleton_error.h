#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "hsiao/model/hsiao_body_model.h"
#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// Rows: parts of the data; columns: parts of the model; both by PartLabel.
using PartMatrix = Eigen::Matrix<double, kPartCount, kPartCount>;
/// Model part of each data part; -1 for a data part that is left out.
using PartAssignment = std::array<int, kPartCount>;

/// Fingers are too thin for most hulls: the curve of an arm ends before the finger tips by about
/// this fraction of the arm.
constexpr double kFingerShare = 0.145;

/// Mean distance of two point lists, the minimum over the two orders (same, reversed) (Hsiao 2008,
/// Eq. 3-27). Both hold `count` > 0 points.
double pairedDistance(const Eigen::Vector3d* a, const Eigen::Vector3d* b, int count);

/// One-to-one assignment of data parts to model parts with minimum sum. Infinite entries are not
/// allowed; a data part whose entries are all infinite is left out.
PartAssignment assignParts(const PartMatrix& error);

/// The evaluation function of Hsiao 2008, 3.2.2.1, for the part curves of one frame.
///
/// The curve of a limb or of the head is aligned with the bones from its outer end, because its
/// start at the torso depends on the segmentation, while its outer end does not. The middle of the
/// torso's curve is aligned with its bone and may slide along it by a small distance. Only parts of
/// the same kind are paired (head with head, arms with arms), since the data parts are labelled.
/// As published, whole curves are compared with whole parts, and any part is paired with any.
class HsiaoSkeletonError {
 public:
  /// \param samples points per part, at least 2. Parts that are not seen or have fewer than two
  ///   points are left out, and so are arms and heads that are not whole.
  HsiaoSkeletonError(const HsiaoBodyModel& body_model, const BodyParts& parts, int samples,
                     bool as_published = false);

  bool has(PartLabel part) const { return !data_[size_t(part)].empty(); }
  /// Sampled points of a data part, metres, from the torso outward.
  const std::vector<Eigen::Vector3d>& samples(PartLabel part) const { return data_[size_t(part)]; }

  /// The sample of a seen limb at the expected position of node `n` of the bones.
  const Eigen::Vector3d& atNode(PartLabel part, int n) const;

  /// The points on the bones of the part `model` that correspond to samples(data).
  void modelSamples(const HsiaoFrames& frames, PartLabel data, PartLabel model,
                    std::vector<Eigen::Vector3d>& out) const;

  /// Errors of all pairs, metres; infinite if a pair is not allowed or not active.
  PartMatrix matrix(const HsiaoFrames& frames, const std::array<bool, kPartCount>& active) const;

  /// Mean of the assigned errors over the active, seen parts, metres; 0 if there is none.
  double operator()(const HsiaoFrames& frames, const std::array<bool, kPartCount>& active) const;

 private:
  struct BoneSample {
    int bone;         // between node `bone` and the next one
    double fraction;  // of its length, from node `bone`
  };
  using BoneSamples = std::vector<BoneSample>;
  void setCurve(PartLabel part, const std::vector<Eigen::Vector3d>& curve, int samples);
  void setWholeCurve(PartLabel part, const std::vector<Eigen::Vector3d>& curve, int samples);
  void sampleWholeBones(PartLabel part, int samples);
  bool canPair(int data, int model, const std::array<bool, kPartCount>& active) const;

  const HsiaoBodyModel* body_model_;
  bool as_published_;
  std::array<std::vector<Eigen::Vector3d>, kPartCount> data_;
  std::array<BoneSamples, kPartCount> on_bones_;  // by data part, as left and right bones have the
                                                  // same lengths; as published: by model part
};

}  // namespace markerless_mocap
