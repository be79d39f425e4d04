#include "segmentation/eigenmap/block_kernels.h"

#include <algorithm>

#include "numerics/simd_clones.h"
#include "segmentation/eigenmap/row.h"

namespace markerless_mocap {
namespace {

constexpr size_t kSummed = 256;  // nodes per partial sum in single precision

/// L x at a node.
template <int N>
MOCAP_INLINE Row<N> laplacianRow(const GraphLevel& level, const float* x, size_t node) {
  const Row<N> here = load<N>(x + node * N * 4);
  Row<N> sum;
  clear<N>(&sum);
  for (uint32_t e = level.row_start[node]; e < level.row_start[node + 1]; ++e) {
    const Row<N> there = load<N>(x + size_t(level.neighbor[e]) * N * 4);
    addDifference<N>(level.weight[e], here, there, &sum);
  }
  return sum;
}

template <int N>
MOCAP_INLINE void multiplyRows(const GraphLevel& level, const Block& x, Block* y) {
  for (size_t node = 0; node < x.nodes; ++node) {
    store<N>(laplacianRow<N>(level, x.values.data(), node), y->row(node));
  }
}

template <int N>
MOCAP_INLINE void relaxRows(const GraphLevel& level, float damping, const Block& b, const Block& x,
                            Block* y) {
  for (size_t node = 0; node < x.nodes; ++node) {
    const Row<N> product = laplacianRow<N>(level, x.values.data(), node);
    Row<N> result = load<N>(x.row(node));
    addDifference<N>(damping * level.inverse_diagonal[node], load<N>(b.row(node)), product,
                     &result);
    store<N>(result, y->row(node));
  }
}

template <int N>
MOCAP_INLINE void restrictRows(const GraphLevel& level, const Block& b, const Block& x,
                               Block* coarse) {
  for (size_t node = 0; node < x.nodes; ++node) {
    const Row<N> product = laplacianRow<N>(level, x.values.data(), node);
    float* to = coarse->row(level.parent[node]);
    Row<N> sum = load<N>(to);
    addDifference<N>(1.0f, load<N>(b.row(node)), product, &sum);
    store<N>(sum, to);
  }
}

template <int N>
MOCAP_INLINE void prolongateRows(const GraphLevel& level, float factor, const Block& coarse,
                                 Block* fine) {
  for (size_t node = 0; node < fine->nodes; ++node) {
    Row<N> sum = load<N>(fine->row(node));
    add<N>(factor, load<N>(coarse.row(level.parent[node])), &sum);
    store<N>(sum, fine->row(node));
  }
}

/// Adds a_i . b_j, times the masses if there are any, over some nodes. Four columns of a at a time,
/// so that the sums fit into registers.
template <int N, bool kMass>
MOCAP_INLINE void addProducts(const float* mass, const Block& a, const Block& b, size_t from,
                              size_t to, double* result) {
  for (int column = 0; column < 4 * N; column += 4) {
    Row<N> sum[4];
    for (Row<N>& row : sum) clear<N>(&row);
    for (size_t node = from; node < to; ++node) {
      Row<N> right = load<N>(b.row(node));
      if constexpr (kMass) scale<N>(mass[node], &right);
      const float* left = a.row(node) + column;
      for (int i = 0; i < 4; ++i) add<N>(left[i], right, &sum[i]);
    }
    for (int i = 0; i < 4; ++i) {
      float values[4 * N];
      store<N>(sum[i], values);
      for (int j = 0; j < 4 * N; ++j) result[(column + i) * 4 * N + j] += double(values[j]);
    }
  }
}

/// Works on blocks of rows that stay in the cache for all products.
template <int N>
MOCAP_INLINE void productRows(const GraphLevel& level, const Block& a, const Block& la,
                              const std::vector<Product>& wanted) {
  for (size_t from = 0; from < a.nodes; from += kSummed) {
    const size_t to = std::min(a.nodes, from + kSummed);
    for (const Product& product : wanted) {
      addProducts<N, false>(nullptr, la, *product.with, from, to, product.laplacian);
      addProducts<N, true>(level.mass.data(), a, *product.with, from, to, product.mass);
    }
  }
}

template <int N>
MOCAP_INLINE void residualRows(const GraphLevel& level, const float* values, const Block& x,
                               Block* r, double* squares) {
  const Row<N> factors = load<N>(values);
  for (size_t from = 0; from < x.nodes; from += kSummed) {
    const size_t to = std::min(x.nodes, from + kSummed);
    Row<N> sum;
    clear<N>(&sum);
    for (size_t node = from; node < to; ++node) {
      Row<N> rest = laplacianRow<N>(level, x.values.data(), node);
      addProduct<N>(-level.mass[node], factors, load<N>(x.row(node)), &rest);
      store<N>(rest, r->row(node));
      addProduct<N>(1.0f / level.mass[node], rest, rest, &sum);
    }
    float sums[4 * N];
    store<N>(sum, sums);
    for (int k = 0; k < 4 * N; ++k) squares[k] += double(sums[k]);
  }
}

/// sum += y C for a few nodes, so that each row of C is loaded once for all of them.
template <int N, int kTogether>
MOCAP_INLINE void addCombination(const float* y, const float* combination, Row<N>* sum) {
  for (int i = 0; i < 4 * N; ++i) {
    const Row<N> row = load<N>(combination + size_t(i) * 4 * N);
    for (int n = 0; n < kTogether; ++n) add<N>(y[n * 4 * N + i], row, &sum[n]);
  }
}

template <int N, int kTogether>
MOCAP_INLINE void stepNodes(const Block& w, const StepCombination& combination, size_t node,
                            Block* x, Block* p) {
  Row<N> sum[kTogether];
  for (Row<N>& row : sum) clear<N>(&row);
  addCombination<N, kTogether>(w.row(node), combination.of_w, sum);
  if (combination.of_p != nullptr) {
    addCombination<N, kTogether>(p->row(node), combination.of_p, sum);
  }
  for (int n = 0; n < kTogether; ++n) store<N>(sum[n], p->row(node + n));
  addCombination<N, kTogether>(x->row(node), combination.of_x, sum);
  for (int n = 0; n < kTogether; ++n) store<N>(sum[n], x->row(node + n));
}

template <int N>
MOCAP_INLINE void stepRows(const Block& w, const StepCombination& combination, Block* x, Block* p) {
  size_t node = 0;
  for (; node + 4 <= x->nodes; node += 4) stepNodes<N, 4>(w, combination, node, x, p);
  for (; node < x->nodes; ++node) stepNodes<N, 1>(w, combination, node, x, p);
}

template <int N>
MOCAP_INLINE void combineRows(const float* combination, Block* x) {
  for (size_t node = 0; node < x->nodes; ++node) {
    Row<N> sum;
    clear<N>(&sum);
    addCombination<N, 1>(x->row(node), combination, &sum);
    store<N>(sum, x->row(node));
  }
}

template <int N>
MOCAP_INLINE void removeMeanRows(const GraphLevel& level, Block* x) {
  double means[4 * N] = {};
  double total = 0.0;
  for (size_t from = 0; from < x->nodes; from += kSummed) {
    const size_t to = std::min(x->nodes, from + kSummed);
    Row<N> sum;
    clear<N>(&sum);
    for (size_t node = from; node < to; ++node) {
      add<N>(level.mass[node], load<N>(x->row(node)), &sum);
      total += double(level.mass[node]);
    }
    float sums[4 * N];
    store<N>(sum, sums);
    for (int k = 0; k < 4 * N; ++k) means[k] += double(sums[k]);
  }
  float shifts[4 * N];
  for (int k = 0; k < 4 * N; ++k) shifts[k] = float(means[k] / total);
  const Row<N> shift = load<N>(shifts);
  for (size_t node = 0; node < x->nodes; ++node) {
    Row<N> row = load<N>(x->row(node));
    add<N>(-1.0f, shift, &row);
    store<N>(row, x->row(node));
  }
}

template <int N>
MOCAP_INLINE void scaleRows(const GraphLevel& level, float damping, const Block& b, Block* x) {
  for (size_t node = 0; node < b.nodes; ++node) {
    Row<N> row = load<N>(b.row(node));
    scale<N>(damping * level.inverse_diagonal[node], &row);
    store<N>(row, x->row(node));
  }
}

/// Calls FUNCTION<width / 4>(arguments).
#define MOCAP_BY_WIDTH(width, FUNCTION, ...) \
  switch (width) {                           \
    case 4:                                  \
      FUNCTION<1>(__VA_ARGS__);              \
      break;                                 \
    case 8:                                  \
      FUNCTION<2>(__VA_ARGS__);              \
      break;                                 \
    case 12:                                 \
      FUNCTION<3>(__VA_ARGS__);              \
      break;                                 \
    case 16:                                 \
      FUNCTION<4>(__VA_ARGS__);              \
      break;                                 \
    case 20:                                 \
      FUNCTION<5>(__VA_ARGS__);              \
      break;                                 \
    default:                                 \
      FUNCTION<6>(__VA_ARGS__);              \
      break;                                 \
  }

}  // namespace

MOCAP_FUSED void multiply(const GraphLevel& level, const Block& x,
                          Block* y){MOCAP_BY_WIDTH(x.width, multiplyRows, level, x, y)}

MOCAP_FUSED void relax(const GraphLevel& level, float damping, const Block& b, const Block& x,
                       Block* y){MOCAP_BY_WIDTH(x.width, relaxRows, level, damping, b, x, y)}

MOCAP_FUSED
    void restrictResidual(const GraphLevel& level, const Block& b, const Block& x, Block* coarse) {
  std::fill(coarse->values.begin(), coarse->values.end(), 0.0f);
  MOCAP_BY_WIDTH(x.width, restrictRows, level, b, x, coarse)
}

MOCAP_FUSED void prolongate(const GraphLevel& level, float factor, const Block& coarse,
                            Block* fine){
    MOCAP_BY_WIDTH(fine->width, prolongateRows, level, factor, coarse, fine)}

MOCAP_FUSED void scaleByDiagonal(const GraphLevel& level, float damping, const Block& b,
                                 Block* x){MOCAP_BY_WIDTH(b.width, scaleRows, level, damping, b, x)}

MOCAP_FUSED void products(const GraphLevel& level, const Block& a, const Block& la,
                          const std::vector<Product>& wanted) {
  for (const Product& product : wanted) {
    std::fill_n(product.laplacian, a.width * a.width, 0.0);
    std::fill_n(product.mass, a.width * a.width, 0.0);
  }
  MOCAP_BY_WIDTH(a.width, productRows, level, a, la, wanted)
}

MOCAP_FUSED void residuals(const GraphLevel& level, const float* values, const Block& x, Block* r,
                           double* squares) {
  std::fill(squares, squares + x.width, 0.0);
  MOCAP_BY_WIDTH(x.width, residualRows, level, values, x, r, squares)
}

MOCAP_FUSED void combine(const float* combination,
                         Block* x){MOCAP_BY_WIDTH(x->width, combineRows, combination, x)}

MOCAP_FUSED void takeStep(const Block& w, const StepCombination& combination, Block* x,
                          Block* p){MOCAP_BY_WIDTH(x->width, stepRows, w, combination, x, p)}

MOCAP_FUSED void removeMean(const GraphLevel& level, Block* x) {
  MOCAP_BY_WIDTH(x->width, removeMeanRows, level, x)
}

}  // namespace markerless_mocap
