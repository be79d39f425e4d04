#pragma once

#include <memory>

#include "markerless_mocap/products/curve_skeleton.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Thins a hull to its curve skeleton. The largest 26-connected component is kept and its cavities
/// are filled. It is thinned in parallel by critical kernels (Bertrand & Couprie 2006; 2015 for the
/// symmetric scheme that keeps isthmuses). Whether a voxel is removed depends on its neighbourhood
/// alone and not on an order, so a mirrored hull gives the mirrored result. Parts that are two
/// voxels wide then lose one side, direction by direction. The skeleton has the components and
/// tunnels of the filled component. Its only simple voxels are ends (voxels with one neighbour).
///
/// Calls reuse the memory of earlier calls: use one thinner per thread. The first thinner of a
/// process fills a table of all neighbourhoods (8 MB).
class Thinner {
 public:
  static constexpr double kPersistence = 0.04;

  /// \param persistence metres, >= 0, finite: a curve is kept if it stands out of the body by this
  ///   length after thinning. Lower bumps leave no spur; curves along limbs are shorter by it.
  explicit Thinner(double persistence = kPersistence);
  ~Thinner();
  Thinner(Thinner&&) noexcept;
  Thinner& operator=(Thinner&&) noexcept;

  /// \param voxels linear indices in the lattice, ascending
  /// An empty input gives an empty skeleton. Throws std::invalid_argument if an index is outside
  /// the lattice or not above the previous one.
  CurveSkeleton thin(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels);
  CurveSkeleton thin(const VisualHull& hull);

 private:
  class Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace markerless_mocap
