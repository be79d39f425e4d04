#include "markerless_mocap/pipeline/eigen_layout.h"

namespace markerless_mocap {

template <int kMaxAlignBytes, bool kMallocIsAligned>
void libraryHasThisEigenLayout() {}

template void
libraryHasThisEigenLayout<EIGEN_MAX_STATIC_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED>();

}  // namespace markerless_mocap
