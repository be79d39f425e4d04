#include "tools/common/player_views.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "markerless_mocap/products/silhouette_mask.h"
#include "tools/common/overlay.h"

namespace markerless_mocap {
namespace {

constexpr int kViewWidth = 256, kQuality = 62;
constexpr int kOutlineUnits = 2048;  // per width of the view

/// The part to show, of a size and at a place that do not change with every pixel of the outlines.
/// Around the body, if there is one, as a mask may have faults all over the image.
cv::Rect steadyPart(const cv::Size& image, const cv::Mat& mask, const cv::Mat& body) {
  const cv::Rect part =
      body.empty() ? partToShow(image, mask, body) : partToShow(image, cv::Mat(), body);
  const double eighths = std::ceil(8.0 * part.width / image.width - 1e-9);
  const cv::Size size(int(image.width * eighths / 8), int(image.height * eighths / 8));
  const cv::Point middle = (part.tl() + part.br()) / 2;
  const int step = std::max(1, image.width / 32);
  const auto snapped = [&](int low, int most) { return std::clamp(low / step * step, 0, most); };
  return {{snapped(middle.x - size.width / 2, image.width - size.width),
           snapped(middle.y - size.height / 2, image.height - size.height)},
          size};
}

std::string outlinesOf(const cv::Mat& area, int width) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(area, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  std::vector<int16_t> numbers;
  for (const std::vector<cv::Point>& outline : outlines) {
    std::vector<cv::Point> corners;
    cv::approxPolyDP(outline, corners, 0.5 * width / kViewWidth, true);
    if (corners.size() < 3) continue;
    numbers.push_back(int16_t(std::min<size_t>(corners.size(), INT16_MAX)));
    corners.resize(size_t(numbers.back()));
    for (const cv::Point& corner : corners)
      for (const int value : {corner.x, corner.y})
        numbers.push_back(int16_t((value + 0.5) * kOutlineUnits / width));
  }
  return base64(numbers.data(), numbers.size() * sizeof(int16_t));
}

cv::Mat small(const cv::Mat& image) {
  cv::Mat out;
  const int height = std::max(1, kViewWidth * image.rows / image.cols);
  cv::resize(image, out, {kViewWidth, height}, 0, 0, cv::INTER_AREA);
  return out;
}

size_t sizeOf(const Json& view) {
  size_t size = 0;
  for (const char* text : {"jpeg", "body", "mask", "unknown"})
    size += view[text].get_ref<const std::string&>().size();
  return size;
}

}  // namespace

Json PlayerViews::viewOf(const Camera& camera, const CameraFrame& frame, const cv::Mat& mask,
                         const cv::Mat& body) const {
  const cv::Size size(camera.width(), camera.height());
  const cv::Rect part = steadyPart(size, mask, body);
  const cv::Mat shown_mask = mask.empty() ? mask : mask(part);
  const auto outline = [&](const cv::Mat& area) {
    return area.empty() ? std::string() : outlinesOf(area, part.width);
  };
  const bool shown = images_ && frame.image.size() == size;
  return {{"aspect", double(part.height) / part.width},
          {"jpeg", shown ? packedJpeg(small(frame.image(part)), kQuality) : ""},
          {"body", outline(body.empty() ? body : body(part))},
          {"mask", outline(mask.empty() ? mask : personPixels(shown_mask))},
          {"unknown", outline(mask.empty() ? mask : cv::Mat(shown_mask == kUnknownPixel))}};
}

void PlayerViews::add(size_t frame, const CameraRig& rig, const std::vector<CameraFrame>& frames,
                      const std::vector<cv::Mat>& masks, const std::vector<cv::Mat>& bodies) {
  Json views = Json::array();
  size_t size = 0;
  for (size_t i = 0; i < rig.size(); ++i) {
    views.push_back(viewOf(rig[i], frames[i], masks[i], bodies.empty() ? cv::Mat() : bodies[i]));
    size += sizeOf(views.back());
  }
  views_.add(frame, std::move(views), size);
}

Json PlayerViews::json() const {
  Json out = Json::array();
  for (const auto& [frame, views] : views_.items())
    out.push_back({{"frame", frame}, {"cameras", views.first}});
  return out;
}

}  // namespace markerless_mocap
