#pragma once

#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Bit of the voxel itself in a neighbourhood of 27 bits (see neighborhood()).
constexpr uint32_t kCenterBit = 1u << 13;

/// Number of 26-connected components of the object in the neighbourhood of a voxel, without the
/// voxel itself.
int objectComponents(uint32_t neighborhood);

/// A table that contains for each neighbourhood whether the voxel in its centre is simple, so that
/// its removal does not change the topology. It is simple if it touches one 26-connected component
/// of the object, and one 6-connected component of the background within its 18 nearest neighbours
/// (Malandain & Bertrand 1992).
class SimplePointTable {
 public:
  /// The table of this process, filled at the first call.
  static const SimplePointTable& shared();

  /// \param neighborhood 27 bits; the bit of the voxel itself is ignored
  bool operator()(uint32_t neighborhood) const {
    const uint32_t around =
        (neighborhood & (kCenterBit - 1)) | (neighborhood >> 1 & ~(kCenterBit - 1));
    return words_[around / 64] >> (around % 64) & 1;
  }
  /// Number of simple neighbourhoods.
  uint64_t count() const;

 private:
  SimplePointTable();

  std::vector<uint64_t> words_;
};

}  // namespace markerless_mocap
