#include "silhouette/bits/mask_runs.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

/// Pixels first..last of row y, and the state of the component whose root it is.
struct Run {
  int y, first, last;
  int parent;
  int area;
  bool at_border;
};

/// First set bit at or right of x; cols() if none.
template <class WordT>
int nextSet(const WordT& word_of, int x, int cols) {
  if (x >= cols) return cols;
  uint64_t word = word_of(x >> 6) & (~uint64_t(0) << (x & 63));
  for (int i = x >> 6;;) {
    if (word) return std::min(cols, 64 * i + __builtin_ctzll(word));
    if (64 * ++i >= cols) return cols;
    word = word_of(i);
  }
}

class RunComponents {
 public:
  /// Components of the pixels with `value`. \param diagonal whether corners connect
  RunComponents(const BitMask& mask, bool value, bool diagonal) {
    size_t above = 0, above_end = 0;
    runs_.reserve(4 * size_t(mask.rows()));
    for (int y = 0; y < mask.rows(); ++y) {
      const size_t begin = runs_.size();
      addRow(mask, y, value);
      connectRows(above, above_end, begin, diagonal ? 1 : 0);
      above = begin;
      above_end = runs_.size();
    }
  }

  /// Fills each run whose component is selected by `chosen`.
  template <class ChosenT>
  void paint(bool value, const ChosenT& chosen, BitMask* mask) {
    for (size_t i = 0; i < runs_.size(); ++i)
      if (chosen(runs_[root(int(i))])) mask->fill(runs_[i].y, runs_[i].first, runs_[i].last, value);
  }

  /// The runs of each component that is selected by `chosen`.
  template <class ChosenT>
  std::vector<std::vector<MaskRun>> collect(const ChosenT& chosen) {
    std::vector<std::vector<MaskRun>> found;
    std::vector<int> place(runs_.size(), -1);
    for (size_t i = 0; i < runs_.size(); ++i) {
      const int top = root(int(i));
      if (!chosen(runs_[top])) continue;
      if (place[top] < 0) {
        place[top] = int(found.size());
        found.emplace_back();
      }
      found[place[top]].push_back({runs_[i].y, runs_[i].first, runs_[i].last});
    }
    return found;
  }

 private:
  void addRow(const BitMask& mask, int y, bool value) {
    const uint64_t* row = mask.row(y);
    const int cols = mask.cols();
    const auto in = [&](int i) { return value ? row[i] : ~row[i]; };
    const auto out = [&](int i) { return value ? ~row[i] : row[i]; };
    for (int x = nextSet(in, 0, cols); x < cols;) {
      const int end = nextSet(out, x, cols);
      const bool at_border = x == 0 || end == cols || y == 0 || y == mask.rows() - 1;
      runs_.push_back({y, x, end - 1, int(runs_.size()), end - x, at_border});
      x = nextSet(in, end, cols);
    }
  }

  /// Joins the runs of a row, which begin at `below`, with those of the row above.
  void connectRows(size_t above, size_t above_end, size_t below, int slack) {
    for (size_t a = above, b = below; a < above_end && b < runs_.size();) {
      const Run &upper = runs_[a], &lower = runs_[b];
      if (upper.first <= lower.last + slack && lower.first <= upper.last + slack)
        join(int(a), int(b));
      runs_[a].last < runs_[b].last ? ++a : ++b;
    }
  }

  int root(int i) {
    while (runs_[i].parent != i) i = runs_[i].parent = runs_[runs_[i].parent].parent;
    return i;
  }

  void join(int a, int b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    Run &into = runs_[std::min(a, b)], &from = runs_[std::max(a, b)];
    from.parent = std::min(a, b);
    into.area += from.area;
    into.at_border = into.at_border || from.at_border;
  }

  std::vector<Run> runs_;
};

}  // namespace

void fillHoles(int max_area, BitMask* mask) {
  RunComponents(*mask, false, false)
      .paint(
          true, [=](const Run& c) { return !c.at_border && c.area <= max_area; }, mask);
}

void fillHoles(int always, int max_area,
               const std::function<bool(const std::vector<MaskRun>&)>& is_filled, BitMask* mask) {
  RunComponents background(*mask, false, false);
  const auto larger = background.collect(
      [=](const Run& c) { return !c.at_border && c.area > always && c.area <= max_area; });
  background.paint(
      true, [=](const Run& c) { return !c.at_border && c.area <= always; }, mask);
  for (const std::vector<MaskRun>& hole : larger)
    if (is_filled(hole)) fillRuns(hole, mask);
}

std::vector<std::vector<MaskRun>> findBlobs(int max_area, const BitMask& mask) {
  return RunComponents(mask, true, false).collect([=](const Run& c) { return c.area <= max_area; });
}

void fillRuns(const std::vector<MaskRun>& runs, BitMask* mask) {
  for (const MaskRun& run : runs) mask->fill(run.y, run.first, run.last, true);
}

void removeBlobs(int min_area, BitMask* mask) {
  RunComponents(*mask, true, true)
      .paint(
          false, [=](const Run& c) { return c.area < min_area; }, mask);
}

}  // namespace markerless_mocap
