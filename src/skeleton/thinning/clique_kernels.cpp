#include "skeleton/thinning/clique_kernels.h"

#include "numerics/simd_clones.h"

#define MOCAP_INLINE [[gnu::always_inline]] inline

namespace markerless_mocap::clique_kernels {
namespace {

/// Rows of one word need no bits of neighbouring words.
template <bool kOneWord, class Word>
MOCAP_INLINE uint64_t next(Word at) {
  return kOneWord ? at(0) >> 1 : at(0) >> 1 | at(1) << 63;
}
template <bool kOneWord, class Word>
MOCAP_INLINE uint64_t previous(Word at) {
  return kOneWord ? at(0) << 1 : at(0) << 1 | at(-1) >> 63;
}

/// The words of one row, or of several rows combined.
struct Row {
  const uint64_t* a;
  MOCAP_INLINE uint64_t operator()(ptrdiff_t i) const { return a[i]; }
};
struct TwoRows {
  const uint64_t *a, *b;
  MOCAP_INLINE uint64_t operator()(ptrdiff_t i) const { return a[i] | b[i]; }
};
struct Square {
  const uint64_t* a;
  ptrdiff_t s, t;
  MOCAP_INLINE uint64_t operator()(ptrdiff_t i) const {
    return a[i] | a[i + s] | a[i + t] | a[i + s + t];
  }
};

struct Verdict {
  uint64_t critical, isthmus;
};

/// Classifies a pair by the eight columns of neighbours around it, given in order. They are counted
/// by Hilditch's crossing number: 1 is a block that shrinks to a point, 0 an empty or a closed
/// ring.
MOCAP_INLINE Verdict ringVerdict(uint64_t a, uint64_t ab, uint64_t b, uint64_t bc, uint64_t c,
                                 uint64_t cd, uint64_t d, uint64_t da) {
  const uint64_t at_a = ~a & (ab | b), at_b = ~b & (bc | c);
  const uint64_t at_c = ~c & (cd | d), at_d = ~d & (da | a);
  const uint64_t some = at_a | at_b | at_c | at_d;
  const uint64_t several = (at_a & at_b) | (at_c & at_d) | ((at_a | at_b) & (at_c | at_d));
  return {several | ~some, several};
}

template <bool kOneWord>
MOCAP_INLINE uint64_t columnX(const uint64_t* at) {
  return at[0] | next<kOneWord>(Row{at});
}

template <bool kOneWord>
MOCAP_INLINE void pairsAlongX(ptrdiff_t y, ptrdiff_t z, const uint64_t* __restrict object,
                              const uint64_t* __restrict candidates, size_t begin, size_t end,
                              uint64_t* __restrict critical, uint64_t* __restrict isthmus,
                              Found* found) {
  Found all;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t* o = object + i;
    const Verdict verdict = ringVerdict(columnX<kOneWord>(o + y), columnX<kOneWord>(o + y + z),
                                        columnX<kOneWord>(o + z), columnX<kOneWord>(o + z - y),
                                        columnX<kOneWord>(o - y), columnX<kOneWord>(o - y - z),
                                        columnX<kOneWord>(o - z), columnX<kOneWord>(o + y - z));
    const uint64_t among = candidates[i] & next<kOneWord>(Row{candidates + i});
    critical[i] = verdict.critical & among;
    isthmus[i] = verdict.isthmus & among;
    all.critical |= critical[i];
    all.isthmus |= isthmus[i];
  }
  found->critical |= all.critical;
  found->isthmus |= all.isthmus;
}

/// Pairs along y with `along` the stride of rows and `across` of planes; along z the reverse.
template <bool kOneWord>
MOCAP_INLINE void pairsAlong(ptrdiff_t along, ptrdiff_t across, const uint64_t* __restrict object,
                             const uint64_t* __restrict candidates, size_t begin, size_t end,
                             uint64_t* __restrict critical, uint64_t* __restrict isthmus,
                             Found* found) {
  Found all;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *p = o + along;
    const TwoRows here{o, p}, up{o + across, p + across}, down{o - across, p - across};
    const Verdict verdict = ringVerdict(next<kOneWord>(here), next<kOneWord>(up), up(0),
                                        previous<kOneWord>(up), previous<kOneWord>(here),
                                        previous<kOneWord>(down), down(0), next<kOneWord>(down));
    const uint64_t among = candidates[i] & candidates[ptrdiff_t(i) + along];
    critical[i] = verdict.critical & among;
    isthmus[i] = verdict.isthmus & among;
    all.critical |= critical[i];
    all.isthmus |= isthmus[i];
  }
  found->critical |= all.critical;
  found->isthmus |= all.isthmus;
}

/// The edge's two ends are its neighbours along x. A clique shares the edge alone if it holds a
/// diagonal of the block.
template <bool kOneWord>
MOCAP_INLINE void edgesAlongX(ptrdiff_t y, ptrdiff_t z, const uint64_t* __restrict object,
                              const uint64_t* __restrict candidates, size_t begin, size_t end,
                              uint64_t* __restrict critical, uint64_t* __restrict isthmus,
                              Found* found) {
  Found all;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *c = candidates + i;
    const uint64_t stays =
        (o[0] & ~c[0]) | (o[y] & ~c[y]) | (o[z] & ~c[z]) | (o[y + z] & ~c[y + z]);
    const uint64_t among = ((o[0] & o[y + z]) | (o[y] & o[z])) & ~stays;
    const Square block{o, y, z};
    const uint64_t ahead = next<kOneWord>(block), behind = previous<kOneWord>(block);
    critical[i] = among & ~(ahead ^ behind);
    isthmus[i] = among & ahead & behind;
    all.critical |= critical[i];
    all.isthmus |= isthmus[i];
  }
  found->critical |= all.critical;
  found->isthmus |= all.isthmus;
}

/// Edges along y with `along` the stride of rows and `across` of planes; along z the reverse.
template <bool kOneWord>
MOCAP_INLINE void edgesAlong(ptrdiff_t along, ptrdiff_t across, const uint64_t* __restrict object,
                             const uint64_t* __restrict candidates, size_t begin, size_t end,
                             uint64_t* __restrict critical, uint64_t* __restrict isthmus,
                             Found* found) {
  Found all;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *p = o + across;
    const uint64_t *c = candidates + i, *d = c + across;
    const auto staying = [&](ptrdiff_t w) { return (o[w] & ~c[w]) | (p[w] & ~d[w]); };
    const uint64_t stays = staying(0) | next<kOneWord>(staying);
    const uint64_t diagonal = (o[0] & next<kOneWord>(Row{p})) | (p[0] & next<kOneWord>(Row{o}));
    const uint64_t among = diagonal & ~stays;
    const TwoRows front{o + along, p + along}, back{o - along, p - along};
    const uint64_t ahead = front(0) | next<kOneWord>(front);
    const uint64_t behind = back(0) | next<kOneWord>(back);
    critical[i] = among & ~(ahead ^ behind);
    isthmus[i] = among & ahead & behind;
    all.critical |= critical[i];
    all.isthmus |= isthmus[i];
  }
  found->critical |= all.critical;
  found->isthmus |= all.isthmus;
}

/// Cliques around a corner: a clique shares the corner alone if it has voxels on both sides along
/// every axis.
template <bool kOneWord>
MOCAP_INLINE void cornersOf(ptrdiff_t y, ptrdiff_t z, const uint64_t* __restrict object,
                            const uint64_t* __restrict candidates, size_t begin, size_t end,
                            uint64_t* __restrict critical, Found* found) {
  uint64_t all = 0;
  for (size_t i = begin; i < end; ++i) {
    const uint64_t *o = object + i, *c = candidates + i;
    const Square block{o, y, z};
    const TwoRows low_y{o, o + z}, high_y{o + y, o + y + z}, low_z{o, o + y},
        high_z{o + z, o + y + z};
    const uint64_t both_x = block(0) & next<kOneWord>(block);
    const uint64_t both_y =
        (low_y(0) | next<kOneWord>(low_y)) & (high_y(0) | next<kOneWord>(high_y));
    const uint64_t both_z =
        (low_z(0) | next<kOneWord>(low_z)) & (high_z(0) | next<kOneWord>(high_z));
    const auto staying = [&](ptrdiff_t w) {
      return (o[w] & ~c[w]) | (o[w + y] & ~c[w + y]) | (o[w + z] & ~c[w + z]) |
             (o[w + y + z] & ~c[w + y + z]);
    };
    critical[i] = both_x & both_y & both_z & ~(staying(0) | next<kOneWord>(staying));
    all |= critical[i];
  }
  found->critical |= all;
}

/// Voxels of the pairs, and of the blocks around edges and corners.
MOCAP_INLINE uint64_t inPairs(ptrdiff_t y, ptrdiff_t z, const uint64_t* along_x,
                              const uint64_t* along_y, const uint64_t* along_z) {
  return along_x[0] | previous<false>(Row{along_x}) | along_y[0] | along_y[-y] | along_z[0] |
         along_z[-z];
}
MOCAP_INLINE uint64_t inEdges(ptrdiff_t y, ptrdiff_t z, const uint64_t* along_x,
                              const uint64_t* along_y, const uint64_t* along_z) {
  const TwoRows across_y{along_y, along_y - z}, across_z{along_z, along_z - y};
  return Square{along_x, -y, -z}(0) | across_y(0) | previous<false>(across_y) | across_z(0) |
         previous<false>(across_z);
}

template <bool kOneWord>
MOCAP_INLINE Found pairs(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                         const uint64_t* candidates, CliqueWords* cliques) {
  Found found;
  const auto y = ptrdiff_t(box.row), z = ptrdiff_t(box.plane);
  for (const auto& [begin, end] : spans) {
    pairsAlongX<kOneWord>(y, z, object, candidates, begin, end, cliques->critical[0].data(),
                          cliques->isthmus[0].data(), &found);
    pairsAlong<kOneWord>(y, z, object, candidates, begin, end, cliques->critical[1].data(),
                         cliques->isthmus[1].data(), &found);
    pairsAlong<kOneWord>(z, y, object, candidates, begin, end, cliques->critical[2].data(),
                         cliques->isthmus[2].data(), &found);
  }
  return found;
}

template <bool kOneWord>
MOCAP_INLINE Found edges(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                         const uint64_t* candidates, CliqueWords* cliques) {
  Found found;
  const auto y = ptrdiff_t(box.row), z = ptrdiff_t(box.plane);
  for (const auto& [begin, end] : spans) {
    edgesAlongX<kOneWord>(y, z, object, candidates, begin, end, cliques->critical[0].data(),
                          cliques->isthmus[0].data(), &found);
    edgesAlong<kOneWord>(y, z, object, candidates, begin, end, cliques->critical[1].data(),
                         cliques->isthmus[1].data(), &found);
    edgesAlong<kOneWord>(z, y, object, candidates, begin, end, cliques->critical[2].data(),
                         cliques->isthmus[2].data(), &found);
  }
  return found;
}

template <bool kOneWord>
MOCAP_INLINE Found corners(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                           const uint64_t* candidates, CliqueWords* cliques) {
  Found found;
  for (const auto& [begin, end] : spans)
    cornersOf<kOneWord>(ptrdiff_t(box.row), ptrdiff_t(box.plane), object, candidates, begin, end,
                        cliques->critical[0].data(), &found);
  return found;
}

/// `members` returns the voxels of the cliques at a word. Candidates that are isthmuses are added
/// to `isthmuses` before those of critical cliques are cleared.
template <class Members>
MOCAP_INLINE void removeMembers(const WordSpans& spans, bool isthmus, const CliqueWords& cliques,
                                Members members, uint64_t* __restrict candidates,
                                uint64_t* __restrict isthmuses) {
  const uint64_t* const c[3] = {cliques.critical[0].data(), cliques.critical[1].data(),
                                cliques.critical[2].data()};
  const uint64_t* const j[3] = {cliques.isthmus[0].data(), cliques.isthmus[1].data(),
                                cliques.isthmus[2].data()};
  for (const auto& [begin, end] : spans) {
    if (isthmus)
      for (size_t i = begin; i < end; ++i)
        isthmuses[i] |= candidates[i] & members(j[0] + i, j[1] + i, j[2] + i);
    for (size_t i = begin; i < end; ++i) candidates[i] &= ~members(c[0] + i, c[1] + i, c[2] + i);
  }
}

}  // namespace

MOCAP_WIDEST Found findPairs(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                             const uint64_t* candidates, CliqueWords* cliques) {
  return box.row == 1 ? pairs<true>(box, spans, object, candidates, cliques)
                      : pairs<false>(box, spans, object, candidates, cliques);
}

MOCAP_WIDEST Found findEdges(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                             const uint64_t* candidates, CliqueWords* cliques) {
  return box.row == 1 ? edges<true>(box, spans, object, candidates, cliques)
                      : edges<false>(box, spans, object, candidates, cliques);
}

MOCAP_WIDEST Found findCorners(const BitBox& box, const WordSpans& spans, const uint64_t* object,
                               const uint64_t* candidates, CliqueWords* cliques) {
  return box.row == 1 ? corners<true>(box, spans, object, candidates, cliques)
                      : corners<false>(box, spans, object, candidates, cliques);
}

MOCAP_WIDEST void removePairs(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                              bool isthmus, uint64_t* candidates, uint64_t* isthmuses) {
  const auto y = ptrdiff_t(box.row), z = ptrdiff_t(box.plane);
  const auto members = [&](const uint64_t* a, const uint64_t* b, const uint64_t* c) {
    return inPairs(y, z, a, b, c);
  };
  removeMembers(spans, isthmus, cliques, members, candidates, isthmuses);
}

MOCAP_WIDEST void removeEdges(const BitBox& box, const WordSpans& spans, const CliqueWords& cliques,
                              bool isthmus, uint64_t* candidates, uint64_t* isthmuses) {
  const auto y = ptrdiff_t(box.row), z = ptrdiff_t(box.plane);
  const auto members = [&](const uint64_t* a, const uint64_t* b, const uint64_t* c) {
    return inEdges(y, z, a, b, c);
  };
  removeMembers(spans, isthmus, cliques, members, candidates, isthmuses);
}

MOCAP_WIDEST void removeCorners(const BitBox& box, const WordSpans& spans,
                                const CliqueWords& cliques, uint64_t* __restrict candidates) {
  const auto y = ptrdiff_t(box.row), z = ptrdiff_t(box.plane);
  const uint64_t* corner = cliques.critical[0].data();
  for (const auto& [begin, end] : spans) {
    for (size_t i = begin; i < end; ++i) {
      const Square block{corner + i, -y, -z};
      candidates[i] &= ~(block(0) | previous<false>(block));
    }
  }
}

}  // namespace markerless_mocap::clique_kernels
