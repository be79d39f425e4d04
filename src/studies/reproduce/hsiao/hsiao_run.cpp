#include "studies/reproduce/hsiao/hsiao_run.h"

#include <algorithm>
#include <cmath>

#include "evaluation/body_points.h"
#include "evaluation/joint_error.h"
#include "evaluation/part_error.h"
#include "studies/reproduce/hsiao/hsiao_strip.h"

namespace markerless_mocap {
namespace {

constexpr size_t kStripFrames = 8;
constexpr int kQuality = 88;  // of a strip's JPEG
constexpr int kSegmentEvery = 3;

/// The poses are not used.
const Overrides kQuickFit = {{"pose_fitting/hsiao/particles_per_parameter", "0.5"},
                             {"pose_fitting/hsiao/iterations_per_parameter", "0.5"},
                             {"pose_fitting/hsiao/fine_tune_iterations", "1"}};

Json rounded(const std::vector<double>& values) {
  Json out = Json::array();
  for (const double value : values)
    out.push_back(std::isfinite(value) ? Json(std::round(value * 100.0) / 100.0) : Json());
  return out;
}

Eigen::Matrix3Xd markersOf(const PipelineResult& now) {
  const auto count = Eigen::Index(markerNames().size());
  if (now.pose.status == PoseStatus::kLost) return Eigen::Matrix3Xd::Constant(3, count, NAN);
  LinkPoses T_world_link;
  now.body->model->forwardKinematics(now.pose.T_world_body, now.pose.angles, T_world_link);
  return bodyPoints(*now.body->model, T_world_link).leftCols(count);
}

/// Mean length of the second difference of all markers, mm.
double jitterOf(const JointTrack& track) {
  std::vector<double> steps;
  for (size_t f = 2; f < track.frames(); ++f) {
    const Eigen::Matrix3Xd change =
        track.positions[f] - 2.0 * track.positions[f - 1] + track.positions[f - 2];
    steps.push_back(1e3 * change.colwise().norm().mean());
  }
  return summaryStatistics(steps).mean;
}

bool hasSixParts(const BodyParts& parts) {
  return std::all_of(parts.parts.begin(), parts.parts.end(),
                     [](const PartCurve& part) { return part.seen && part.points.size() >= 2; });
}

/// Columns of the film strip, at even distances over the capture.
class Strip {
 public:
  explicit Strip(size_t frames) : frames_(frames) {}

  void add(size_t frame, const HsiaoFilm& film, const PipelineResult& now) {
    if (frame != (2 * columns_.size() + 1) * frames_ / (2 * kStripFrames)) return;
    const CameraFrame& seen = film.frameSet().frames.front();
    columns_.push_back(stripColumn(film.rig().front(), seen.image, now));
    captions_.push_back("frame " + std::to_string(frame + 1));
  }
  cv::Mat picture() const {
    if (columns_.empty()) return {};
    std::vector<std::vector<cv::Mat>> rows(columns_.front().size());
    for (const auto& column : columns_)
      for (size_t row = 0; row < rows.size(); ++row) rows[row].push_back(column[row]);
    return joined(rows, captions_);
  }

 private:
  size_t frames_;
  std::vector<std::vector<cv::Mat>> columns_;
  std::vector<std::string> captions_;
};

SegmentedHull segmentedOf(const VisualHull& hull, const BodyParts& parts) {
  SegmentedHull out;
  out.valid = parts.status != SegmentationStatus::kInvalid;
  out.pitch = hull.lattice.pitch;
  out.voxels.resize(3, Eigen::Index(hull.voxels.size()));
  for (size_t v = 0; v < hull.voxels.size(); ++v)
    out.voxels.col(Eigen::Index(v)) = hull.lattice.center(hull.voxels[v].index);
  out.labels = parts.labels;
  for (size_t part = 0; part < parts.parts.size(); ++part) {
    const auto& points = parts.parts[part].points;
    out.curves[part].resize(3, Eigen::Index(points.size()));
    for (size_t p = 0; p < points.size(); ++p) out.curves[part].col(Eigen::Index(p)) = points[p];
  }
  return out;
}

Json partResult(const PartErrors& errors) {
  Json overlap = Json::array(), found = Json::array();
  for (size_t part = 0; part < size_t(kTruePartCount); ++part) {
    double sum = 0.0, share = 0.0;
    for (const PartEvaluation& frame : errors.verdicts) {
      sum += frame.overlap[part] / double(errors.verdicts.size());
      share += (frame.overlap[part] > 0.5) / double(errors.verdicts.size());
    }
    overlap.push_back(sum);
    found.push_back(share);
  }
  return {{"correct", errors.all.fraction_correct},
          {"six", errors.all.fraction_all_six},
          {"overlap", overlap},
          {"found", found},
          {"curve_mm", rounded({errors.torso_mm.mean, errors.head_mm.mean, errors.arms_mm.mean,
                                errors.legs_mm.mean})}};
}

}  // namespace

Json trackSequence(const Capture& capture, const Overrides& changes, bool strip) {
  const HsiaoTruth truth = hsiaoTruth(capture);
  HsiaoFilm film(capture, truth, changes);
  Strip pictures(truth.points.frames());
  JointTrack found;
  found.names = markerNames();
  double resets = 0.0;
  Json six = Json::array();
  for (size_t f = 0; const auto now = film.next(); ++f) {
    found.add(film.frameSet().stamp_ns, markersOf(*now));
    six.push_back(hasSixParts(now->parts));
    resets += f > 0 && now->pose.status == PoseStatus::kReinitialized;
    if (strip) pictures.add(f, film, *now);
  }
  const JointTrack joints = truth.points.select(markerNames());
  const JointErrors errors = jointErrors(joints, alignedTo(joints, found));
  Json seconds = Json::array();
  for (const int64_t stamp : joints.stamps_ns)
    seconds.push_back(1e-9 * double(stamp - joints.stamps_ns.front()));
  Json out{{"D", rounded(errors.D)},
           {"seconds", seconds},
           {"six", six},
           {"lost", errors.fraction_without_estimate},
           {"reset", resets / double(std::max<size_t>(1, joints.frames()))},
           {"swaps", errors.swaps.all},
           {"legs_swapped", errors.swaps.legs},
           {"jitter", jitterOf(found)}};
  if (strip && !pictures.picture().empty()) out["strip"] = packedJpeg(pictures.picture(), kQuality);
  return out;
}

const std::vector<PartVariant>& partVariants() {
  static const Overrides kOriginal = {{"walk_stop", "outliers"}, {"shrink_weight", "0"}};
  static const std::vector<PartVariant> kVariants = {
      {"published", "published", {}},
      {"no_colour", "without colour votes", {{"use_color_votes", "false"}}},
      {"no_shrinking", "without shrinking", {{"shrink_weight", "0"}}},
      {"original",
       "original: Sundaresan's stop, no shrinking, no colours",
       {{"walk_stop", "outliers"}, {"shrink_weight", "0"}, {"use_color_votes", "false"}}},
      {"site_values_combined", "published, several modes per site value", {{"site_modes", "0"}}},
      {"core_by_depth",
       "shrinking by depth, without colour votes",
       {{"shrink_degree", "0"}, {"shrink_weight", "100"}, {"use_color_votes", "false"}}},
      {"merge_tree",
       "merge tree (default)",
       {{"branch_method", "merge_tree"},
        {"modes", "0"},
        {"shrink_weight", "0"},
        {"use_color_votes", "false"},
        {"site_modes", "0"},
        {"max_cost", "2"}}}};
  return kVariants;
}

Json segmentSequence(const Capture& capture) {
  const HsiaoTruth truth = hsiaoTruth(capture);
  HsiaoFilm film(capture, truth, kQuickFit);
  std::vector<BodySegmenter> segmenters;
  for (const PartVariant& variant : partVariants()) {
    Overrides changes;
    for (const auto& [key, value] : variant.changes)
      changes.emplace_back("body_segmentation/" + key, value);
    segmenters.emplace_back(publishedHsiao(truth.stature, changes).segmentation);
  }
  JointTrack frames = truth.points.select(partTruthNames());
  std::vector<std::vector<SegmentedHull>> hulls(segmenters.size());
  JointTrack kept;
  kept.names = frames.names;
  size_t f = 0;
  while (const auto now = film.next()) {
    if (f < frames.frames() && f % kSegmentEvery == 0 && !now->hull.voxels.empty()) {
      kept.add(frames.stamps_ns[f], frames.positions[f]);
      for (size_t s = 0; s < segmenters.size(); ++s)
        hulls[s].push_back(segmentedOf(now->hull, segmenters[s].segment(now->hull)));
    }
    ++f;
  }
  Json out = Json::object();
  for (size_t s = 0; s < segmenters.size(); ++s)
    out[partVariants()[s].name] = partResult(partErrors(kept, hulls[s]));
  return out;
}

}  // namespace markerless_mocap
