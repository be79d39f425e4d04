#include "character/skin/skin_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "character/body/smooth_shape.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Shares = Eigen::Array<double, kBoneCount, 1>;

constexpr int kRounds = 8;  ///< of evening out: about three lattice cells wide

/// Shares of the bones at a point of the left half, from how far past each joint it is.
class ShareField {
 public:
  explicit ShareField(const HumanSkeleton& skeleton) : s_(skeleton) {}

  Shares at(const Vector3d& p, Layer layer) const {
    const Vector3d q(p.x(), std::abs(p.y()), p.z());
    Shares shares = Shares::Zero();
    if (layer == Layer::kHair && q.z() < joint(Bone::kHead).z()) {
      shares = hairFall(q);
    } else {
      const double arm = layer == Layer::kSkirt ? 0.0 : armShare(q);
      const double leg = layer == Layer::kSkirt ? skirtShare(q) : legShare(q, layer);
      addTrunk(shares, q, (1.0 - arm) * (1.0 - leg));
      addArm(shares, q, arm);
      addLeg(shares, q, layer, (1.0 - arm) * leg);
    }
    return p.y() < 0.0 ? mirrored(shares) : shares;
  }

 private:
  const Vector3d& joint(Bone bone) const { return s_.headOf(bone); }
  double scaled(double length) const { return length * s_.stature / 1.75; }

  static Shares mirrored(const Shares& shares) {
    Shares other;
    for (int b = 0; b < kBoneCount; ++b) other[int(mirrorOf(Bone(b)))] = shares[b];
    return other;
  }

  /// Beyond a plane from the armpit to the shoulder's top, tilted outwards below.
  double armShare(const Vector3d& q) const {
    const Vector3d& shoulder = joint(Bone::kLeftUpperArm);
    const double height = std::min(q.z() - shoulder.z(), scaled(0.04));
    return ramp(q.y() + 0.5 * height, shoulder.y(), scaled(0.055));
  }

  /// Below the groin, which rises outwards; none between the legs' tops.
  double legShare(const Vector3d& q, Layer layer) const {
    const Vector3d& hip = joint(Bone::kLeftThigh);
    const double groin = hip.z() - scaled(0.02) + 0.6 * (q.y() - hip.y());
    double share = ramp(groin - q.z(), 0.0, scaled(0.07));
    const double crotch = hip.z() - scaled(0.115);
    share *=
        1.0 - (1.0 - ramp(q.y(), scaled(0.02), scaled(0.02))) * ramp(q.z(), crotch, scaled(0.02));
    return layer == Layer::kShirt ? 0.6 * share : share;
  }

  /// A skirt goes with the thighs the more the lower.
  double skirtShare(const Vector3d& q) const {
    const double hip = joint(Bone::kLeftThigh).z();
    return ramp(hip + scaled(0.02) - q.z(), scaled(0.09), scaled(0.13));
  }

  Shares hairFall(const Vector3d& q) const {
    Shares shares = Shares::Zero();
    const double head = ramp(q.z(), joint(Bone::kNeck).z(), scaled(0.12));
    shares[int(Bone::kHead)] = head;
    shares[int(Bone::kChest)] = 1.0 - head;
    return shares;
  }

  void addTrunk(Shares& shares, const Vector3d& q, double share) const {
    const Vector3d &neck = joint(Bone::kNeck), &head = joint(Bone::kHead);
    const Vector3d& shoulder = joint(Bone::kLeftUpperArm);
    const double spine = ramp(q.z(), joint(Bone::kSpine).z(), scaled(0.07));
    const double chest = ramp(q.z(), joint(Bone::kChest).z(), scaled(0.09));
    // The neck's base rises to the back, the jaw belongs to the head.
    const double neck_share =
        ramp(q.z() + 0.5 * (q.x() - neck.x()), neck.z() - scaled(0.015), scaled(0.035));
    const double chin = 1.2 * std::max(q.x() - scaled(0.03), 0.0);
    const double head_share = ramp(q.z() + chin, head.z() - scaled(0.022), scaled(0.035));
    const double collar = ramp(q.y(), scaled(0.08), scaled(0.06)) *
                          ramp(q.z(), shoulder.z() - scaled(0.06), scaled(0.06));
    shares[int(Bone::kHips)] += share * (1.0 - spine);
    shares[int(Bone::kSpine)] += share * spine * (1.0 - chest);
    const double upper = share * chest;
    shares[int(Bone::kLeftClavicle)] += upper * (1.0 - neck_share) * collar;
    shares[int(Bone::kChest)] += upper * (1.0 - neck_share) * (1.0 - collar);
    shares[int(Bone::kNeck)] += upper * neck_share * (1.0 - head_share);
    shares[int(Bone::kHead)] += upper * neck_share * head_share;
  }

  void addArm(Shares& shares, const Vector3d& q, double share) const {
    const double forearm = ramp(q.y(), joint(Bone::kLeftForearm).y(), scaled(0.04));
    const double hand = ramp(q.y(), joint(Bone::kLeftHand).y(), scaled(0.025));
    shares[int(Bone::kLeftUpperArm)] += share * (1.0 - forearm);
    shares[int(Bone::kLeftForearm)] += share * forearm * (1.0 - hand);
    shares[int(Bone::kLeftHand)] += share * forearm * hand;
  }

  void addLeg(Shares& shares, const Vector3d& q, Layer layer, double share) const {
    const Vector3d &ankle = joint(Bone::kLeftFoot), &ball = joint(Bone::kLeftToes);
    if (layer == Layer::kSkirt) {  // between the legs it follows both
      const double left = ramp(q.y(), 0.0, scaled(0.14));
      // Over a bent knee the hem hangs down.
      const double hem =
          0.6 * ramp(joint(Bone::kLeftShank).z() + scaled(0.05) - q.z(), 0.0, scaled(0.10));
      shares[int(Bone::kLeftThigh)] += share * (1.0 - hem) * left;
      shares[int(Bone::kRightThigh)] += share * (1.0 - hem) * (1.0 - left);
      shares[int(Bone::kLeftShank)] += share * hem * left;
      shares[int(Bone::kRightShank)] += share * hem * (1.0 - left);
      return;
    }
    const double shank = ramp(joint(Bone::kLeftShank).z() - q.z(), 0.0, scaled(0.05));
    const double instep = 0.4 * (q.x() - ankle.x());
    double foot = ramp(ankle.z() + instep - q.z(), 0.0, scaled(0.03)) * shank;
    if (layer == Layer::kTrousers) foot *= 0.2;
    const double toes = ramp(q.x(), ball.x(), scaled(0.025));
    shares[int(Bone::kLeftThigh)] += share * (1.0 - shank);
    shares[int(Bone::kLeftShank)] += share * (shank - foot);
    shares[int(Bone::kLeftFoot)] += share * foot * (1.0 - toes);
    shares[int(Bone::kLeftToes)] += share * foot * toes;
  }

  const HumanSkeleton& s_;
};

void evenOut(std::vector<Shares>& shares, const Surface& surface) {
  std::vector<Shares> sums(shares.size());
  std::vector<int> counts(shares.size(), 0);
  for (const std::array<int, 4>& quad : surface.quads)
    for (int v : quad) ++counts[size_t(v)];
  for (int round = 0; round < kRounds; ++round) {
    std::fill(sums.begin(), sums.end(), Shares::Zero());
    for (const std::array<int, 4>& quad : surface.quads)
      for (size_t i = 0; i < 4; ++i) sums[size_t(quad[i])] += shares[size_t(quad[(i + 1) % 4])];
    for (size_t v = 0; v < shares.size(); ++v) shares[v] = 0.5 * (shares[v] + sums[v] / counts[v]);
  }
}

VertexWeights fourLargest(const Shares& shares) {
  std::array<int, kBoneCount> order;
  std::iota(order.begin(), order.end(), 0);
  std::partial_sort(order.begin(), order.begin() + 4, order.end(), [&](int a, int b) {
    return shares[a] != shares[b] ? shares[a] > shares[b] : a < b;
  });
  double sum = 0.0;
  for (size_t k = 0; k < 4; ++k) sum += shares[order[k]];
  VertexWeights weights;
  for (size_t k = 0; k < 4; ++k) {
    weights.bones[k] = Bone(order[k]);
    weights.weights[k] = float(shares[order[k]] / sum);
  }
  return weights;
}

}  // namespace

std::vector<VertexWeights> skinWeights(const HumanSkeleton& skeleton, const Surface& surface,
                                       const std::vector<Layer>& layers) {
  const ShareField field(skeleton);
  std::vector<Shares> shares;
  for (size_t v = 0; v < surface.vertices.size(); ++v)
    shares.push_back(field.at(surface.vertices[v], layers[v]));
  evenOut(shares, surface);
  std::vector<VertexWeights> weights;
  for (const Shares& vertex : shares) weights.push_back(fourLargest(vertex));
  return weights;
}

}  // namespace markerless_mocap
