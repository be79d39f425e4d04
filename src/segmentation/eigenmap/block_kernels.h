#pragma once

#include <cstddef>
#include <vector>

#include "segmentation/eigenmap/graph_hierarchy.h"

namespace markerless_mocap {

/// Several functions on the nodes of a graph: `width` values per node, stored together, so that one
/// look-up of a neighbour serves all of them.
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

/// Output of the products of one block with another, row-major, width x width.
struct Product {
  const Block* with;
  double* laplacian;  ///< (L a_i) . b_j
  double* mass;       ///< (M a_i) . b_j
};

/// Products of the columns of a block with those of others, summed in double precision.
/// \param la L a
void products(const GraphLevel& level, const Block& a, const Block& la,
              const std::vector<Product>& wanted);

/// r = L x - M x diag(values); adds up the squares r_k M^-1 r_k in squares[k].
void residuals(const GraphLevel& level, const float* values, const Block& x, Block* r,
               double* squares);

/// x = x C, C row-major width x width.
void combine(const float* combination, Block* x);

struct StepCombination {
  const float* of_x;
  const float* of_w;
  const float* of_p;  ///< or null
};

/// p = w C_w + p C_p, x = x C_x + p.
void takeStep(const Block& w, const StepCombination& combination, Block* x, Block* p);

/// Subtracts from each column its mean under the masses.
void removeMean(const GraphLevel& level, Block* x);

}  // namespace markerless_mocap
