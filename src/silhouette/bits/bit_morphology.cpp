#include "silhouette/bits/bit_morphology.h"

#include <algorithm>
#include <cmath>

#include "silhouette/background/row_kernels.h"

namespace markerless_mocap {
namespace {

/// Rows, and words of a row, that contain set pixels; empty if last < first.
struct Box {
  int first_row, last_row, first_word, last_word;
};

Box boxOf(const BitMask& mask) {
  Box box{mask.rows(), -1, mask.rowWords(), -1};
  std::vector<uint64_t> columns(mask.rowWords(), 0);
  for (int y = 0; y < mask.rows(); ++y) {
    const uint64_t* row = mask.row(y);
    uint64_t any = 0;
    for (int i = 0; i < mask.rowWords(); ++i) {
      any |= row[i];
      columns[i] |= row[i];
    }
    if (!any) continue;
    box.first_row = std::min(box.first_row, y);
    box.last_row = y;
  }
  for (int i = 0; i < mask.rowWords(); ++i) {
    if (!columns[i]) continue;
    box.first_word = std::min(box.first_word, i);
    box.last_word = i;
  }
  return box;
}

Box grown(Box box, int pixels, const BitMask& mask) {
  box.first_row = std::max(0, box.first_row - pixels);
  box.last_row = std::min(mask.rows() - 1, box.last_row + pixels);
  box.first_word = std::max(0, box.first_word - (pixels + 63) / 64);
  box.last_word = std::min(mask.rowWords() - 1, box.last_word + (pixels + 63) / 64);
  return box;
}

/// row |= row shifted right and left by `step` < 64 pixels; there is one more word before and after
/// it.
void orMoved(int words, int step, uint64_t* row) {
  uint64_t left = row[-1];
  for (int i = 0; i < words; ++i) {
    const uint64_t here = row[i], right = row[i + 1];
    row[i] = here | here << step | left >> (64 - step) | here >> step | right << (64 - step);
    left = here;
  }
}

/// Dilates a row by `width` pixels to both sides.
void widenRow(int width, int words, uint64_t* row) {
  // Shifting by one more than the reach leaves no gap, also where the image border cuts off one
  // half.
  for (int reach = 0; reach < width;) {
    const int step = std::min({reach + 1, width - reach, 63});
    orMoved(words, step, row);
    reach += step;
  }
}

/// Half width of the disk in each of its rows -radius..radius.
std::vector<int> diskWidths(int radius) {
  std::vector<int> widths(2 * radius + 1);
  for (int dy = -radius; dy <= radius; ++dy)
    widths[dy + radius] =
        radius > 0 ? int(std::lrint(std::sqrt(double(radius * radius - dy * dy)))) : 0;
  return widths;
}

/// Calls `apply(y + dy, words of row y widened by the disk's row dy)` for every row of the box.
/// \param inverse whether the unset pixels are widened instead
template <class ApplyT>
void forEachWidened(const BitMask& mask, const std::vector<int>& widths, const Box& box,
                    bool inverse, const ApplyT& apply) {
  const int words = box.last_word - box.first_word + 1, radius = int(widths.size()) / 2;
  if (box.last_row < box.first_row) return;
  std::vector<uint64_t> padded(words + 2, 0);
  uint64_t* wide = padded.data() + 1;
  for (int y = box.first_row; y <= box.last_row; ++y) {
    const uint64_t* row = mask.row(y) + box.first_word;
    for (int i = 0; i < words; ++i) wide[i] = inverse ? ~row[i] : row[i];
    if (inverse && box.last_word == mask.rowWords() - 1) wide[words - 1] &= mask.tailBits();
    if (std::all_of(wide, wide + words, [](uint64_t word) { return word == 0; })) continue;
    // From its top and bottom inwards the disk only becomes wider.
    for (int dy = radius, reach = 0; dy >= 0; --dy) {
      widenRow(widths[dy + radius] - reach, words, wide);
      reach = widths[dy + radius];
      apply(y - dy, wide);
      if (dy > 0) apply(y + dy, wide);
    }
  }
}

/// Morphology with the disk of radius 1, which is a cross.
/// \param outside value of the pixels outside the image
/// \param join_words erodes or dilates many words
/// \param join erodes or dilates one word
template <class JoinWordsT, class JoinT>
BitMask crossed(const BitMask& mask, uint64_t outside, const JoinWordsT& join_words,
                const JoinT& join) {
  const int words = mask.rowWords(), last = mask.rows() - 1;
  const uint64_t tail = mask.tailBits(), beyond_tail = outside & ~tail;
  BitMask out(cv::Size(mask.cols(), mask.rows()));
  // The inner rows are processed as one long row; the words at the ends of rows are corrected
  // afterwards.
  if (last > 1) join_words(mask.row(0), mask.row(1), mask.row(2), (last - 1) * words, out.row(1));
  for (int y = 0; y <= last; ++y) {
    const uint64_t* row = mask.row(y);
    const bool is_inner = y > 0 && y < last;
    for (int i = 0; i < words; i += is_inner ? std::max(1, words - 1) : 1)
      out.row(y)[i] =
          join(i > 0 ? row[i - 1] : outside, i + 1 < words ? row[i] : row[i] | beyond_tail,
               i + 1 < words - 1 ? row[i + 1]
               : i + 1 < words   ? row[i + 1] | beyond_tail
                                 : outside,
               y > 0 ? row[i - words] : outside, y < last ? row[i + words] : outside);
    out.row(y)[words - 1] &= tail;
  }
  return out;
}

BitMask dilatedRows(const BitMask& mask, const std::vector<int>& widths) {
  BitMask out(cv::Size(mask.cols(), mask.rows()));
  const int radius = std::max(int(widths.size()) / 2, widths[widths.size() / 2]);
  const Box box = grown(boxOf(mask), radius, mask);
  const int words = box.last_word - box.first_word + 1;
  forEachWidened(mask, widths, box, false, [&](int y, const uint64_t* wide) {
    if (y < 0 || y >= out.rows()) return;
    uint64_t* row = out.row(y) + box.first_word;
    for (int i = 0; i < words; ++i) row[i] |= wide[i];
  });
  for (int y = box.first_row; y <= box.last_row; ++y)
    out.row(y)[out.rowWords() - 1] &= out.tailBits();
  return out;
}

}  // namespace

BitMask dilated(const BitMask& mask, int radius) {
  if (radius == 1) return crossed(mask, 0, dilateWords, dilatedWord);
  return radius == 0 ? mask : dilatedRows(mask, diskWidths(radius));
}

BitMask eroded(const BitMask& mask, int radius) {
  if (radius == 1) return crossed(mask, ~uint64_t(0), erodeWords, erodedWord);
  BitMask out = mask;
  const Box inner = boxOf(mask);
  if (radius == 0 || inner.last_row < 0) return out;
  const Box box = grown(inner, radius, mask);
  const int words = box.last_word - box.first_word + 1;
  forEachWidened(mask, diskWidths(radius), box, true, [&](int y, const uint64_t* wide) {
    if (y < inner.first_row || y > inner.last_row) return;
    uint64_t* row = out.row(y) + box.first_word;
    for (int i = 0; i < words; ++i) row[i] &= ~wide[i];
  });
  return out;
}

void nearRow(const BitMask& mask, int y, int dx, int dy, std::vector<uint64_t>* row) {
  const int words = mask.rowWords();
  row->assign(words + 2, 0);
  uint64_t* near = row->data() + 1;
  for (int v = std::max(0, y - dy); v <= std::min(mask.rows() - 1, y + dy); ++v)
    for (int i = 0; i < words; ++i) near[i] |= mask.row(v)[i];
  widenRow(dx, words, near);
}

}  // namespace markerless_mocap
