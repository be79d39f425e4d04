#include "skeleton/clique_kernels.h"

#define MOCAP_WIDEST __attribute__((target_clones("avx2", "default")))
#define MOCAP_INLINE [[gnu::always_inline]] inline

namespace markerless_mocap::clique_kernels {
namespace {

/// The word with each voxel's neighbour at x + 1, and at x - 1, in its place.
MOCAP_INLINE uint64_t next(const uint64_t* a) {
  return a[0] >> 1 | a[1] << 63;
}
MOCAP_INLINE uint64_t previous(const uint64_t* a) {
  return a[0] << 1 | a[-1] >> 63;
}

struct Verdict {
  uint64_t critical, joining;
};

/// Of a pair whose eight columns of neighbours, in order around it, are the arguments. They are
/// counted by Hilditch's crossings: one is a block that shrinks to a point, none an empty or a
/// closed ring.
MOCAP_INLINE Verdict ringVerdict(uint64_t a, uint64_t ab, uint64_t b, uint64_t bc, uint64_t c,
                                 uint64_t cd, uint64_t d, uint64_t da) {
  const uint64_t at_a = ~a & (ab | b), at_b = ~b & (bc | c);
  const uint64_t at_c = ~c & (cd | d), at_d = ~d & (da | a);
  const uint64_t some = at_a | at_b | at_c | at_d;
  const uint64_t several = (at_a & at_b) | (at_c & at_d) | ((at_a | at_b) & (at_c | at_d));
  return {several | ~some, several};
}

MOCAP_INLINE void store(Verdict verdict, uint64_t among, size_t i, uint64_t* critical,
                        uint64_t* joining, Found* found) {
  critical[i] = verdict.critical & among;
  joining[i] = verdict.joining & among;
  found->critical |= critical[i];
  found->joining |= joining[i];
}

MOCAP_INLINE uint64_t columnX(const uint64_t* at) {
  return at[0] | next(at);
}

MOCAP_WIDEST void pairsAlongX(Strides s, const uint64_t* __restrict object,
                              const uint64_t* __restrict candidates, size_t begin, size_t end,
                              uint64_t* __restrict critical, uint64_t* __restrict joining,
                              Found* found) {
  Found here;
  const ptrdiff_t y = s.row, z = s.plane;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t* o = object + i;
    const Verdict verdict =
        ringVerdict(columnX(o + y), columnX(o + y + z), columnX(o + z), columnX(o + z - y),
                    columnX(o - y), columnX(o - y - z), columnX(o - z), columnX(o + y - z));
    store(verdict, candidates[i] & next(candidates + i), i, critical, joining, &here);
  }
  found->critical |= here.critical;
  found->joining |= here.joining;
}

/// Pairs along y with `along` the stride of rows and `across` of planes; along z the reverse.
MOCAP_WIDEST void pairsAlong(ptrdiff_t along, ptrdiff_t across, const uint64_t* __restrict object,
                             const uint64_t* __restrict candidates, size_t begin, size_t end,
                             uint64_t* __restrict critical, uint64_t* __restrict joining,
                             Found* found) {
  Found here;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *p = o + along;
    const uint64_t* const up = o + across;
    const uint64_t* const up_p = p + across;
    const uint64_t* const down = o - across;
    const uint64_t* const down_p = p - across;
    const Verdict verdict = ringVerdict(next(o) | next(p), next(up) | next(up_p), up[0] | up_p[0],
                                        previous(up) | previous(up_p), previous(o) | previous(p),
                                        previous(down) | previous(down_p), down[0] | down_p[0],
                                        next(down) | next(down_p));
    store(verdict, candidates[i] & candidates[ptrdiff_t(i) + along], i, critical, joining, &here);
  }
  found->critical |= here.critical;
  found->joining |= here.joining;
}

/// Of 2 x 2 voxels around an edge; `ahead` and `behind` are where one of the block's neighbours at
/// the edge's two ends is. A clique of candidates shares the edge alone if it holds a diagonal.
MOCAP_INLINE void edgeVerdict(const uint64_t (&voxel)[4], const uint64_t (&stays)[4],
                              uint64_t ahead, uint64_t behind, size_t i, uint64_t* critical,
                              uint64_t* joining, Found* found) {
  const uint64_t diagonal = (voxel[0] & voxel[3]) | (voxel[1] & voxel[2]);
  const uint64_t among = diagonal & ~(stays[0] | stays[1] | stays[2] | stays[3]);
  store({~(ahead ^ behind), ahead & behind}, among, i, critical, joining, found);
}

MOCAP_INLINE uint64_t anyAt(const uint64_t* a, ptrdiff_t s, ptrdiff_t t) {
  return a[0] | a[s] | a[t] | a[s + t];
}

MOCAP_WIDEST void edgesAlongX(Strides s, const uint64_t* __restrict object,
                              const uint64_t* __restrict candidates, size_t begin, size_t end,
                              uint64_t* __restrict critical, uint64_t* __restrict joining,
                              Found* found) {
  Found here;
  const ptrdiff_t y = s.row, z = s.plane;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *c = candidates + i;
    const uint64_t any = anyAt(o, y, z);
    const uint64_t ahead = any >> 1 | anyAt(o + 1, y, z) << 63;
    const uint64_t behind = any << 1 | anyAt(o - 1, y, z) >> 63;
    edgeVerdict({o[0], o[y], o[z], o[y + z]},
                {o[0] & ~c[0], o[y] & ~c[y], o[z] & ~c[z], o[y + z] & ~c[y + z]}, ahead, behind, i,
                critical, joining, &here);
  }
  found->critical |= here.critical;
  found->joining |= here.joining;
}

/// Edges along y with `along` the stride of rows and `across` of planes; along z the reverse.
MOCAP_WIDEST void edgesAlong(ptrdiff_t along, ptrdiff_t across, const uint64_t* __restrict object,
                             const uint64_t* __restrict candidates, size_t begin, size_t end,
                             uint64_t* __restrict critical, uint64_t* __restrict joining,
                             Found* found) {
  Found here;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *p = o + across;
    const uint64_t *c = candidates + i, *d = c + across;
    const uint64_t ahead = columnX(o + along) | columnX(p + along);
    const uint64_t behind = columnX(o - along) | columnX(p - along);
    const uint64_t o_next = next(o), p_next = next(p);
    edgeVerdict({o[0], o_next, p[0], p_next},
                {o[0] & ~c[0], o_next & ~next(c), p[0] & ~d[0], p_next & ~next(d)}, ahead, behind,
                i, critical, joining, &here);
  }
  found->critical |= here.critical;
  found->joining |= here.joining;
}

/// Voxels of the pairs and of the edges' blocks.
MOCAP_INLINE uint64_t inPairs(Strides s, const uint64_t* x, const uint64_t* y, const uint64_t* z) {
  return x[0] | previous(x) | y[0] | y[-s.row] | z[0] | z[-s.plane];
}
MOCAP_INLINE uint64_t inEdges(Strides s, const uint64_t* x, const uint64_t* y, const uint64_t* z) {
  const uint64_t across_x = anyAt(x, -s.row, -s.plane);
  const uint64_t across_y = y[0] | previous(y) | y[-s.plane] | previous(y - s.plane);
  const uint64_t across_z = z[0] | previous(z) | z[-s.row] | previous(z - s.row);
  return across_x | across_y | across_z;
}

}  // namespace

void pairs(int axis, Strides s, const uint64_t* object, const uint64_t* candidates, size_t begin,
           size_t end, uint64_t* critical, uint64_t* joining, Found* found) {
  if (axis == 0) {
    pairsAlongX(s, object, candidates, begin, end, critical, joining, found);
    return;
  }
  const bool y = axis == 1;
  pairsAlong(y ? s.row : s.plane, y ? s.plane : s.row, object, candidates, begin, end, critical,
             joining, found);
}

void edges(int axis, Strides s, const uint64_t* object, const uint64_t* candidates, size_t begin,
           size_t end, uint64_t* critical, uint64_t* joining, Found* found) {
  if (axis == 0) {
    edgesAlongX(s, object, candidates, begin, end, critical, joining, found);
    return;
  }
  const bool y = axis == 1;
  edgesAlong(y ? s.row : s.plane, y ? s.plane : s.row, object, candidates, begin, end, critical,
             joining, found);
}

MOCAP_WIDEST void corners(Strides s, const uint64_t* __restrict object,
                          const uint64_t* __restrict candidates, size_t begin, size_t end,
                          uint64_t* __restrict critical, Found* found) {
  uint64_t any_found = 0;
  const ptrdiff_t y = s.row, z = s.plane;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *c = candidates + i;
    const uint64_t any = anyAt(o, y, z);
    const uint64_t spans_x = any & (any >> 1 | anyAt(o + 1, y, z) << 63);
    const uint64_t spans_y = (columnX(o) | columnX(o + z)) & (columnX(o + y) | columnX(o + y + z));
    const uint64_t spans_z = (columnX(o) | columnX(o + y)) & (columnX(o + z) | columnX(o + y + z));
    const auto stays = [&](ptrdiff_t at) {
      return (o[at] & ~c[at]) | (o[at + y] & ~c[at + y]) | (o[at + z] & ~c[at + z]) |
             (o[at + y + z] & ~c[at + y + z]);
    };
    const uint64_t here = stays(0);
    const uint64_t one_stays = here | here >> 1 | stays(1) << 63;
    critical[i] = spans_x & spans_y & spans_z & ~one_stays;
    any_found |= critical[i];
  }
  found->critical |= any_found;
}

MOCAP_WIDEST void clearPairs(Strides s, const BitWords (&cliques)[3], size_t begin, size_t end,
                             uint64_t* __restrict voxels) {
  const uint64_t *x = cliques[0].data(), *y = cliques[1].data(), *z = cliques[2].data();
  for (size_t i = begin; i < end; ++i) voxels[i] &= ~inPairs(s, x + i, y + i, z + i);
}

MOCAP_WIDEST void addPairs(Strides s, const BitWords (&cliques)[3], size_t begin, size_t end,
                           uint64_t* __restrict voxels) {
  const uint64_t *x = cliques[0].data(), *y = cliques[1].data(), *z = cliques[2].data();
  for (size_t i = begin; i < end; ++i) voxels[i] |= inPairs(s, x + i, y + i, z + i);
}

MOCAP_WIDEST void clearEdges(Strides s, const BitWords (&cliques)[3], size_t begin, size_t end,
                             uint64_t* __restrict voxels) {
  const uint64_t *x = cliques[0].data(), *y = cliques[1].data(), *z = cliques[2].data();
  for (size_t i = begin; i < end; ++i) voxels[i] &= ~inEdges(s, x + i, y + i, z + i);
}

MOCAP_WIDEST void addEdges(Strides s, const uint64_t* __restrict object,
                           const BitWords (&cliques)[3], size_t begin, size_t end,
                           uint64_t* __restrict voxels) {
  const uint64_t *x = cliques[0].data(), *y = cliques[1].data(), *z = cliques[2].data();
  for (size_t i = begin; i < end; ++i) voxels[i] |= object[i] & inEdges(s, x + i, y + i, z + i);
}

MOCAP_WIDEST void clearCorners(Strides s, const uint64_t* __restrict cliques, size_t begin,
                               size_t end, uint64_t* __restrict voxels) {
  for (size_t i = begin; i < end; ++i) {
    const uint64_t* c = cliques + i;
    const uint64_t any = anyAt(c, -s.row, -s.plane);
    voxels[i] &= ~(any | any << 1 | anyAt(c - 1, -s.row, -s.plane) >> 63);
  }
}

}  // namespace markerless_mocap::clique_kernels
