#include "character/skin/skin_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "character/body/signed_distance.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using WeightVector = Eigen::Array<double, kBoneCount, 1>;

constexpr int kRounds = 8;  ///< rounds of smoothing; about three lattice cells wide

/// Weights of the bones at a point of the left half, from its position relative to each joint.
class WeightField {
 public:
  explicit WeightField(const HumanSkeleton& skeleton) : s_(skeleton) {}

  WeightVector at(const Vector3d& p, Layer layer) const {
    const Vector3d q(p.x(), std::abs(p.y()), p.z());
    WeightVector bone_weights = WeightVector::Zero();
    if (layer == Layer::kHair && q.z() < joint(Bone::kHead).z()) {
      bone_weights = hairFall(q);
    } else {
      const double arm = layer == Layer::kSkirt ? 0.0 : armWeight(q);
      const double leg = layer == Layer::kSkirt ? skirtWeight(q) : legWeight(q, layer);
      addTrunk(bone_weights, q, (1.0 - arm) * (1.0 - leg));
      addArm(bone_weights, q, arm);
      addLeg(bone_weights, q, layer, (1.0 - arm) * leg);
    }
    return p.y() < 0.0 ? mirrored(bone_weights) : bone_weights;
  }

 private:
  const Vector3d& joint(Bone bone) const { return s_.headOf(bone); }
  double scaled(double length) const { return length * s_.stature / 1.75; }

  static WeightVector mirrored(const WeightVector& bone_weights) {
    WeightVector other;
    for (int b = 0; b < kBoneCount; ++b) other[int(mirrorOf(Bone(b)))] = bone_weights[b];
    return other;
  }

  /// Weight beyond a plane from the armpit to the top of the shoulder, tilted outwards below.
  double armWeight(const Vector3d& q) const {
    const Vector3d& shoulder = joint(Bone::kLeftUpperArm);
    const double height = std::min(q.z() - shoulder.z(), scaled(0.04));
    return ramp(q.y() + 0.5 * height, shoulder.y(), scaled(0.055));
  }

  /// Weight below the groin, which rises outwards; 0 between the tops of the legs.
  double legWeight(const Vector3d& q, Layer layer) const {
    const Vector3d& hip = joint(Bone::kLeftThigh);
    const double groin = hip.z() - scaled(0.02) + 0.6 * (q.y() - hip.y());
    double fraction = ramp(groin - q.z(), 0.0, scaled(0.07));
    const double crotch = hip.z() - scaled(0.115);
    fraction *=
        1.0 - (1.0 - ramp(q.y(), scaled(0.02), scaled(0.02))) * ramp(q.z(), crotch, scaled(0.02));
    return layer == Layer::kShirt ? 0.6 * fraction : fraction;
  }

  /// Weight of the thighs on a skirt; it increases downwards.
  double skirtWeight(const Vector3d& q) const {
    const double hip = joint(Bone::kLeftThigh).z();
    return ramp(hip + scaled(0.02) - q.z(), scaled(0.09), scaled(0.13));
  }

  WeightVector hairFall(const Vector3d& q) const {
    WeightVector bone_weights = WeightVector::Zero();
    const double head = ramp(q.z(), joint(Bone::kNeck).z(), scaled(0.12));
    bone_weights[int(Bone::kHead)] = head;
    bone_weights[int(Bone::kChest)] = 1.0 - head;
    return bone_weights;
  }

  void addTrunk(WeightVector& bone_weights, const Vector3d& q, double fraction) const {
    const Vector3d &neck = joint(Bone::kNeck), &head = joint(Bone::kHead);
    const Vector3d& shoulder = joint(Bone::kLeftUpperArm);
    const double spine = ramp(q.z(), joint(Bone::kSpine).z(), scaled(0.07));
    const double chest = ramp(q.z(), joint(Bone::kChest).z(), scaled(0.09));
    // The base of the neck rises to the back; the jaw belongs to the head.
    const double neck_weight =
        ramp(q.z() + 0.5 * (q.x() - neck.x()), neck.z() - scaled(0.015), scaled(0.035));
    const double chin = 1.2 * std::max(q.x() - scaled(0.03), 0.0);
    const double head_weight = ramp(q.z() + chin, head.z() - scaled(0.022), scaled(0.035));
    const double collar = ramp(q.y(), scaled(0.08), scaled(0.06)) *
                          ramp(q.z(), shoulder.z() - scaled(0.06), scaled(0.06));
    bone_weights[int(Bone::kHips)] += fraction * (1.0 - spine);
    bone_weights[int(Bone::kSpine)] += fraction * spine * (1.0 - chest);
    const double upper = fraction * chest;
    bone_weights[int(Bone::kLeftClavicle)] += upper * (1.0 - neck_weight) * collar;
    bone_weights[int(Bone::kChest)] += upper * (1.0 - neck_weight) * (1.0 - collar);
    bone_weights[int(Bone::kNeck)] += upper * neck_weight * (1.0 - head_weight);
    bone_weights[int(Bone::kHead)] += upper * neck_weight * head_weight;
  }

  void addArm(WeightVector& bone_weights, const Vector3d& q, double fraction) const {
    const double forearm = ramp(q.y(), joint(Bone::kLeftForearm).y(), scaled(0.04));
    const double hand = ramp(q.y(), joint(Bone::kLeftHand).y(), scaled(0.025));
    bone_weights[int(Bone::kLeftUpperArm)] += fraction * (1.0 - forearm);
    bone_weights[int(Bone::kLeftForearm)] += fraction * forearm * (1.0 - hand);
    bone_weights[int(Bone::kLeftHand)] += fraction * forearm * hand;
  }

  void addLeg(WeightVector& bone_weights, const Vector3d& q, Layer layer, double fraction) const {
    const Vector3d &ankle = joint(Bone::kLeftFoot), &ball = joint(Bone::kLeftToes);
    if (layer == Layer::kSkirt) {  // between the legs it follows both thighs
      const double left = ramp(q.y(), 0.0, scaled(0.14));
      // The hem hangs down over a bent knee.
      const double hem =
          0.6 * ramp(joint(Bone::kLeftShank).z() + scaled(0.05) - q.z(), 0.0, scaled(0.10));
      bone_weights[int(Bone::kLeftThigh)] += fraction * (1.0 - hem) * left;
      bone_weights[int(Bone::kRightThigh)] += fraction * (1.0 - hem) * (1.0 - left);
      bone_weights[int(Bone::kLeftShank)] += fraction * hem * left;
      bone_weights[int(Bone::kRightShank)] += fraction * hem * (1.0 - left);
      return;
    }
    const double shank = ramp(joint(Bone::kLeftShank).z() - q.z(), 0.0, scaled(0.05));
    const double instep = 0.4 * (q.x() - ankle.x());
    double foot = ramp(ankle.z() + instep - q.z(), 0.0, scaled(0.03)) * shank;
    if (layer == Layer::kTrousers) foot *= 0.2;
    const double toes = ramp(q.x(), ball.x(), scaled(0.025));
    bone_weights[int(Bone::kLeftThigh)] += fraction * (1.0 - shank);
    bone_weights[int(Bone::kLeftShank)] += fraction * (shank - foot);
    bone_weights[int(Bone::kLeftFoot)] += fraction * foot * (1.0 - toes);
    bone_weights[int(Bone::kLeftToes)] += fraction * foot * toes;
  }

  const HumanSkeleton& s_;
};

void smoothWeights(std::vector<WeightVector>& bone_weights, const Surface& surface) {
  std::vector<WeightVector> sums(bone_weights.size());
  std::vector<int> counts(bone_weights.size(), 0);
  for (const std::array<int, 4>& quad : surface.quads)
    for (int v : quad) ++counts[size_t(v)];
  for (int round = 0; round < kRounds; ++round) {
    std::fill(sums.begin(), sums.end(), WeightVector::Zero());
    for (const std::array<int, 4>& quad : surface.quads)
      for (size_t i = 0; i < 4; ++i)
        sums[size_t(quad[i])] += bone_weights[size_t(quad[(i + 1) % 4])];
    for (size_t v = 0; v < bone_weights.size(); ++v)
      bone_weights[v] = 0.5 * (bone_weights[v] + sums[v] / counts[v]);
  }
}

}  // namespace

VertexWeights fourLargest(const PerBone<double>& weights) {
  std::array<size_t, kBoneCount> order;
  std::iota(order.begin(), order.end(), size_t(0));
  std::partial_sort(order.begin(), order.begin() + 4, order.end(), [&](size_t a, size_t b) {
    return weights[a] != weights[b] ? weights[a] > weights[b] : a < b;
  });
  double sum = 0.0;
  for (size_t k = 0; k < 4; ++k) sum += weights[order[k]];
  VertexWeights largest;
  for (size_t k = 0; k < 4; ++k) {
    largest.bones[k] = Bone(order[k]);
    largest.weights[k] = float(weights[order[k]] / sum);
  }
  return largest;
}

std::vector<VertexWeights> skinWeights(const HumanSkeleton& skeleton, const Surface& surface,
                                       const std::vector<Layer>& layers) {
  const WeightField field(skeleton);
  std::vector<WeightVector> bone_weights;
  for (size_t v = 0; v < surface.vertices.size(); ++v)
    bone_weights.push_back(field.at(surface.vertices[v], layers[v]));
  smoothWeights(bone_weights, surface);
  std::vector<VertexWeights> weights;
  for (const WeightVector& vertex : bone_weights) {
    PerBone<double> of_bones;
    std::copy_n(vertex.data(), kBoneCount, of_bones.begin());
    weights.push_back(fourLargest(of_bones));
  }
  return weights;
}

}  // namespace markerless_mocap
