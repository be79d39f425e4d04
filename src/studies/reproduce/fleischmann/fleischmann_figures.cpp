#include <algorithm>
#include <cmath>

#include "studies/reproduce/fleischmann/fleischmann_pictures.h"
#include "studies/reproduce/fleischmann/fleischmann_report.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr size_t kShown[] = {81, 186, 216, 279};  // frames at 60 fps of Figs. 6.2 to 6.4
const cv::Scalar kGrey(170, 170, 170), kBlue(230, 120, 20), kWhite(255, 255, 255);

/// A frame of a track; the first one that was tracked is 1.
struct Tracked {
  const VariantResults& track;
  size_t frame;

  FleischmannVector pose() const { return poseOf(track.json(0)["poses"].at(frame - 1)); }
  std::string text(size_t frame60) const {
    return "f " + std::to_string(frame60) +
           ", D=" + formatNumber("%.0f", track.D(0).at(frame - 1)) + " mm";
  }
};

void addStrip(const FilmSource& film, const VariantResults& track,
              const std::vector<size_t>& frames, size_t step, const std::string& caption,
              Page* page) {
  const FilmPictures pictures(film.capture, *film.truth, frames);
  std::vector<cv::Mat> images;
  std::vector<std::string> texts;
  for (const size_t frame : frames) {
    const Tracked found{track, frame};
    images.push_back(pictures.picture(
        frame, {truePose(film.truth->poses.at(frame)), estimatedPose(found.pose())}));
    texts.push_back(found.text(frame * step));
  }
  page->picture(strip(images, texts), caption);
}

void addOverlays(const Results& results, const FilmSource& fast, const FilmSource& slow,
                 Page* page) {
  page->heading("6.2 General results (Figs. 6.2-6.4)");
  page->text(
      "The truth is red; estimated left limbs are cyan, right ones yellow. Frames at 60 fps.");
  std::vector<size_t> at60(std::begin(kShown), std::end(kShown)), at20;
  for (const size_t frame : at60) at20.push_back(frame / 3);
  addStrip(slow, {results, "base20"}, at20, 3, "Fig. 6.2: 1000 evaluations, 20 fps", page);
  addStrip(fast, {results, "base60"}, at60, 1, "Fig. 6.3: 1000 evaluations, 60 fps", page);
  addStrip(fast, {results, "eval4000"}, at60, 1, "Fig. 6.4: 4000 evaluations, 60 fps", page);
}

/// Around the frame with the largest error.
void addWorst(const Results& results, const FilmSource& slow, Page* page) {
  const VariantResults track(results, "base20");
  const std::vector<double>& D = track.D(0);
  const size_t worst = size_t(std::max_element(D.begin(), D.end()) - D.begin()) + 1;
  constexpr size_t kApart = 15;
  const size_t before = worst > kApart ? worst - kApart : 1;
  const size_t after = std::min(worst + kApart, D.size());
  addStrip(slow, track, {before, worst, after}, 3,
           "Fig. 6.6: what is lost at 20 fps, and three quarters of a second before and after",
           page);
}

void addConvergence(const Results& results, const FilmSource& slow, Page* page) {
  const Json& found = results.at("convergence");
  page->heading("6.9 Swarm convergence");
  const auto frame = found["frame"].get<size_t>();
  const FilmPictures pictures(slow.capture, *slow.truth, {frame});
  std::vector<DrawnPose> scattered;
  for (const Json& particle : found["scattered"])
    scattered.push_back(plainPose(poseOf(particle), kGrey));
  const auto with = [&](const char* pose, std::vector<DrawnPose> poses) {
    poses.push_back(plainPose(poseOf(found[pose]), kBlue));
    return pictures.picture(frame, poses);
  };
  page->picture(strip({with("before", {}), with("first_stage", scattered), with("after", {})},
                      {"last pose", "after stage 1", "after stage 2"}),
                "Fig. 6.17: estimates in blue, in the middle with the particles that the second "
                "stage starts with in grey");
  std::vector<double> iterations;
  for (int i = 0; i < found["iterations"].get<int>(); ++i) iterations.push_back(i);
  std::vector<PlotLine> lines;
  for (const char* name : {"pelvis_yaw", "pelvis_x", "pelvis_y", "pelvis_z", "left_hip_forward",
                           "left_knee", "right_shoulder_forward", "right_elbow"})
    lines.push_back({name, numbersOf(found["spread"][name])});
  page->text(
      "Fig. 6.18, over the iterations: standard deviation of the swarm, relative to the first one "
      "in which the parameter moves, mean of " +
      std::to_string(frame) + " frames at 20 fps.");
  page->lines(iterations, "", lines, "");
}

void addCurves(const Results& results, const FilmSource& fast, Page* page) {
  const Json& curves = results.at("curves");
  page->heading("Fig. 6.19 Fitness around the true pose");
  page->text("Over the forward angle of the right shoulder, x24; each term scaled to 0 to 1.");
  page->lines(numbersOf(curves["degrees"]), "°",
              {{"silhouette", numbersOf(curves["silhouette"])},
               {"edge", numbersOf(curves["edge"])},
               {"both", numbersOf(curves["total"])}},
              "", 1.0);
  const double reach = numberOf(curves["degrees"].back());
  const FilmPictures pictures(fast.capture, *fast.truth, {kCurveFrame});
  const auto swung = [&](double degrees) {
    FleischmannVector v = fast.truth->poses.at(kCurveFrame);
    v[kRightShoulder + 1] += degrees * M_PI / 180.0;
    return pictures.picture(kCurveFrame, {plainPose(v, kWhite)});
  };
  page->picture(strip({swung(-reach), swung(reach)}, {formatNumber("%.1f", -reach) + " degrees",
                                                      formatNumber("+%.1f", reach) + " degrees"}),
                "Fig. 6.20: the extreme positions");
}

void addTime(const Results& results, Page* page) {
  const Json& time = results.at("time");
  double total = 0.0;
  for (const auto& part : time) total += part.get<double>();
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const char* name, const char* key, const char* thesis) {
    rows.push_back({name, thesis, formatNumber("%.2f", 1e3 * time[key].get<double>()),
                    formatPercent(time[key].get<double>() / total)});
  };
  add("drawing, silhouette fitness", "drawing_and_silhouette", "48 + 17 %");
  add("edge fitness", "edges", "22 %");
  add("kinematic tree", "kinematics", "11 %");
  add("edge maps, silhouettes as bits", "observing", "-");
  add("rest: swarm, constraints", "rest", "2 %");
  rows.push_back({"total", "21 s", formatNumber("%.2f", 1e3 * total), ""});
  page->heading("6.11 Time of a frame with 1000 evaluations, one thread (Table 6.5)");
  page->table({"", "#thesis", "#ms", "#share"}, rows);
}

}  // namespace

void addFleischmannFigures(const Results& results, const FilmSource& fast, const FilmSource& slow,
                           Page* page) {
  addOverlays(results, fast, slow, page);
  addWorst(results, slow, page);
  addConvergence(results, slow, page);
  addCurves(results, fast, page);
  addTime(results, page);
}

}  // namespace markerless_mocap
