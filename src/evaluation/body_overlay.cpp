#include "evaluation/body_overlay.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <stdexcept>

#include "evaluation/body_silhouette.h"

namespace markerless_mocap {
namespace {

constexpr double kFill = 0.4;  // share of the colour within the body
constexpr uchar kPerson = 255;
const cv::Scalar kMaskColor(255, 255, 255);

void checkSize(const Camera& camera, const cv::Mat& mat, const char* what) {
  if (mat.cols != camera.width() || mat.rows != camera.height())
    throw std::invalid_argument(std::string(what) + " of camera '" + camera.name() +
                                "' has not the size that its calibration says");
}

cv::Mat colored(const cv::Mat& image) {
  cv::Mat picture;
  if (image.type() == CV_8UC3)
    picture = image.clone();
  else if (image.type() == CV_8UC1)
    cv::cvtColor(image, picture, cv::COLOR_GRAY2BGR);
  else
    throw std::invalid_argument("an image to draw into must be 8 bit grey or BGR");
  return picture;
}

/// Wide enough to be seen when the image is shown small.
int lineWidth(const cv::Mat& picture) {
  return std::max(1, picture.cols / 640);
}

void drawOutline(const cv::Mat& area, const cv::Scalar& color, cv::Mat* picture) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(area, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  cv::drawContours(*picture, outlines, -1, color, lineWidth(*picture), cv::LINE_AA);
}

void fill(const cv::Mat& area, const cv::Scalar& color, cv::Mat* picture) {
  const cv::Rect box = cv::boundingRect(area);
  if (box.empty()) return;
  cv::Mat part = (*picture)(box), filled = part.clone();
  filled.setTo(color, area(box));
  cv::addWeighted(part, 1.0 - kFill, filled, kFill, 0.0, part);
}

/// The size of letters at which the longest line fits, if that can still be read.
double letterScale(const std::string& text, int width) {
  double scale = std::max(0.4, width / 1100.0);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    int below = 0;
    const int at_one = cv::getTextSize(line, cv::FONT_HERSHEY_SIMPLEX, 1.0, 1, &below).width;
    scale = std::min(scale, 0.97 * width / std::max(1, at_one));
  }
  return std::max(scale, 0.3);
}

void write(const std::string& text, cv::Mat* picture) {
  const double scale = letterScale(text, picture->cols);
  const int line_height = int(32 * scale);
  std::istringstream lines(text);
  int y = line_height;
  for (std::string line; std::getline(lines, line); y += line_height)
    for (const bool shadow : {true, false})
      cv::putText(*picture, line, {line_height / 3, y}, cv::FONT_HERSHEY_SIMPLEX, scale,
                  shadow ? cv::Scalar::all(0) : cv::Scalar::all(255),
                  std::max(1, int((shadow ? 4 : 1.6) * scale)), cv::LINE_AA);
}

}  // namespace

cv::Mat bodyOverlay(const Camera& camera, const cv::Mat& image, const cv::Mat& mask,
                    const BodyModel& model, const LinkPoses& T_world_link,
                    const std::vector<OverlayPart>& parts, const std::string& text) {
  checkSize(camera, image, "the image");
  cv::Mat picture = colored(image);
  if (!mask.empty()) {
    checkSize(camera, mask, "the mask");
    drawOutline(mask == kPerson, kMaskColor, &picture);
  }
  for (const OverlayPart& part : parts) {
    const cv::Mat area = bodySilhouette(model, T_world_link, camera, part.link_shown);
    fill(area, part.color, &picture);
    drawOutline(area, part.color, &picture);
  }
  write(text, &picture);
  return picture;
}

}  // namespace markerless_mocap
