#include "studies/reproduce/fleischmann/fleischmann_run.h"

#include <cmath>

#include "evaluation/joint_error.h"
#include "fleischmann/fleischmann_pose_estimator.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "resources/resources.h"
#include "ros/package_files.h"
#include "studies/common/cpu_time.h"

namespace markerless_mocap {
namespace {

/// Short in a file. \param steps per unit
Json roundedNumbers(const std::vector<double>& values, double steps) {
  Json out = Json::array();
  for (const double value : values) out.push_back(std::round(value * steps) / steps);
  return out;
}

/// The frames so far.
struct Track {
  JointTrack truth, found;
  Json poses = Json::array(), seconds = Json::array();
  double busy = 0.0;
  int lost = 0;
};

Json resultOf(const Track& track) {
  const JointErrors errors = jointErrors(track.truth, track.found);
  Json out{{"seconds", track.seconds},
           {"D", roundedNumbers(errors.D, 100.0)},
           {"lost", track.lost},
           {"legs_swapped", errors.swaps.legs},
           {"seconds_per_frame", track.busy / double(std::max<size_t>(1, track.truth.frames()))}};
  const auto distances = markerDistances(track.truth, track.found);
  for (size_t m = 0; m < distances.size(); ++m)
    out["markers"][track.truth.names[m]] = roundedNumbers(distances[m], 10.0);
  out["poses"] = track.poses;
  return out;
}

}  // namespace

Eigen::Matrix3Xd markersOf(const FleischmannBodyModel& body_model, const FleischmannVector& v) {
  FleischmannFrames frames;
  body_model.frames(v.data(), frames);
  const std::vector<Eigen::Vector3d> positions = body_model.markers(frames);
  Eigen::Matrix3Xd markers(3, Eigen::Index(positions.size()));
  for (Eigen::Index m = 0; m < markers.cols(); ++m) markers.col(m) = positions[size_t(m)];
  return markers;
}

std::string publishedFleischmannYaml() {
  return readText(packageFile("config/as_published/fleischmann.yaml"));
}

FleischmannOptions fleischmannOptions(const std::string& yaml, const Overrides& changes, int seed) {
  YAML::Node root = YAML::Load(yaml);
  for (const auto& [key, value] : changes) root["pose_fitting"]["fleischmann"][key] = value;
  root["pose_fitting"]["fleischmann"]["seed"] = seed;
  return loadPipelineOptions(root).fitting.fleischmann;
}

Json trackFilm(const Capture& capture, const FilmTruth& truth, const FleischmannVariant& variant,
               int seed) {
  const FleischmannOptions options =
      fleischmannOptions(publishedFleischmannYaml(), variant.changes, seed);
  const FleischmannBodyModel body_model(*truth.body);
  FilmReader film(capture.bag, variant.exact);
  FleischmannPoseEstimator tracker(
      film.rig(), body_model, FleischmannBodyShape(*truth.body, body_model, options.body),
      FleischmannMotionStatistics::fromYaml(motionStatisticsYaml()), options);
  Track track;
  track.truth.names = track.found.names = truth.joints.names;
  FleischmannVector last = truth.poses.front();
  tracker.start(film.next()->stamp_ns, last);
  for (size_t f = 1; const std::optional<FilmFrame> frame = film.next(); ++f) {
    const double start = threadSeconds();
    const FleischmannEstimate pose = tracker.update(frame->stamp_ns, frame->views);
    track.busy += threadSeconds() - start;
    if (pose.status == PoseStatus::kTracked)
      last = pose.v;
    else
      ++track.lost;
    track.truth.add(frame->stamp_ns, truth.joints.positions.at(f));
    track.found.add(frame->stamp_ns, markersOf(body_model, last));
    track.seconds.push_back(1e-9 * double(frame->stamp_ns - truth.joints.stamps_ns.front()));
    track.poses.push_back(
        roundedNumbers({last.data(), last.data() + kFleischmannParameterCount}, 1e5));
  }
  return resultOf(track);
}

}  // namespace markerless_mocap
