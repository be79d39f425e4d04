#include "skeleton/thinner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "skeleton/thinning/bit_volume_components.h"
#include "skeleton/thinning/bit_volume_window.h"
#include "skeleton/thinning/cavity_filling.h"
#include "skeleton/thinning/simple_point.h"
#include "skeleton/thinning/thinning_scheme.h"

namespace markerless_mocap {
class Thinner::Workspace {
 public:
  explicit Workspace(double persistence) : persistence_(persistence) {
    if (!(persistence >= 0.0) || std::isinf(persistence)) {
      throw std::invalid_argument("the thinner's persistence must be >= 0 and finite, not " +
                                  std::to_string(persistence));
    }
  }

  CurveSkeleton thin(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
    CurveSkeleton skeleton;
    skeleton.lattice = lattice;
    if (voxels.empty()) return skeleton;
    window_.load(lattice, voxels, &object_);
    const BitBox& box = window_.box();
    const DroppedComponents dropped = components_.keep(box, &object_);
    skeleton.components_dropped = dropped.components;
    skeleton.voxels_dropped = dropped.voxels;
    skeleton.voxels_filled = cavities_.fill(box, &object_);
    symmetric_.thin(box, roundsIn(lattice.pitch), &object_);
    sides_.thin(box, symmetric_.kept(), &object_);
    skeleton.voxels = window_.unload(lattice, object_);
    return skeleton;
  }

  std::vector<uint32_t> voxels;

 private:
  int roundsIn(double pitch) const {
    return int(std::clamp(std::round(persistence_ / pitch), 1.0, 1000.0));
  }

  double persistence_;
  BitVolumeWindow window_;
  BitWords object_;
  LargestComponent components_;
  CavityFiller cavities_;
  SymmetricThinning symmetric_;
  SideThinning sides_;
};

Thinner::Thinner(double persistence) : workspace_(std::make_unique<Workspace>(persistence)) {
  SimplePointTable::shared();
}
Thinner::~Thinner() = default;
Thinner::Thinner(Thinner&&) noexcept = default;
Thinner& Thinner::operator=(Thinner&&) noexcept = default;

CurveSkeleton Thinner::thin(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels) {
  return workspace_->thin(lattice, voxels);
}

CurveSkeleton Thinner::thin(const VisualHull& hull) {
  std::vector<uint32_t>& voxels = workspace_->voxels;
  voxels.resize(hull.voxels.size());
  for (size_t i = 0; i < voxels.size(); ++i) voxels[i] = hull.voxels[i].index;
  return workspace_->thin(hull.lattice, voxels);
}

}  // namespace markerless_mocap
