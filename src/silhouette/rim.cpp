#include "silhouette/rim.h"

#include "silhouette/bit_morphology.h"

namespace markerless_mocap {
namespace {

/// Where the person's own colour is looked for, pixels from the rim.
constexpr int kNearest = 2, kFurthest = 3;
/// Squared contrast of person and background under which noise would decide, grey levels, per
/// channel.
constexpr float kLeastContrast = 150;
constexpr int kSides[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};

class RimTest {
 public:
  RimTest(const cv::Mat& image, const Background& background, double gain,
          const PixelClasses& classes)
      : image_(image),
        background_(background),
        scale_(float(gain / Background::kMeanScale)),
        classes_(classes) {}

  /// +1 if the pixel is rather person than background, -1 if not, 0 if it cannot be told.
  int side(int x, int y, const BitMask& inner, const BitMask& outer) const {
    float person[3] = {}, shade = 0;
    int inside = 0, outside = 0;
    for (const auto& step : kSides)
      for (int k = kNearest; k <= kFurthest; ++k) {
        const int u = x + k * step[0], v = y + k * step[1];
        if (u < 0 || v < 0 || u >= image_.cols || v >= image_.rows) continue;
        if (inner.at(u, v)) {
          addColor(u, v, person);
          ++inside;
        } else if (!outer.at(u, v)) {
          shade += shadeAt(u, v);
          ++outside;
        }
      }
    if (inside == 0) return 0;
    for (float& value : person) value /= float(inside);
    return compare(x, y, person, outside > 0 ? shade / float(outside) : 1.0f);
  }

 private:
  void addColor(int x, int y, float* sum) const {
    const int channels = image_.channels();
    const uint8_t* pixel = image_.ptr(y) + size_t(x) * channels;
    for (int c = 0; c < channels; ++c) sum[c] += pixel[c];
  }

  float shadeAt(int x, int y) const {
    return classes_.shade.at(x, y)
               ? float(classes_.ratio[size_t(y) * background_.stride() + x]) / 255
               : 1.0f;
  }

  int compare(int x, int y, const float* person, float shade) const {
    const int channels = image_.channels();
    const uint8_t* pixel = image_.ptr(y) + size_t(x) * channels;
    float along = 0, contrast = 0;
    for (int c = 0; c < channels; ++c) {
      const float usual = float(background_.mean(0, y, c)[x]) * scale_ * shade;
      const float whole = person[c] - usual;
      along += (float(pixel[c]) - usual) * whole;
      contrast += whole * whole;
    }
    if (contrast < kLeastContrast * float(channels)) return 0;
    return 2 * along > contrast ? 1 : -1;
  }

  const cv::Mat& image_;
  const Background& background_;
  float scale_;
  const PixelClasses& classes_;
};

}  // namespace

void refineRim(const cv::Mat& image, const Background& background, double gain,
               const PixelClasses& classes, BitMask* mask) {
  const RimTest test(image, background, gain, classes);
  for (int round = 0; round < 2; ++round) {
    const BitMask inner = eroded(*mask, 1), outer = dilated(*mask, 1);
    const BitMask before = *mask;
    for (int y = 0; y < image.rows; ++y)
      for (int i = 0; i < mask->rowWords(); ++i)
        forEachBit(outer.row(y)[i] & ~inner.row(y)[i], 64 * i, [&](int x) {
          const int side = test.side(x, y, inner, outer);
          if (side != 0 && (side > 0) != before.at(x, y)) mask->flip(x, y);
        });
  }
}

}  // namespace markerless_mocap
