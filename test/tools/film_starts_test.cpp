#include <opencv2/videoio.hpp>

#include "capture/studio_fixture.h"
#include "markerless_mocap/camera/rig_file.h"
#include "tools/import/import_recording.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr double kRate = 12.0, kSeconds = 34.0, kFilmed = 20.0;

/// Videos of a rendered person that were started by hand.
class ImportStarts : public ToolTest {
 protected:
  ImportStarts() {
    input_.films = {path("films")};
    input_.calibration = {path("rig.yaml")};
    options_.output = path("out.bag");
    std::filesystem::create_directories(path("films"));
  }

  /// Somebody who goes here and there for half a minute.
  void writeErrands() const {
    writeText("motions/errands.yaml",
              "seconds: 34.0\nstart: {x: -0.6, y: -0.4, heading: 0, width: 0.09}\npath:\n"
              "  - stand: 0.8\n  - {go: 1.3, turn: 111, seconds: 1.6}\n"
              "  - {go: 1.4, turn: 194, seconds: 2.7}\n"
              "  - {go: 1.7, turn: 69, seconds: 1.9}\n  - stand: 1.2\n"
              "  - {go: 0.6, turn: 137, seconds: 1.2}\n"
              "  - {go: 0.7, turn: 222, seconds: 1.3}\n  - stand: 1.9\n"
              "  - {go: 0.7, turn: 203, seconds: 1.3}\n"
              "  - {go: 1.7, turn: -93, seconds: 2.3}\n  - stand: 0.6\n"
              "  - {go: 0.5, turn: -91, seconds: 0.8}\n  - stand: 1.5\n"
              "  - {go: 0.9, turn: -87, seconds: 1.1}\n"
              "  - {go: 0.8, turn: -9, seconds: 0.9}\n  - stand: 2.0\n"
              "  - {go: 0.4, turn: 115, seconds: 0.7}\n  - stand: 1.7\n"
              "  - {go: 0.4, turn: -209, seconds: 1.1}\n"
              "  - {go: 0.7, turn: 118, seconds: 1.0}\n"
              "  - {go: 0.5, turn: 205, seconds: 1.2}\n  - stand: 1.4\n"
              "  - {go: 1.7, turn: -74, seconds: 1.8}\n"
              "tracks:\n  arm_swing: [[0, 1]]\n");
  }

  void film(const std::vector<double>& starts) const {
    writeErrands();
    StudioOptions options;
    options.rig = "ring4";
    options.width = 320;
    options.height = 240;
    options.fps = kRate;
    options.duration = kSeconds;
    options.background_frames = 0;
    options.motion = "errands";
    const StudioFiles package = packageFiles();
    const VirtualStudio studio(options, {package.urdf_template, path("motions")}, "person1");
    std::vector<CameraCalibration> rig;
    std::vector<cv::VideoWriter> films;
    for (const Camera& camera : studio.rig()) {
      rig.push_back(camera.calibration());
      films.emplace_back(path("films/" + rig.back().name + ".avi"),
                         cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), kRate, cv::Size(320, 240));
    }
    writeRig(path("rig.yaml"), rig);
    for (int k = 0; k < studio.frameSetCount(); ++k) {
      const StudioFrameSet frames = studio.render(k);
      for (size_t i = 0; i < films.size(); ++i)
        if (const double time = k / kRate - starts[i]; time > -1e-6 && time < kFilmed)
          films[i].write(frames.images[i]);
    }
  }

  FilmsInput input_;
  ImportOptions options_;
};

TEST_F(ImportStarts, FilmsOfAPersonAreJoinedByTheirMotion) {
  const std::vector<double> starts = {4.0, 0.0, 11.5, 6.0};  // s
  film(starts);
  const ImportResult result = importFilms(input_, options_, nullptr, false);
  int found = 0;
  for (const std::string& note : result.warnings) {
    char camera[20];
    double later = 0;
    if (std::sscanf(note.c_str(), "the film of %19s began %lf s after that of cam1", camera,
                    &later) != 2)
      continue;
    ++found;
    EXPECT_NEAR(later, starts[size_t(camera[3] - '0')], 1 / kRate) << note << ", to a frame";
  }
  EXPECT_EQ(found, 3);
  EXPECT_NEAR(result.frame_sets, (kFilmed - 11.5) * kRate, 4);
}

}  // namespace
}  // namespace markerless_mocap
