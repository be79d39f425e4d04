#include "hull/selection/ghosts.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr size_t kJudged = 8;
constexpr int kWindowSide = 16;  // pixels of a PixelWindow
/// Fraction of a component's silhouette pixels that rounding may leave uncovered.
constexpr double kRounding = 0.02;

/// Rectangle of pixels; the upper bounds are exclusive.
struct PixelBox {
  int x0, y0, x1, y1;

  PixelBox clippedTo(const PixelBox& other) const {
    return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
            std::min(y1, other.y1)};
  }
  bool isEmpty() const { return x0 >= x1 || y0 >= y1; }
};

/// The pixels that components cover in a part of one camera's image.
class Coverage {
 public:
  Coverage(const Camera& camera, size_t index, const ProjectionTable& table)
      : camera_(camera), index_(index), table_(table) {}

  /// Calls visit(rectangle) with the pixels of a part that each voxel of the component covers; a
  /// rectangle may be empty.
  template <class Visit>
  void forEachVoxel(const VoxelComponent& component, const PixelBox& part, Visit visit) const {
    const VoxelLattice& lattice = table_.lattice();
    for (const BrickVoxels& cell : component.cells) {
      const Eigen::Vector3d middle =
          lattice.origin +
          lattice.pitch *
              (cornerOf(lattice, cell.brick).cast<double>().array() + kBrickSide / 2.0).matrix();
      const LocalView view = camera_.localView(middle);
      const double depth = view.R_world_view.col(2).dot(middle - camera_.position());
      const double focal = view.fx;
      const int reach =
          int(std::ceil(0.5 * focal * lattice.pitch / std::max(depth, lattice.pitch)));
      const uint8_t* codes = table_.codes(cell.brick, index_);
      const PixelWindow* end = table_.windowsEnd(cell.brick, index_);
      for (const PixelWindow* w = table_.windowsBegin(cell.brick, index_); w != end; ++w) {
        const PixelBox window{w->x - reach, w->y - reach, w->x + kWindowSide + reach,
                              w->y + kWindowSide + reach};
        if (window.clippedTo(part).isEmpty()) continue;
        for (uint64_t bits = w->voxels & cell.voxels; bits != 0; bits &= bits - 1) {
          const uint8_t code = codes[__builtin_ctzll(bits)];
          const int x = w->x + (code & 15), y = w->y + (code >> 4);
          const PixelBox pixels{x - reach, y - reach, x + reach + 1, y + reach + 1};
          visit(pixels.clippedTo(part));
        }
      }
    }
  }

  PixelBox around(const VoxelComponent& component) const {
    PixelBox box{camera_.width(), camera_.height(), 0, 0};
    const PixelBox image{0, 0, camera_.width(), camera_.height()};
    forEachVoxel(component, image, [&](const PixelBox& p) {
      box = {std::min(box.x0, p.x0), std::min(box.y0, p.y0), std::max(box.x1, p.x1),
             std::max(box.y1, p.y1)};
    });
    return box;
  }

  void begin(const PixelBox& part) {
    part_ = part;
    pixels_.assign(size_t(part.x1 - part.x0) * size_t(part.y1 - part.y0), 0);
  }
  /// Sets `bit` in the pixels of the part that the component covers.
  void add(const VoxelComponent& component, uint8_t bit) {
    forEachVoxel(component, part_, [&](const PixelBox& p) {
      for (int y = p.y0; y < p.y1; ++y)
        for (int x = p.x0; x < p.x1; ++x) at(x, y) |= bit;
    });
  }
  uint8_t& at(int x, int y) {
    return pixels_[size_t(y - part_.y0) * size_t(part_.x1 - part_.x0) + size_t(x - part_.x0)];
  }

 private:
  const Camera& camera_;
  size_t index_;
  const ProjectionTable& table_;
  PixelBox part_{};
  std::vector<uint8_t> pixels_;
};

/// Whether components[suspect] covers silhouette pixels of the camera that no other component
/// covers.
bool isNeeded(const std::vector<VoxelComponent>& components, size_t suspect, const Camera& camera,
              size_t index, const ProjectionTable& table, const TileMask& mask) {
  constexpr uint8_t kItself = 1, kOthers = 2;
  Coverage coverage(camera, index, table);
  const PixelBox part = coverage.around(components[suspect]);
  if (part.isEmpty()) return false;
  coverage.begin(part);
  for (size_t i = 0; i < components.size(); ++i)
    coverage.add(components[i], i == suspect ? kItself : kOthers);
  size_t own = 0, alone = 0;
  for (int y = part.y0; y < part.y1; ++y)
    for (int x = part.x0; x < part.x1; ++x) {
      const uint8_t covered = coverage.at(x, y);
      if ((covered & kItself) == 0 || !mask.at(x, y)) continue;
      ++own;
      alone += covered == kItself;
    }
  return double(alone) > kRounding * double(own);
}

}  // namespace

void markGhosts(const CameraRig& rig, const ProjectionTable& table,
                const std::vector<TileMask>& masks, CameraSet voters,
                std::vector<VoxelComponent>* components) {
  if (components->size() < 2) return;
  for (size_t i = 0; i < std::min(components->size(), kJudged); ++i) {
    bool needed = false;
    for (size_t c = 0; c < rig.size() && !needed; ++c)
      needed = voters >> c & 1 && isNeeded(*components, i, rig[c], c, table, masks[c]);
    (*components)[i].suspect_ghost = !needed;
  }
}

}  // namespace markerless_mocap
