#pragma once

#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Bit of the voxel itself in a neighbourhood of 27 bits (see neighborhood()).
constexpr uint32_t kCenterBit = 1u << 13;

/// 26-components of the object around a voxel, itself left out.
int objectComponents(uint32_t neighborhood);

/// For all neighbourhoods whether the voxel in the middle is simple: it touches one 26-component
/// of the object and one 6-component of the background within its 18 nearest neighbours, so that
/// the topology is the same without it (Malandain & Bertrand 1992).
class SimplePointTable {
 public:
  /// The one of the process, filled at the first call.
  static const SimplePointTable& shared();

  /// \param neighborhood 27 bits; that of the voxel itself does not matter
  bool operator()(uint32_t neighborhood) const {
    const uint32_t around =
        (neighborhood & (kCenterBit - 1)) | (neighborhood >> 1 & ~(kCenterBit - 1));
    return words_[around / 64] >> (around % 64) & 1;
  }
  /// Neighbourhoods of 26 voxels that are simple.
  uint64_t count() const;

 private:
  SimplePointTable();

  std::vector<uint64_t> words_;
};

}  // namespace markerless_mocap
