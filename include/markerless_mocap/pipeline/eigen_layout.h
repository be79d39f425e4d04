#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Defined in the library for its own layout of Eigen's types alone. Compiler flags such as -mavx,
/// -march=native or -fsanitize=address change that layout; a program that is compiled with others
/// than the library does not link, instead of crashing where memory is freed.
template <int kMaxAlignBytes, bool kMallocIsAligned>
void libraryHasThisEigenLayout();

[[gnu::used]] inline void (*const kEigenLayout)() =
    &libraryHasThisEigenLayout<EIGEN_MAX_STATIC_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED>;

}  // namespace markerless_mocap
