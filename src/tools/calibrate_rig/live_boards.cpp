#include "tools/calibrate_rig/live_boards.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ros/image_conversions.h"
#include "text/joined.h"
#include "tools/calibrate_rig/coverage_picture.h"
#include "tools/calibrate_rig/floor_watch.h"
#include "tools/calibrate_rig/live_images.h"

namespace markerless_mocap {
namespace {

constexpr double kInterval = 0.2;  // s between images that are searched
constexpr double kSayEvery = 2.0;  // s
constexpr size_t kMostPerCamera = 400;

class Watcher {
 public:
  Watcher(const BoardDetector& detector, const LiveWatch& watch, std::ostream* notes)
      : detector_(detector),
        watch_(watch),
        notes_(notes),
        images_(node_, watch.cameras),
        picture_(node_.advertise<sensor_msgs::Image>("calibrate_rig/coverage", 1, true)) {}

  LiveBoards run() {
    waitForAll();
    say("Wave the board before the cameras. Ctrl-C ends this, and calibrates with what was seen.");
    for (double last = -INFINITY; !watch_.interrupted() && ros::ok() && !isDone();) {
      receive();
      const double time = images_.commonTime();
      if (time < last) last = -INFINITY;  // a bag began anew
      if (time - last < kInterval) {
        saySilence();
        continue;
      }
      last = time;
      search(time);
      searched_ = ros::WallTime::now();
      silence_said_ = false;
      sayWhatIsMissing();
    }
    say(coverage_->missing().empty() ? "Stop: the views suffice, the rig is calibrated now."
                                     : "Stopped before the views sufficed.");
    thinOut();
    return found_;
  }

 private:
  void say(const std::string& text) const {
    if (notes_) *notes_ << text << std::endl;
  }

  static void receive() { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02)); }

  /// The first image of each camera that can be used.
  std::vector<cv::Mat> firstImages() {
    std::vector<cv::Mat> images(watch_.cameras.size());
    for (ros::WallTime said;; receive()) {
      std::string lacking;
      for (size_t i = 0; i < images.size(); ++i) {
        if (!images[i].empty()) continue;
        const Decoded newest = decoded(images_.newest(i));
        images[i] = newest.image;
        if (!newest.image.empty()) continue;
        addWord(&lacking, watch_.cameras[i]);
        if (!newest.problem.empty()) lacking += " (" + newest.problem + ")";
      }
      if (lacking.empty()) return images;
      if (watch_.interrupted() || !ros::ok())
        throw std::runtime_error("no images came from " + lacking);
      if ((ros::WallTime::now() - said).toSec() < kSayEvery) continue;
      said = ros::WallTime::now();
      say("waiting for images of " + lacking);
    }
  }

  void waitForAll() {
    const std::vector<cv::Mat> images = firstImages();
    for (size_t i = 0; i < images.size(); ++i) {
      found_.boards.cameras.push_back({watch_.cameras[i], images[i].cols, images[i].rows, {}});
      found_.boards.images.push_back(0);
    }
    damaged_.resize(images.size());
    coverage_.emplace(detector_.board(), found_.boards.cameras, watch_.goals);
  }

  void search(double time) {
    const size_t count = watch_.cameras.size();
    std::vector<cv::Mat> images(count);
    std::vector<BoardCorners> corners(count);
    std::vector<double> times(count);
    std::vector<std::string> problems(count);
    tbb::parallel_for(size_t(0), count, [&](size_t i) {
      const Arrival arrival = images_.nearest(i, time, kInterval / 2);
      times[i] = arrival.time;
      Decoded now = decoded(arrival);
      images[i] = now.image;
      problems[i] = std::move(now.problem);
      if (images[i].empty()) return;
      const CameraToCalibrate& camera = found_.boards.cameras[i];
      if (images[i].cols != camera.width || images[i].rows != camera.height) return;
      if (auto seen = detector_.detect(images[i])) corners[i] = std::move(*seen);
    });
    std::vector<BoardView> views;
    for (size_t i = 0; i < count; ++i) {
      if (!problems[i].empty() && ++damaged_[i] == 1)
        say(watch_.cameras[i] + ": images are left out: " + problems[i]);
      found_.boards.images[i] += !images[i].empty();
      if (!corners[i].ids.empty()) views.push_back({i, times[i], false, corners[i]});
    }
    use(views);
    publish(images, corners);
  }

  void use(const std::vector<BoardView>& views) {
    coverage_->add(views);
    std::vector<BoardView>& all = found_.boards.views;
    all.insert(all.end(), views.begin(), views.end());
    for (const BoardView& view : views)
      if (watch_.floor && view.camera == *watch_.floor)
        floor_.add(view.time, view.corners, found_.boards.cameras[view.camera].width);
  }

  bool isDone() {
    if (!told_ && !coverage_->missing().empty()) return false;
    if (!watch_.floor) return true;
    if (!told_) {
      say(coverage_->table() + "Enough. Now lay the board on the floor where " +
          watch_.cameras[*watch_.floor] + " sees it, and let it lie for some seconds.");
      told_ = images_.commonTime();
    }
    if (!floor_.isStill(*told_)) return false;
    found_.floor_time = floor_.time();
    return true;
  }

  void sayWhatIsMissing() {
    const ros::WallTime now = ros::WallTime::now();
    if ((now - said_).toSec() < kSayEvery) return;
    said_ = now;
    std::string text = "waiting for the board to lie still on the floor";
    if (!told_) {
      text = coverage_->table();
      for (const std::string& one : coverage_->missing()) text += "\n  " + one;
    }
    if (text != missing_) say(text);
    missing_ = text;
  }

  void saySilence() {
    if (silence_said_ || (ros::WallTime::now() - searched_).toSec() < kSayEvery) return;
    say("no images come any more");
    silence_said_ = true;
  }

  void publish(const std::vector<cv::Mat>& images, const std::vector<BoardCorners>& corners) {
    if (picture_.getNumSubscribers() == 0) return;
    std_msgs::Header header;
    header.stamp = ros::Time::now();
    picture_.publish(messageFromMat(coveragePicture(*coverage_, images, corners), header));
  }

  /// Every second, third ... time, the same for all cameras.
  void thinOut() {
    std::vector<BoardView>& views = found_.boards.views;
    const size_t every = 1 + views.size() / (kMostPerCamera * watch_.cameras.size());
    const auto unneeded = [&](const BoardView& view) {
      return !(found_.floor_time && view.time > *found_.floor_time - 2 * kInterval) &&
             size_t(std::llround(view.time / kInterval)) % every != 0;
    };
    views.erase(std::remove_if(views.begin(), views.end(), unneeded), views.end());
  }

  const BoardDetector& detector_;
  const LiveWatch& watch_;
  std::ostream* notes_;
  ros::NodeHandle node_;
  LiveImages images_;
  ros::Publisher picture_;
  std::optional<BoardCoverage> coverage_;
  LiveBoards found_;
  std::vector<int> damaged_;  ///< images that cannot be used, by camera
  FloorWatch floor_;
  std::optional<double> told_;  ///< s: when the board was asked onto the floor
  ros::WallTime said_, searched_ = ros::WallTime::now();
  std::string missing_;  ///< what was said last
  bool silence_said_ = false;
};

}  // namespace

LiveBoards watchBoards(const BoardDetector& detector, const LiveWatch& watch, std::ostream* notes) {
  return Watcher(detector, watch, notes).run();
}

}  // namespace markerless_mocap
