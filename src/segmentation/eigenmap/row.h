#pragma once

#include <cstddef>

#define MOCAP_INLINE [[gnu::always_inline]] inline

namespace markerless_mocap {

/// Floats of a row, not aligned to more than a float.
using Four = float __attribute__((vector_size(16), aligned(4)));
using Eight = float __attribute__((vector_size(32), aligned(4)));

/// 4 N values of a node in registers.
template <int N>
struct Row {
  Eight wide[N / 2 + (N == 1)];
  Four rest;  // the last four if N is odd
};

template <int N>
MOCAP_INLINE Row<N> load(const float* from) {
  Row<N> row;
  for (int q = 0; q < N / 2; ++q) row.wide[q] = reinterpret_cast<const Eight*>(from)[q];
  if constexpr (N % 2 == 1) row.rest = reinterpret_cast<const Four*>(from)[N - 1];
  return row;
}

template <int N>
MOCAP_INLINE void store(const Row<N>& row, float* to) {
  for (int q = 0; q < N / 2; ++q) reinterpret_cast<Eight*>(to)[q] = row.wide[q];
  if constexpr (N % 2 == 1) reinterpret_cast<Four*>(to)[N - 1] = row.rest;
}

template <int N>
MOCAP_INLINE void clear(Row<N>* row) {
  for (int q = 0; q < N / 2; ++q) row->wide[q] = Eight{};
  if constexpr (N % 2 == 1) row->rest = Four{};
}

/// sum += factor row.
template <int N>
MOCAP_INLINE void add(float factor, const Row<N>& row, Row<N>* sum) {
  for (int q = 0; q < N / 2; ++q) sum->wide[q] += factor * row.wide[q];
  if constexpr (N % 2 == 1) sum->rest += factor * row.rest;
}

template <int N>
MOCAP_INLINE void scale(float factor, Row<N>* row) {
  for (int q = 0; q < N / 2; ++q) row->wide[q] *= factor;
  if constexpr (N % 2 == 1) row->rest *= factor;
}

/// sum += factor a b, value by value.
template <int N>
MOCAP_INLINE void addProduct(float factor, const Row<N>& a, const Row<N>& b, Row<N>* sum) {
  for (int q = 0; q < N / 2; ++q) sum->wide[q] += factor * a.wide[q] * b.wide[q];
  if constexpr (N % 2 == 1) sum->rest += factor * a.rest * b.rest;
}

/// sum += factor (a - b).
template <int N>
MOCAP_INLINE void addDifference(float factor, const Row<N>& a, const Row<N>& b, Row<N>* sum) {
  for (int q = 0; q < N / 2; ++q) sum->wide[q] += factor * (a.wide[q] - b.wide[q]);
  if constexpr (N % 2 == 1) sum->rest += factor * (a.rest - b.rest);
}

}  // namespace markerless_mocap
