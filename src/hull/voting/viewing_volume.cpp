#include "hull/voting/viewing_volume.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "camera/blind_camera.h"

namespace markerless_mocap {
namespace {

constexpr double kStep = 0.1, kReach = 8, kHeight = 2.6;  // m

CameraRig withoutBlindOnes(const CameraRig& rig) {
  CameraRig seeing;
  std::copy_if(rig.begin(), rig.end(), std::back_inserter(seeing),
               [](const Camera& camera) { return !isBlind(camera); });
  return seeing;
}

bool isSeen(const CameraRig& rig, const Eigen::Vector3d& place, int wanted) {
  int missing_allowed = int(rig.size()) - wanted;
  for (const Camera& camera : rig)
    if (!camera.projectInside(place) && --missing_allowed < 0) return false;
  return true;
}

}  // namespace

int minViewsOf(int cameras) {
  return int(std::ceil(0.75 * cameras));
}

Eigen::AlignedBox3d viewingVolume(const CameraRig& rig, int min_views, double floor_height) {
  const CameraRig seeing = withoutBlindOnes(rig);
  Eigen::AlignedBox3d cameras;
  for (const Camera& camera : seeing) cameras.extend(camera.position());
  const Eigen::Vector2d middle = cameras.center().head<2>();
  const int wanted = std::max(min_views, minViewsOf(int(seeing.size())));
  const int reach = int(kReach / kStep), layers = int(std::lround(kHeight / kStep));
  Eigen::AlignedBox3d seen;
  for (int k = 0; k < layers; ++k)
    for (int j = -reach; j < reach; ++j)
      for (int i = -reach; i < reach; ++i) {
        const Eigen::Vector3d low(middle.x() + i * kStep, middle.y() + j * kStep,
                                  floor_height + k * kStep);
        if (!isSeen(seeing, low.array() + kStep / 2, wanted)) continue;
        seen.extend(low);
        seen.extend((low.array() + kStep).matrix());
      }
  return seen;
}

}  // namespace markerless_mocap
