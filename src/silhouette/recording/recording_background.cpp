#include "silhouette/recording/recording_background.h"

#include <opencv2/imgproc.hpp>

#include "silhouette/recording/inward_flood.h"
#include "silhouette/recording/row_statistics.h"
#include "silhouette/recording/still_person.h"
#include "silhouette/recording/swept_region.h"

namespace markerless_mocap {
namespace {

constexpr float kSureShare = 0.85f;
constexpr int kMaxSpeck = 12;  ///< px
constexpr int kMargin = 3;     ///< width of the margin around a person who keeps still, px

SceneColors surelySeen(const std::vector<PixelCandidates>& candidates, const cv::Mat& swept) {
  SceneColors scene{cv::Mat(swept.size(), CV_32FC3), swept == 0};
  for (int y = 0; y < swept.rows; ++y)
    for (int x = 0; x < swept.cols; ++x)
      scene.color.at<cv::Vec3f>(y, x) = candidates[size_t(y) * swept.cols + x].colors[0].color;
  return scene;
}

void acceptSureColors(const std::vector<PixelCandidates>& candidates, const PersonColors& person,
                      SceneColors* scene) {
  for (int y = 0; y < scene->known.rows; ++y)
    for (int x = 0; x < scene->known.cols; ++x) {
      const ColorCandidate& mode = candidates[size_t(y) * scene->known.cols + x].colors[0];
      if (scene->known.at<uint8_t>(y, x) ||
          candidates[size_t(y) * scene->known.cols + x].count == 0 || mode.share < kSureShare ||
          person.logRatio(mode.color) >= 0)
        continue;
      scene->known.at<uint8_t>(y, x) = 255;
      scene->color.at<cv::Vec3f>(y, x) = mode.color;
    }
}

/// Accepts what is apart from all that was seen to be covered, such as a picture on the wall.
void acceptApart(const std::vector<PixelCandidates>& candidates, const cv::Mat& covered,
                 SceneColors* scene) {
  cv::Mat labels;
  const int n = cv::connectedComponents(scene->known == 0, labels, 8, CV_32S);
  std::vector<char> is_apart(size_t(n), 1);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (covered.at<uint8_t>(y, x)) is_apart[size_t(labels.at<int>(y, x))] = 0;
  is_apart[0] = 0;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      if (!is_apart[size_t(labels.at<int>(y, x))]) continue;
      scene->known.at<uint8_t>(y, x) = 255;
      scene->color.at<cv::Vec3f>(y, x) = candidates[size_t(y) * labels.cols + x].colors[0].color;
    }
}

/// Fills one speck with the mean of the known colours around it.
void fillSpeck(const cv::Mat& labels, int label, const cv::Rect& box, SceneColors* scene) {
  const cv::Rect around = cv::Rect(box.x - 2, box.y - 2, box.width + 4, box.height + 4) &
                          cv::Rect({}, scene->known.size());
  cv::Mat mine = labels(around) == label;
  const cv::Scalar mean = cv::mean(scene->color(around), scene->known(around));
  scene->color(around).setTo(mean, mine);
  scene->known(around).setTo(255, mine);
}

void fillSpecks(SceneColors* scene) {
  cv::Mat labels, stats, centers;
  const int n = cv::connectedComponentsWithStats(scene->known == 0, labels, stats, centers, 4);
  for (int label = 1; label < n; ++label) {
    const int* stat = stats.ptr<int>(label);
    if (stat[cv::CC_STAT_AREA] <= kMaxSpeck)
      fillSpeck(labels, label, {stat[0], stat[1], stat[2], stat[3]}, scene);
  }
}

/// Nothing that was seen at the pixels of the person is their background.
void addStillPerson(const cv::Mat& person, std::vector<PixelCandidates>* candidates,
                    SweptRegion* swept) {
  cv::Mat covered;
  cv::resize(person, covered, swept->all.size(), 0, 0, cv::INTER_AREA);
  cv::dilate(covered, covered, cv::getStructuringElement(cv::MORPH_ELLIPSE, {kMargin, kMargin}));
  for (int y = 0; y < covered.rows; ++y)
    for (int x = 0; x < covered.cols; ++x)
      if (covered.at<uint8_t>(y, x) > 127) (*candidates)[size_t(y) * covered.cols + x].count = 0;
  swept->seen |= covered > 127;
  swept->all |= covered > 127;
}

}  // namespace

SceneColors learnSceneColors(const SceneSamples& samples, const cv::Mat& person) {
  std::vector<PixelCandidates> candidates = findCandidates(samples);
  SweptRegion swept = sweptRegion(samples, candidates);
  if (!person.empty()) addStillPerson(person, &candidates, &swept);
  const SceneColors seeds = surelySeen(candidates, swept.all);
  PersonColors person_colors;
  SceneColors scene;
  for (int round = 0; round < 2; ++round) {
    scene = {seeds.color.clone(), seeds.known.clone()};
    floodInward(candidates, person_colors, &scene);
    person_colors = PersonColors(samples, scene, swept.all);
  }
  acceptSureColors(candidates, person_colors, &scene);
  acceptApart(candidates, swept.seen, &scene);
  fillSpecks(&scene);
  return scene;
}

Background learnFromRecording(const SceneSamples& samples, bool starts_still) {
  const cv::Mat person = starts_still ? stillPerson(samples) : cv::Mat();
  const SceneColors scene = learnSceneColors(samples, person);
  const cv::Size size = samples.image_size;
  const int channels = samples.image_channels;
  cv::Mat color, known;
  cv::resize(scene.color, color, size, 0, 0, cv::INTER_LINEAR);
  cv::resize(scene.known, known, size, 0, 0, cv::INTER_NEAREST);
  Background background(size, channels, 1);
  BitMask unknown(size);
  RowStatistics statistics(samples);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x)
      if (!known.at<uint8_t>(y, x)) unknown.set(x, y);
    statistics.measure(y, color.ptr<cv::Vec3f>(y), background);
  }
  if (unknown.count() == 0) return background;
  if (!person.empty()) {
    BitMask covered = BitMask::fromMat(person);
    covered &= unknown;
    background.setPerson(std::move(covered));
  }
  background.setUnknown(std::move(unknown));
  return background;
}

}  // namespace markerless_mocap
