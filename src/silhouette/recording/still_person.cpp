#include "silhouette/recording/still_person.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>
#include <vector>

namespace markerless_mocap {
namespace {

constexpr double kLongerSide = 480;  ///< px; people taller than 100 px of it are found
constexpr double kMinScore = 0.5;
constexpr size_t kLooks = 3;  ///< samples

// Of the detector's window, where the body surely is: an ellipse around its middle line.
constexpr double kCoreCentre = 0.45, kCoreWidth = 0.17, kCoreHeight = 0.33;
// How far arms and feet may reach beyond the window, and what is around is looked at beyond that.
constexpr double kBeside = 0.6, kAbove = 0.05, kBelow = 0.25, kAround = 0.3;
constexpr int kRounds = 4;

/// Windows of the detector that hold a person, in pixels of the image.
std::vector<cv::Rect2d> findPeople(const cv::Mat& image) {
  const double scale = std::min(1.0, kLongerSide / std::max(image.cols, image.rows));
  cv::Mat small = image;
  if (scale < 1) cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  cv::HOGDescriptor detector;
  detector.setSVMDetector(cv::HOGDescriptor::getDefaultPeopleDetector());
  std::vector<cv::Rect> windows;
  std::vector<double> scores;
  detector.detectMultiScale(small, windows, scores, 0, {8, 8}, {16, 16}, 1.05);
  std::vector<cv::Rect2d> people;
  for (size_t i = 0; i < windows.size(); ++i) {
    if (scores[i] < kMinScore) continue;
    const cv::Rect& window = windows[i];
    people.emplace_back(window.x / scale, window.y / scale, window.width / scale,
                        window.height / scale);
  }
  return people;
}

cv::Rect widened(const cv::Rect2d& window, double beside, double above, double below,
                 const cv::Size& image) {
  const cv::Rect2d wide(window.x - beside * window.width, window.y - above * window.height,
                        (1 + 2 * beside) * window.width, (1 + above + below) * window.height);
  return cv::Rect(wide) & cv::Rect({}, image);
}

/// Adds the person in the window. \param color CV_8UC3
void addOutlined(const cv::Mat& color, const cv::Rect2d& window, cv::Mat* people) {
  const cv::Rect reach = widened(window, kBeside, kAbove, kBelow, color.size());
  const cv::Rect around =
      widened(window, kBeside + kAround, kAbove + kAround, kBelow + kAround, color.size());
  cv::Mat labels(color.size(), CV_8UC1, cv::Scalar(cv::GC_BGD));
  labels(reach).setTo(cv::GC_PR_BGD);
  const cv::RotatedRect core(
      cv::Point2f(float(window.x + 0.5 * window.width),
                  float(window.y + kCoreCentre * window.height)),
      cv::Size2f(float(2 * kCoreWidth * window.width), float(2 * kCoreHeight * window.height)), 0);
  cv::ellipse(labels, core, cv::Scalar(cv::GC_PR_FGD), cv::FILLED);
  cv::Mat mine = labels(around), background, foreground;
  if (cv::countNonZero(mine == cv::GC_PR_FGD) == 0 || cv::countNonZero(mine == cv::GC_BGD) == 0)
    return;
  cv::grabCut(color(around), mine, {}, background, foreground, kRounds, cv::GC_INIT_WITH_MASK);
  (*people)(around) |= (mine == cv::GC_PR_FGD);
}

/// The samples whose whole image was kept.
std::vector<size_t> wholeSamples(const SceneSamples& samples) {
  std::vector<size_t> whole;
  for (size_t i = 0; i < samples.images.size(); ++i)
    if (!samples.images[i].empty()) whole.push_back(i);
  return whole;
}

}  // namespace

bool showsPerson(const cv::Mat& image) {
  return !findPeople(image).empty();
}

cv::Mat stillPerson(const SceneSamples& samples) {
  const std::vector<size_t> whole = wholeSamples(samples);
  const size_t looks = std::min(kLooks, whole.size());
  const double scale = double(samples.size.width) / samples.image_size.width;
  cv::Mat count = cv::Mat::zeros(samples.size, CV_8UC1);
  for (size_t look = 0; look < looks; ++look) {
    const size_t i = whole[(2 * look + 1) * whole.size() / (2 * looks)];
    cv::Mat people = cv::Mat::zeros(samples.size, CV_8UC1);
    for (const cv::Rect2d& window : findPeople(samples.images[i]))
      addOutlined(samples.colors[i], cv::Rect2d(window.tl() * scale, window.br() * scale), &people);
    cv::add(count, 1, count, people);
  }
  return count > double(looks) / 2;
}

}  // namespace markerless_mocap
