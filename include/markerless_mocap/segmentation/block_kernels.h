#pragma once

#include <cstddef>
#include <vector>

#include "markerless_mocap/segmentation/graph_hierarchy.h"

namespace markerless_mocap {

/// Several functions on a graph's nodes at once: `width` values a node, side by side, so that one
/// look-up of a neighbour serves all.
struct Block {
  size_t nodes = 0;
  int width = 0;  ///< multiple of 4, at most kWidest
  std::vector<float> values;

  Block() = default;
  Block(size_t node_count, int columns)
      : nodes(node_count), width(columns), values(node_count * size_t(columns), 0.0f) {}
  const float* row(size_t node) const { return values.data() + node * size_t(width); }
  float* row(size_t node) { return values.data() + node * size_t(width); }
};

constexpr int kWidest = 24;

/// y = L x.
void multiply(const GraphLevel& level, const Block& x, Block* y);

/// y = x - damping / diag(L) (L x - b).
void relax(const GraphLevel& level, float damping, const Block& b, const Block& x, Block* y);

/// Sums b - L x over the children of each parent.
void restrictResidual(const GraphLevel& level, const Block& b, const Block& x, Block* coarse);

/// fine += factor times the parents' values.
void prolongate(const GraphLevel& level, float factor, const Block& coarse, Block* fine);

/// x = damping / diag(L) b.
void scaleByDiagonal(const GraphLevel& level, float damping, const Block& b, Block* x);

/// Products of the columns of two blocks, summed in double precision, row-major width x width:
/// plain[i, j] = a_i . b_j.
void products(const Block& a, const Block& b, double* plain);

/// As products(), each node times its mass.
void massProducts(const GraphLevel& level, const Block& a, const Block& b, double* weighted);

/// r = y - M x diag(values); adds up the squares r_k M^-1 r_k into squares[k].
void residuals(const GraphLevel& level, const float* values, const Block& y, const Block& x,
               Block* r, double* squares);

/// x += y C, C row-major width x width.
void addCombination(const Block& y, const float* combination, Block* x);

/// x = y C.
void combine(const Block& y, const float* combination, Block* x);

/// x += y.
void add(const Block& y, Block* x);

/// Subtracts from each column its mean under the masses.
void removeMean(const GraphLevel& level, Block* x);

}  // namespace markerless_mocap
