#include "markerless_mocap/segmentation/block_kernels.h"

#include <algorithm>
#include <array>

namespace markerless_mocap {
namespace {

#define MOCAP_WIDEST __attribute__((target_clones("fma", "default")))
#define MOCAP_INLINE [[gnu::always_inline]] inline

/// Floats of a row, not aligned to more than a float.
using Four = float __attribute__((vector_size(16), aligned(4)));
using Eight = float __attribute__((vector_size(32), aligned(4)));

constexpr size_t kSummed = 256;  // nodes summed in single precision before double takes over

/// 4 N values of a node in registers.
template <int N>
struct Row {
  Eight wide[N / 2 + (N == 1)];
  Four rest;  // the last four where N is odd
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

/// Sums mass a_i b_j over the nodes; four columns of a at a time: their sums fit into registers.
template <int N, bool kMass>
MOCAP_INLINE void productRows(const float* mass, const Block& a, const Block& b, double* result) {
  for (size_t from = 0; from < a.nodes; from += kSummed) {
    const size_t to = std::min(a.nodes, from + kSummed);
    for (int column = 0; column < 4 * N; column += 4) {
      Row<N> sum[4];
      for (Row<N>& row : sum) clear<N>(&row);
      for (size_t node = from; node < to; ++node) {
        Row<N> right = load<N>(b.row(node));
        if constexpr (kMass) {
          Row<N> weighted;
          clear<N>(&weighted);
          add<N>(mass[node], right, &weighted);
          right = weighted;
        }
        for (int i = 0; i < 4; ++i) add<N>(a.row(node)[column + i], right, &sum[i]);
      }
      for (int i = 0; i < 4; ++i) {
        float values[4 * N];
        store<N>(sum[i], values);
        for (int j = 0; j < 4 * N; ++j) result[(column + i) * 4 * N + j] += double(values[j]);
      }
    }
  }
}

template <int N>
MOCAP_INLINE void residualRows(const GraphLevel& level, const float* values, const Block& y,
                               const Block& x, Block* r, double* squares) {
  const Row<N> factors = load<N>(values);
  for (size_t from = 0; from < x.nodes; from += kSummed) {
    const size_t to = std::min(x.nodes, from + kSummed);
    Row<N> sum;
    clear<N>(&sum);
    for (size_t node = from; node < to; ++node) {
      Row<N> rest = load<N>(y.row(node));
      addProduct<N>(-level.mass[node], factors, load<N>(x.row(node)), &rest);
      store<N>(rest, r->row(node));
      addProduct<N>(1.0f / level.mass[node], rest, rest, &sum);
    }
    float sums[4 * N];
    store<N>(sum, sums);
    for (int k = 0; k < 4 * N; ++k) squares[k] += double(sums[k]);
  }
}

/// Four nodes at a time share the look-up of the combination's rows.
template <int N, int kTogether, bool kAdd>
MOCAP_INLINE void combineNodes(const float* y, const float* combination, float* x) {
  Row<N> sum[kTogether];
  for (int n = 0; n < kTogether; ++n) {
    if constexpr (kAdd) {
      sum[n] = load<N>(x + n * 4 * N);
    } else {
      clear<N>(&sum[n]);
    }
  }
  for (int i = 0; i < 4 * N; ++i) {
    const Row<N> row = load<N>(combination + i * 4 * N);
    for (int n = 0; n < kTogether; ++n) add<N>(y[n * 4 * N + i], row, &sum[n]);
  }
  for (int n = 0; n < kTogether; ++n) store<N>(sum[n], x + n * 4 * N);
}

template <int N, bool kAdd>
MOCAP_INLINE void combineRows(const Block& y, const float* combination, Block* x) {
  size_t node = 0;
  for (; node + 4 <= x->nodes; node += 4) {
    combineNodes<N, 4, kAdd>(y.row(node), combination, x->row(node));
  }
  for (; node < x->nodes; ++node) combineNodes<N, 1, kAdd>(y.row(node), combination, x->row(node));
}

template <int N>
MOCAP_INLINE void addCombinationRows(const Block& y, const float* combination, Block* x) {
  combineRows<N, true>(y, combination, x);
}

template <int N>
MOCAP_INLINE void combinationRows(const Block& y, const float* combination, Block* x) {
  combineRows<N, false>(y, combination, x);
}

template <int N>
MOCAP_INLINE void anyProducts(const float* mass, const Block& a, const Block& b, double* result) {
  if (mass == nullptr) {
    productRows<N, false>(mass, a, b, result);
  } else {
    productRows<N, true>(mass, a, b, result);
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

MOCAP_WIDEST void productsOf(const float* mass, const Block& a, const Block& b, double* result) {
  std::fill(result, result + a.width * a.width, 0.0);
  MOCAP_BY_WIDTH(a.width, anyProducts, mass, a, b, result)
}

}  // namespace

MOCAP_WIDEST void multiply(const GraphLevel& level, const Block& x,
                           Block* y){MOCAP_BY_WIDTH(x.width, multiplyRows, level, x, y)}

MOCAP_WIDEST void relax(const GraphLevel& level, float damping, const Block& b, const Block& x,
                        Block* y){MOCAP_BY_WIDTH(x.width, relaxRows, level, damping, b, x, y)}

MOCAP_WIDEST
    void restrictResidual(const GraphLevel& level, const Block& b, const Block& x, Block* coarse) {
  std::fill(coarse->values.begin(), coarse->values.end(), 0.0f);
  MOCAP_BY_WIDTH(x.width, restrictRows, level, b, x, coarse)
}

MOCAP_WIDEST void prolongate(const GraphLevel& level, float factor, const Block& coarse,
                             Block* fine) {
  MOCAP_BY_WIDTH(fine->width, prolongateRows, level, factor, coarse, fine)
}

void scaleByDiagonal(const GraphLevel& level, float damping, const Block& b, Block* x) {
  for (size_t node = 0; node < b.nodes; ++node) {
    const float step = damping * level.inverse_diagonal[node];
    for (int k = 0; k < b.width; ++k) x->row(node)[k] = step * b.row(node)[k];
  }
}

void products(const Block& a, const Block& b, double* plain) {
  productsOf(nullptr, a, b, plain);
}

void massProducts(const GraphLevel& level, const Block& a, const Block& b, double* weighted) {
  productsOf(level.mass.data(), a, b, weighted);
}

MOCAP_WIDEST void residuals(const GraphLevel& level, const float* values, const Block& y,
                            const Block& x, Block* r, double* squares) {
  std::fill(squares, squares + x.width, 0.0);
  MOCAP_BY_WIDTH(x.width, residualRows, level, values, y, x, r, squares)
}

MOCAP_WIDEST void addCombination(const Block& y, const float* combination, Block* x){
    MOCAP_BY_WIDTH(y.width, addCombinationRows, y, combination, x)}

MOCAP_WIDEST void combine(const Block& y, const float* combination,
                          Block* x){MOCAP_BY_WIDTH(y.width, combinationRows, y, combination, x)}

MOCAP_WIDEST void add(const Block& y, Block* x) {
  for (size_t i = 0; i < x->values.size(); ++i) x->values[i] += y.values[i];
}

void removeMean(const GraphLevel& level, Block* x) {
  std::array<double, kWidest> mean{};
  double total = 0.0;
  for (size_t node = 0; node < x->nodes; ++node) {
    const double mass = level.mass[node];
    total += mass;
    for (int k = 0; k < x->width; ++k) mean[k] += mass * x->row(node)[k];
  }
  std::array<float, kWidest> shift{};
  for (int k = 0; k < x->width; ++k) shift[k] = float(mean[k] / total);
  for (size_t node = 0; node < x->nodes; ++node) {
    for (int k = 0; k < x->width; ++k) x->row(node)[k] -= shift[k];
  }
}

}  // namespace markerless_mocap
