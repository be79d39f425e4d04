#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "capture/ground_truth.h"
#include "capture/studio_fixture.h"
#include "capture/virtual_studio.h"
#include "evaluation/body_points.h"
#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {
namespace {

/// Four cameras at 24 Hz, filmed five times as fast, so that each may take its image at its own
/// time.
constexpr int kFilmedHz = 120, kEvery = 5, kFrameSets = 24;
constexpr int kFast = 12;          ///< the arms are raised at 2 to 3 m/s from this frame set on
using Turns = std::array<int, 4>;  ///< by camera: how many filmed frames later than the middle

StudioOptions studioOptions() {
  StudioOptions options;
  options.motion = "wave";
  options.rig = "ring4";
  options.width = 480;
  options.height = 360;
  options.fps = kFilmedHz;
  options.background_frames = 0;
  options.duration = double(kFrameSets * kEvery) / kFilmedHz;
  return options;
}

class CamerasInTurn : public testing::Test {
 protected:
  CamerasInTurn() : studio_(studioOptions(), packageFiles(), "person1") {
    for (int i = 0; i < studio_.frameSetCount(); ++i) filmed_.push_back(studio_.render(i));
  }

  /// Root mean square error of the wrists, m. \param told whether the frame sets say when each
  /// image was taken
  double wristError(const Turns& turns, bool told) const {
    PipelineOptions options;
    options.fitting.person.measure = false;
    Pipeline pipeline(studio_.rig(), PersonResources::standard(), options);
    const BodyModel& model = *pipeline.body()->model;
    double sum = 0.0;
    int count = 0;
    for (int k = 1; k + 1 < kFrameSets; ++k) {
      std::vector<CameraFrame> frames;
      for (size_t c = 0; c < turns.size(); ++c)
        frames.push_back({cv::Mat(), filmed_[size_t(k * kEvery + turns[c])].silhouettes[c],
                          told ? double(turns[c]) / kFilmedHz : 0.0});
      const PipelineResult result = pipeline.process(filmed_[size_t(k * kEvery)].time_ns, frames);
      if (k < kFast || result.pose.status == PoseStatus::kLost) continue;
      LinkPoses T_world_link;
      model.forwardKinematics(result.pose.T_world_body, result.pose.angles, T_world_link);
      const Eigen::Matrix3Xd found = bodyPoints(model, T_world_link);
      for (const char* wrist : {"l_wrist", "r_wrist"}) {
        sum += (found.col(columnOf(bodyPointNames(), wrist)) -
                filmed_[size_t(k * kEvery)].points[size_t(columnOf(groundTruthNames(), wrist))])
                   .squaredNorm();
        ++count;
      }
    }
    EXPECT_EQ(count, 2 * (kFrameSets - 1 - kFast)) << "frames without a pose";
    return std::sqrt(sum / count);
  }

  static Eigen::Index columnOf(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  }

  VirtualStudio studio_;
  std::vector<StudioFrameSet> filmed_;
};

TEST_F(CamerasInTurn, HandsAreWhereTheyAreAtTheTimeOfTheFrameSet) {
  const double in_step = wristError({0, 0, 0, 0}, true);
  const double in_turn = wristError({-2, -1, 1, 2}, true);
  const double unaware = wristError({-2, -1, 1, 2}, false);
  std::cout << "wrists, mm: in step " << 1e3 * in_step << ", in turn " << 1e3 * in_turn
            << ", taken as if in step " << 1e3 * unaware << std::endl;
  EXPECT_LT(in_turn - in_step, 0.5 * (unaware - in_step));
  EXPECT_GT(unaware, in_step + 0.01) << "it tells nothing if the hands are slow";
}

}  // namespace
}  // namespace markerless_mocap
