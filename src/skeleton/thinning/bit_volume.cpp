#include "skeleton/thinning/bit_volume.h"

namespace markerless_mocap {

BitBox::BitBox(int nx, int ny, int nz) : nx(nx), ny(ny), nz(nz) {
  row = size_t(nx + 2 + 63) / 64;
  plane = row * size_t(ny + 2);
  guard = plane + row + 8;
  words = plane * size_t(nz + 2) + 2 * guard;
}

}  // namespace markerless_mocap
