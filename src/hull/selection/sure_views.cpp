#include "hull/selection/sure_views.h"

#include <algorithm>
#include <cmath>

#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

constexpr size_t kJudged = 8;
/// Of the fraction of views in which another component is surely a person.
constexpr double kHardly = 0.25;

/// Of the component's views, one for each voxel and camera that sees it, the fraction in which the
/// pixel is a person's and not unknown.
double sureFraction(const VoxelComponent& component, const ProjectionTable& table, CameraSet voters,
                    const std::vector<HullView>& views) {
  size_t all = 0, sure = 0;
  for (const BrickVoxels& cell : component.cells)
    for (CameraSet left = voters; left != 0; left &= left - 1) {
      const size_t camera = size_t(__builtin_ctz(left));
      const cv::Mat& mask = views[camera].mask;
      const uint8_t* codes = table.codes(cell.brick, camera);
      const PixelWindow* end = table.windowsEnd(cell.brick, camera);
      for (const PixelWindow* w = table.windowsBegin(cell.brick, camera); w != end; ++w)
        for (uint64_t bits = w->voxels & cell.voxels; bits != 0; bits &= bits - 1) {
          const uint8_t code = codes[__builtin_ctzll(bits)];
          const uint8_t pixel = mask.at<uint8_t>(w->y + (code >> 4), w->x + (code & 15));
          ++all;
          sure += pixel != kBackgroundPixel && pixel != kUnknownPixel;
        }
    }
  return all ? double(sure) / double(all) : 0.0;
}

}  // namespace

void markUnsure(const ProjectionTable& table, CameraSet voters, const std::vector<HullView>& views,
                std::vector<VoxelComponent>* components) {
  if (components->size() < 2) return;
  if (std::none_of(views.begin(), views.end(),
                   [](const HullView& view) { return hasUnknownPixels(view.mask); }))
    return;
  // Only what would count as another body casts doubt on a component.
  const double body = kSecondBodyLitres / std::pow(10 * table.lattice().pitch, 3);
  std::vector<double> sure;
  for (size_t i = 0; i < std::min(components->size(), kJudged); ++i)
    sure.push_back(sureFraction((*components)[i], table, voters, views));
  for (size_t i = 0; i < sure.size(); ++i)
    for (size_t other = 0; other < sure.size(); ++other) {
      const double voxels = double((*components)[other].voxels);
      if (voxels >= body && voxels >= kSecondBodyFraction * double((*components)[i].voxels) &&
          sure[i] < kHardly * sure[other])
        (*components)[i].unsure = true;
    }
}

}  // namespace markerless_mocap
