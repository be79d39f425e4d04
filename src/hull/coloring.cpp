#include "hull/coloring.h"

#include "hull/neighbors.h"

namespace markerless_mocap {
namespace {

using Rgb = std::array<uint8_t, 3>;

/// Colours of the hull's voxels in one camera.
struct CameraColors {
  std::vector<Rgb> rgb;
  std::vector<bool> known;
};

CameraColors lookUp(const cv::Mat& image, const std::vector<int32_t>& pixel_of_voxel,
                    const std::vector<HullVoxel>& voxels) {
  CameraColors colors{std::vector<Rgb>(voxels.size()), std::vector<bool>(voxels.size(), false)};
  const int channels = image.channels();
  for (size_t i = 0; i < voxels.size(); ++i) {
    const int32_t pixel = pixel_of_voxel[voxels[i].index];
    if (pixel < 0) continue;
    const uint8_t* bgr = image.data + size_t(pixel) * channels;
    colors.rgb[i] = channels == 3 ? Rgb{bgr[2], bgr[1], bgr[0]} : Rgb{bgr[0], bgr[0], bgr[0]};
    colors.known[i] = true;
  }
  return colors;
}

int squaredDistance(const Rgb& a, const Rgb& b) {
  int sum = 0;
  for (int c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

void setMeanColors(const std::vector<CameraColors>& cameras, std::vector<HullVoxel>* voxels) {
  constexpr uint8_t kGrey = 128;
  for (size_t i = 0; i < voxels->size(); ++i) {
    std::array<int, 3> sum{};
    int count = 0;
    for (const CameraColors& camera : cameras) {
      if (!camera.known[i]) continue;
      for (int c = 0; c < 3; ++c) sum[c] += camera.rgb[i][c];
      ++count;
    }
    for (int c = 0; c < 3; ++c)
      (*voxels)[i].rgb[c] = count > 0 ? uint8_t((sum[c] + count / 2) / count) : kGrey;
  }
}

}  // namespace

void colorVoxels(const VoxelLattice& lattice,
                 const std::vector<std::vector<int32_t>>& pixel_of_voxel,
                 const std::vector<cv::Mat>& images, double color_vote_distance,
                 std::vector<HullVoxel>* voxels) {
  std::vector<CameraColors> cameras;
  for (size_t c = 0; c < images.size(); ++c)
    if (!images[c].empty()) cameras.push_back(lookUp(images[c], pixel_of_voxel[c], *voxels));
  setMeanColors(cameras, voxels);

  std::vector<uint32_t> indices;
  for (const HullVoxel& voxel : *voxels) indices.push_back(voxel.index);
  const double limit = color_vote_distance * color_vote_distance;
  for (int axis = 0; axis < 3; ++axis)
    forNeighbors(lattice, indices, Eigen::Vector3i::Unit(axis), [&](size_t a, size_t b) {
      ColorVotes& votes = (*voxels)[a].color_votes;
      for (const CameraColors& camera : cameras) {
        if (!camera.known[a] || !camera.known[b]) continue;
        ++votes.possible[axis];
        if (squaredDistance(camera.rgb[a], camera.rgb[b]) < limit) ++votes.votes[axis];
      }
    });
}

}  // namespace markerless_mocap
