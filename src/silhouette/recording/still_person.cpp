#include "silhouette/recording/still_person.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>
#include <vector>

namespace markerless_mocap {
namespace {

constexpr double kLongerSide = 480;  ///< px; people taller than 100 px of it are found
/// People have 0.6 to 3.5. Of 68 pictures of empty rooms one reaches this, by a stand.
constexpr double kMinScore = 0.5;
/// Samples of a recording, and of the first second alone.
constexpr size_t kLooks = 3, kFirstLooks = 1, kFirstSamples = 12;

// How far arms and feet may reach beyond the detector's window, and how far around that the colours
// of the background are learned; in widths and heights of the window.
constexpr double kBeside = 0.5, kAbove = 0.05, kBelow = 0.25, kAround = 0.3;
// Live, everything waits for the first outlines. At 160 px and 4 rounds they are no better.
constexpr double kWindowWidth = 100;  ///< px; larger windows are reduced to it
constexpr int kRounds = 3;
constexpr int kGap = 1;  ///< px; parts of a body that are so near each other are connected
constexpr int kFewestPixels = 50;  ///< of each kind, to learn colours from

/// An ellipse in the window where the body probably is, in widths and heights of the window.
struct BodyEllipse {
  double y, half_width, half_height;
};
constexpr BodyEllipse kBody[] = {{0.17, 0.08, 0.05}, {0.36, 0.20, 0.17}, {0.64, 0.13, 0.24}};

/// Windows of the detector that hold a person, in pixels of the image.
std::vector<cv::Rect2d> findPeople(const cv::Mat& image) {
  const double scale = std::min(1.0, kLongerSide / std::max(image.cols, image.rows));
  cv::Mat small = image;
  if (scale < 1) cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  cv::HOGDescriptor detector;
  if (small.cols < detector.winSize.width || small.rows < detector.winSize.height) return {};
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

cv::Rect widened(const cv::Rect2d& window, double more, const cv::Size& image) {
  const double beside = (kBeside + more) * window.width, above = (kAbove + more) * window.height,
               below = (kBelow + more) * window.height;
  const cv::Rect2d wide(window.x - beside, window.y - above, window.width + 2 * beside,
                        window.height + above + below);
  return cv::Rect(wide) & cv::Rect({}, image);
}

/// What to cut the person in the window from, as cv::grabCut() has it.
cv::Mat firstLabels(const cv::Rect2d& window, const cv::Size& image) {
  cv::Mat labels(image, CV_8UC1, cv::Scalar(cv::GC_BGD));
  labels(widened(window, 0, image)).setTo(cv::GC_PR_BGD);
  for (const BodyEllipse& part : kBody) {
    const cv::Point2d centre(window.x + 0.5 * window.width, window.y + part.y * window.height);
    const cv::Size2d size(2 * part.half_width * window.width, 2 * part.half_height * window.height);
    cv::ellipse(labels, cv::RotatedRect(centre, size, 0), cv::Scalar(cv::GC_PR_FGD), cv::FILLED);
  }
  return labels;
}

/// Without what lies apart from the middle of the body and has its colours by chance, such as
/// pictures on the wall. \param labels as firstLabels() has drawn them
cv::Mat connectedWithBody(const cv::Mat& outlined, const cv::Mat& labels) {
  cv::Mat wide, parts, kept = cv::Mat::zeros(outlined.size(), CV_8UC1);
  cv::dilate(outlined, wide, cv::Mat::ones(2 * kGap + 1, 2 * kGap + 1, CV_8UC1));
  const int count = cv::connectedComponents(wide, parts);
  for (int part = 1; part < count; ++part) {
    const cv::Mat here = parts == part;
    if (cv::countNonZero(here & outlined & (labels == cv::GC_PR_FGD)) > 0) kept |= here;
  }
  return kept & outlined;
}

/// Adds the person in the window. \param color CV_8UC3 \param seed of the colours that the outline
/// begins with: of alike images, another one makes another mistake
void addOutlined(const cv::Mat& color, const cv::Rect2d& window, int seed, cv::Mat* people) {
  const cv::Rect around = widened(window, kAround, color.size());
  if (around.empty()) return;
  const double scale = std::min(1.0, kWindowWidth / window.width);
  cv::Mat patch, background, foreground, outlined;
  cv::resize(color(around), patch, {}, scale, scale, cv::INTER_AREA);
  const cv::Point2d origin = around.tl();
  cv::Mat labels = firstLabels(
      cv::Rect2d((window.tl() - origin) * scale, (window.br() - origin) * scale), patch.size());
  if (cv::countNonZero(labels == cv::GC_PR_FGD) < kFewestPixels ||
      cv::countNonZero(labels == cv::GC_BGD) < kFewestPixels)
    return;
  cv::setRNGSeed(seed);
  cv::Mat cut = labels.clone();
  cv::grabCut(patch, cut, {}, background, foreground, kRounds, cv::GC_INIT_WITH_MASK);
  cv::resize(connectedWithBody(cut == cv::GC_PR_FGD, labels), outlined, around.size(), 0, 0,
             cv::INTER_LINEAR);
  (*people)(around) |= (outlined > 127);
}

cv::Mat peopleIn(const cv::Mat& image, int seed) {
  cv::Mat color = image, people = cv::Mat::zeros(image.size(), CV_8UC1);
  if (image.channels() == 1) cv::cvtColor(image, color, cv::COLOR_GRAY2BGR);
  for (const cv::Rect2d& window : findPeople(image)) addOutlined(color, window, seed, &people);
  return people;
}

/// The samples whose whole image was kept.
std::vector<cv::Mat> wholeImages(const SceneSamples& samples) {
  std::vector<cv::Mat> whole;
  for (const cv::Mat& image : samples.images)
    if (!image.empty()) whole.push_back(image);
  return whole;
}

}  // namespace

bool showsPerson(const cv::Mat& image) {
  return !findPeople(image).empty();
}

cv::Mat stillPerson(const SceneSamples& samples) {
  const std::vector<cv::Mat> whole = wholeImages(samples);
  const size_t looks =
      std::min(samples.colors.size() < kFirstSamples ? kFirstLooks : kLooks, whole.size());
  cv::Mat count = cv::Mat::zeros(samples.image_size, CV_8UC1);
  for (size_t look = 0; look < looks; ++look) {
    const cv::Mat people = peopleIn(whole[(2 * look + 1) * whole.size() / (2 * looks)], int(look));
    cv::add(count, 1, count, people);
  }
  return count > 0.5 * double(looks);
}

}  // namespace markerless_mocap
