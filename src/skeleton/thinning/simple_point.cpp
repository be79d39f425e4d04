#include "skeleton/thinning/simple_point.h"

#include <array>
#include <cstdlib>

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

/// Masks of a 3 x 3 x 3 block in the order of neighborhood(): all voxels; all after the first
/// layer.
constexpr uint32_t kAll = (1u << 27) - 1;
constexpr uint32_t kNotLowX = kAll & ~0b001001001001001001001001001u;
constexpr uint32_t kNotLowY = kAll & ~0b000000111000000111000000111u;

uint32_t dilated(uint32_t set) {
  set |= (set & kNotLowX) >> 1 | (set << 1 & kNotLowX);
  set |= (set & kNotLowY) >> 3 | (set << 3 & kNotLowY);
  return (set | set >> 9 | set << 9) & kAll;
}

/// 256 neighbourhoods in parallel, one bit of each.
using Lanes = uint64_t __attribute__((vector_size(32)));

bool anyOf(const Lanes& lanes) {
  return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) != 0;
}

struct Neighbors {
  /// For each of the 26 neighbours: the neighbours that touch it.
  std::array<std::vector<int>, 26> touching;
  struct Edge {
    int faces[2];
    int edge;
  };
  std::array<int, 6> faces{};
  std::vector<Edge> edges;

  Neighbors() {
    for (int a = 0; a < 26; ++a)
      for (int b = 0; b < 26; ++b)
        if (a != b && touch(a, b)) touching[size_t(a)].push_back(b);
    faces = {number(-1, 0, 0), number(1, 0, 0),  number(0, -1, 0),
             number(0, 1, 0),  number(0, 0, -1), number(0, 0, 1)};
    for (int s : {-1, 1}) {
      for (int t : {-1, 1}) {
        edges.push_back({{number(s, 0, 0), number(0, t, 0)}, number(s, t, 0)});
        edges.push_back({{number(s, 0, 0), number(0, 0, t)}, number(s, 0, t)});
        edges.push_back({{number(0, s, 0), number(0, 0, t)}, number(0, s, t)});
      }
    }
  }

  static int number(int x, int y, int z) {
    const int block = 9 * (z + 1) + 3 * (y + 1) + x + 1;
    return block < 13 ? block : block - 1;
  }
  static bool touch(int a, int b) {
    const int p = a < 13 ? a : a + 1, q = b < 13 ? b : b + 1;
    return std::abs(p % 3 - q % 3) <= 1 && std::abs(p / 3 % 3 - q / 3 % 3) <= 1 &&
           std::abs(p / 9 - q / 9) <= 1;
  }
};

using Around = std::array<Lanes, 26>;

/// Sets the lanes in which the object's neighbours are one 26-connected component.
[[gnu::always_inline]] inline void oneObject(const Neighbors& of, const Around& object,
                                             Lanes* result) {
  Around reached;
  Lanes seen = {};
  for (size_t k = 0; k < 26; ++k) {
    reached[k] = object[k] & ~seen;
    seen |= object[k];
  }
  for (Lanes grown = ~Lanes{}; anyOf(grown);) {
    grown = Lanes{};
    for (size_t k = 0; k < 26; ++k) {
      Lanes touched = {};
      for (int other : of.touching[k]) touched |= reached[size_t(other)];
      touched &= object[k] & ~reached[k];
      reached[k] |= touched;
      grown |= touched;
    }
  }
  Lanes missed = {};
  for (size_t k = 0; k < 26; ++k) missed |= object[k] & ~reached[k];
  *result = seen & ~missed;
}

/// Sets the lanes in which the empty voxels of the 6 nearest neighbours are connected by empty
/// voxels of the 18 nearest.
[[gnu::always_inline]] inline void oneBackground(const Neighbors& of, const Around& object,
                                                 Lanes* result) {
  Around reached = {};
  Lanes seen = {};
  for (int face : of.faces) {
    reached[size_t(face)] = ~object[size_t(face)] & ~seen;
    seen |= ~object[size_t(face)];
  }
  for (Lanes grown = ~Lanes{}; anyOf(grown);) {
    grown = Lanes{};
    for (const Neighbors::Edge& edge : of.edges) {
      const auto a = size_t(edge.faces[0]), b = size_t(edge.faces[1]);
      const Lanes open = ~(object[a] | object[b] | object[size_t(edge.edge)]);
      const Lanes spread = (reached[a] ^ reached[b]) & open;
      reached[a] |= spread;
      reached[b] |= spread;
      grown |= spread;
    }
  }
  Lanes missed = {};
  for (int face : of.faces) missed |= ~object[size_t(face)] & ~reached[size_t(face)];
  *result = seen & ~missed;
}

MOCAP_WIDEST void fillTable(const Neighbors& of, uint64_t* words) {
  Around object = {};
  for (size_t k = 0; k < 8; ++k)
    for (int lane = 0; lane < 256; ++lane)
      object[k][lane / 64] |= uint64_t(lane >> k & 1) << (lane % 64);
  for (uint64_t high = 0; high < 1u << 18; ++high) {
    for (size_t k = 8; k < 26; ++k) object[k] = Lanes{} - (high >> (k - 8) & 1);
    Lanes one_object, one_background;
    oneObject(of, object, &one_object);
    oneBackground(of, object, &one_background);
    for (size_t i = 0; i < 4; ++i) words[4 * high + i] = (one_object & one_background)[i];
  }
}

}  // namespace

int objectComponents(uint32_t neighborhood) {
  uint32_t left = neighborhood & ~kCenterBit;
  int components = 0;
  for (; left != 0; ++components) {
    uint32_t component = left & -left;
    for (uint32_t before = 0; component != before;) {
      before = component;
      component = dilated(component) & left;
    }
    left &= ~component;
  }
  return components;
}

const SimplePointTable& SimplePointTable::shared() {
  static const SimplePointTable table;
  return table;
}

SimplePointTable::SimplePointTable() : words_(size_t(1) << 20) {
  fillTable(Neighbors(), words_.data());
}

uint64_t SimplePointTable::count() const {
  uint64_t result = 0;
  for (uint64_t word : words_) result += uint64_t(__builtin_popcountll(word));
  return result;
}

}  // namespace markerless_mocap
