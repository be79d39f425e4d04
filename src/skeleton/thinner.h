#pragma once

#include <memory>

#include "markerless_mocap/products/curve_skeleton.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Thins a hull to its curve skeleton. The largest 26-component is kept, its cavities are filled,
/// and it is peeled in parallel by critical kernels (Bertrand & Couprie 2006; 2015 for the
/// symmetric scheme that keeps isthmuses): whether a voxel goes depends on its surroundings alone,
/// never on an order, so a mirrored hull is peeled to the mirrored remains. What is two voxels wide
/// then loses a side, direction by direction. The skeleton has the components and tunnels of the
/// filled component, and no simple voxel but ends (voxels with one neighbour).
///
/// The memory of a call is used again by the next: one thinner per thread. The first thinner of a
/// process fills a table of all neighbourhoods (8 MB).
class Thinner {
 public:
  static constexpr double kPersistence = 0.04;

  /// \param persistence metres, >= 0, finite: a curve is kept where it stands out of the body so
  /// far
  ///   after the peeling has laid it bare. Bumps that are lower leave no spur; ends of limbs are
  ///   shorter by as much.
  explicit Thinner(double persistence = kPersistence);
  ~Thinner();
  Thinner(Thinner&&) noexcept;
  Thinner& operator=(Thinner&&) noexcept;

  /// \param voxels linear indices in the lattice, ascending
  /// Nothing in, nothing out. Throws std::invalid_argument on an index that is beyond the lattice
  /// or does not ascend.
  CurveSkeleton thin(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels);
  CurveSkeleton thin(const VisualHull& hull);

 private:
  class Workspace;
  std::unique_ptr<Workspace> workspace_;
};

/// For one hull alone.
CurveSkeleton thinToCurves(const VisualHull& hull);

}  // namespace markerless_mocap
