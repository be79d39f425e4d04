#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/formats/calibration_files.h"
#include "tools/common/film_times.h"
#include "tools/common/recording.h"
#include "tools/import/film.h"
#include "tools/import/film_calibration.h"
#include "tools/import/import_recording.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

class ImportFilms : public ToolTest {
 protected:
  ImportFilms() {
    input_.films = {path("films")};
    input_.calibration = {path("rig.yaml")};
    options_.output = path("out.bag");
    std::filesystem::create_directories(path("films"));
    writeRig(path("rig.yaml"), ringOfFour());
  }

  /// Frames of one grey each, which tells their number: 10, 12, 14 ...
  static cv::Mat frameOf(int k) { return cv::Mat(60, 80, CV_8UC3, cv::Scalar::all(10 + 2 * k)); }
  static int numberOf(const cv::Mat& image) {
    return image.empty() ? -1 : int(std::lround((cv::mean(image)[0] - 10.0) / 2.0));
  }

  void writeImages(const std::string& camera, int frames) const {
    std::filesystem::create_directories(path("films/" + camera));
    for (int k = 0; k < frames; ++k)
      cv::imwrite(path("films/" + camera + "/" + std::to_string(k) + ".png"), frameOf(k));
  }
  void writeVideo(const std::string& camera, int frames, double fps) const {
    cv::VideoWriter video(path("films/" + camera + ".avi"),
                          cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), fps, {80, 60});
    for (int k = 0; k < frames; ++k) video.write(frameOf(k));
  }
  /// \param times by camera
  void writeTimes(const std::vector<std::vector<double>>& times) const {
    std::string text = "sync_index,cam_id,frame_time\n";
    for (size_t i = 0; i < times.size(); ++i)
      for (const double time : times[i])
        text += "0," + std::to_string(i) + "," + std::to_string(time) + "\n";
    writeText("timestamps.csv", text);
  }

  ImportResult import() const { return importFilms(input_, options_, nullptr, false); }
  std::string refusal() const {
    return errorTextOf<std::exception>([&] { import(); });
  }
  /// When an image was taken, s after the beginning of the bag.
  static double timeOf(const FrameSet& frame_set, size_t camera) {
    return 1e-9 * double(frame_set.stamp_ns) - 1.0 + frame_set.frames[camera].later_s;
  }
  std::vector<FrameSet> written() const {
    Recording recording(options_.output, {});
    std::vector<FrameSet> frame_sets;
    while (auto frame_set = recording.next()) {
      for (CameraFrame& frame : frame_set->frames) frame.image = frame.image.clone();
      frame_sets.push_back(std::move(*frame_set));
    }
    return frame_sets;
  }

  FilmsInput input_;
  ImportOptions options_;
};

TEST_F(ImportFilms, FilmsOfAnyRateAreJoinedAtTheTimesOfTheSlowest) {
  writeVideo("cam_0", 12, 30.0);
  writeVideo("cam_1", 4, 10.0);
  writeImages("cam_2", 10);  // 25 per second
  writeVideo("cam_3", 24, 60.0);
  const ImportResult result = import();
  EXPECT_EQ(result.fps, 10.0);
  EXPECT_EQ(result.frame_sets, 4);
  EXPECT_EQ(result.cameras[2].name, "cam2");
  const auto frame_sets = written();
  ASSERT_EQ(frame_sets.size(), 4u);
  const int third[] = {0, 2, 5, 7};  // 0, 0.08, 0.2, 0.28 s
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(timeOf(frame_sets[k], 1), 0.1 * k, 1e-6);
    EXPECT_NEAR(timeOf(frame_sets[k], 2), 0.04 * numberOf(frame_sets[k].frames[2].image), 1e-6);
    EXPECT_EQ(numberOf(frame_sets[k].frames[0].image), 3 * k);
    EXPECT_EQ(numberOf(frame_sets[k].frames[1].image), k);
    EXPECT_NEAR(numberOf(frame_sets[k].frames[2].image), third[k], k % 2);
    EXPECT_EQ(numberOf(frame_sets[k].frames[3].image), 6 * k);
  }
}

TEST_F(ImportFilms, TimesOfATableReplaceThoseOfTheFilmsAndGapsStayGaps) {
  for (int i = 0; i < 4; ++i) writeImages("cam" + std::to_string(i), i == 2 ? 5 : 6);
  std::vector<std::vector<double>> times(4);
  for (int k = 0; k < 6; ++k) {
    times[0].push_back(25.0 + 0.1 * k);
    times[1].push_back(25.013 + 0.1 * k);
    if (k != 3) times[2].push_back(24.98 + 0.1 * k);  // one frame was dropped
    times[3].push_back(24.8 + 0.1 * k);               // started 0.2 s earlier
  }
  writeTimes(times);
  input_.times = path("timestamps.csv");
  const ImportResult result = import();
  const auto frame_sets = written();
  ASSERT_GE(frame_sets.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(numberOf(frame_sets[k].frames[0].image), k);
    EXPECT_EQ(numberOf(frame_sets[k].frames[1].image), k);
    EXPECT_EQ(numberOf(frame_sets[k].frames[2].image), k == 3 ? -1 : k);
    EXPECT_EQ(numberOf(frame_sets[k].frames[3].image), k + 2);
    EXPECT_NEAR(timeOf(frame_sets[k], 1) - timeOf(frame_sets[k], 0), 0.013, 1e-6);
    if (k != 3) {
      EXPECT_NEAR(timeOf(frame_sets[k], 2) - timeOf(frame_sets[k], 0), -0.02, 1e-6);
    }
  }
  EXPECT_EQ(result.warnings.at(result.warnings.size() - 3),
            "cam1: 4 frames used, 13.0 ms from their frame sets on average, 13.0 ms at most");
}

TEST_F(ImportFilms, AFilmHalfAnIntervalOutOfStepLosesNoFrames) {
  for (int i = 0; i < 4; ++i) writeImages("cam" + std::to_string(i), 12);
  std::vector<std::vector<double>> times(4);
  for (int k = 0; k < 12; ++k)
    for (int i = 0; i < 4; ++i)
      times[i].push_back(5.0 + 0.1 * k + (i == 2 ? 0.05 + 0.004 * (k % 3 - 1) : 0.0));
  writeTimes(times);
  input_.times = path("timestamps.csv");
  import();
  const auto frame_sets = written();
  ASSERT_GE(frame_sets.size(), 10u);
  for (const FrameSet& set : frame_sets) {
    ASSERT_FALSE(set.frames[2].image.empty());
    EXPECT_EQ(std::abs(numberOf(set.frames[2].image) - numberOf(set.frames[0].image) + 0.5), 0.5);
    EXPECT_NEAR(std::abs(timeOf(set, 2) - timeOf(set, 0)), 0.05, 0.005);
  }
}

TEST_F(ImportFilms, FramesWithoutATimeInTheTableAreToldAndLeftOut) {
  std::vector<std::vector<double>> times(4);
  for (size_t i = 0; i < 4; ++i) {
    writeImages("cam" + std::to_string(i), 6);
    for (int k = 0; k < (i == 1 ? 4 : 6); ++k) times[i].push_back(5.0 + 0.1 * k);
  }
  writeTimes(times);
  input_.times = path("timestamps.csv");
  const ImportResult result = import();
  const std::string told = "cam1 has 6 frames, " + path("timestamps.csv") +
                           " has times of the first 4: the others are left out";
  EXPECT_EQ(std::count(result.warnings.begin(), result.warnings.end(), told), 1);
  const auto frame_sets = written();
  ASSERT_EQ(frame_sets.size(), 4u);  // as long as all cameras have frames
  for (int k = 0; k < 4; ++k) EXPECT_EQ(numberOf(frame_sets[k].frames[1].image), k);
}

TEST_F(ImportFilms, ATableBesideTheFilmsIsUsedUnaskedAndTold) {
  for (int i = 0; i < 4; ++i) writeImages("cam" + std::to_string(i), 6);
  std::vector<std::vector<double>> times(4);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 6; ++k) times[i].push_back(5.0 + 0.04 * k - (i == 3 ? 0.08 : 0.0));
  writeTimes(times);
  std::filesystem::rename(path("timestamps.csv"), path("films/timestamps.csv"));
  const ImportResult result = import();
  EXPECT_EQ(result.warnings.at(0), "the times are those of " + path("films/timestamps.csv") +
                                       ", which lies beside the films");
  const auto frame_sets = written();
  ASSERT_EQ(frame_sets.size(), 4u);
  for (const FrameSet& set : frame_sets)
    EXPECT_EQ(numberOf(set.frames[3].image), numberOf(set.frames[0].image) + 2);
}

TEST_F(ImportFilms, TimeOffsetsOfTheRigGoIntoTheStamps) {
  for (int i = 0; i < 4; ++i) writeImages("cam" + std::to_string(i), 8);
  auto rig = ringOfFour();
  rig[1].time_offset = 0.08;  // its frame 0 is at the time of frame 2 of the others
  writeRig(path("rig.yaml"), rig);
  const ImportResult result = import();
  EXPECT_EQ(result.cameras[1].time_offset, 0.0);
  const auto frame_sets = written();
  ASSERT_GE(frame_sets.size(), 5u);
  for (const FrameSet& set : frame_sets)
    EXPECT_EQ(numberOf(set.frames[0].image), numberOf(set.frames[1].image) + 2);
}

TEST_F(ImportFilms, MasksBelongToTheFramesOfTheirFilm) {
  for (int i = 0; i < 4; ++i) {
    const std::string camera = "cam" + std::to_string(i);
    writeVideo(camera, 3, 15.0);
    std::filesystem::create_directories(path("masks/" + camera));
    for (int k = 0; k < 3; ++k)
      cv::imwrite(path("masks/" + camera + "/" + std::to_string(k) + ".png"),
                  k == 1 ? smallMask() : cv::Mat(60, 80, CV_8UC1, cv::Scalar(128)));
  }
  input_.masks = path("masks");
  import();
  RecordingOptions reading;
  reading.use_masks = true;
  Recording recording(options_.output, reading);
  std::vector<FrameSet> frame_sets;
  while (auto frame_set = recording.next()) frame_sets.push_back(std::move(*frame_set));
  ASSERT_EQ(frame_sets.size(), 3u);
  EXPECT_EQ(cv::norm(frame_sets[1].frames[3].mask, smallMask(), cv::NORM_INF), 0.0);
  EXPECT_EQ(frame_sets[2].frames[0].mask.at<uchar>(5, 5), 128);
  std::filesystem::remove(path("masks/cam2/2.png"));
  std::filesystem::remove(options_.output);
  EXPECT_EQ(refusal(), "the masks of " + path("films/cam2.avi") + " end after 2 frames");
}

TEST_F(ImportFilms, UnitsAndAxesOfTheCalibrationAreFound) {
  for (int i = 0; i < 4; ++i) writeImages("cam" + std::to_string(i), 2);
  writeCalibration(path("Calib.qca.txt"), CalibrationFormat::kQualisys, ringOfFour());
  input_.calibration = {path("Calib.qca.txt")};
  const ImportResult result = import();
  EXPECT_TRUE(result.cameras[2].T_world_camera.isApprox(ringOfFour()[2].T_world_camera, 1e-9));
  EXPECT_EQ(result.warnings[0].substr(0, 73),
            "the calibration is Qualisys .qca.txt, its unit 0.001 m (the format's), up");
}

TEST_F(ImportFilms, FoldersOfNoCameraAreLeftOutIfEveryCameraHasAFilm) {
  for (int i = 0; i < 4; ++i) writeImages("cam" + std::to_string(i), 2);
  writeImages("calibration", 2);
  const ImportResult result = import();
  EXPECT_EQ(result.cameras.size(), 4u);
  EXPECT_EQ(result.warnings.at(1),
            path("films/calibration") + " belongs to no camera of the calibration and is left out");
}

TEST_F(ImportFilms, FilmsAreNamedOneByOneOrLieInFoldersOfTheirCameras) {
  for (int i = 0; i < 4; ++i) writeVideo("cam" + std::to_string(i), 3, 25.0);
  std::filesystem::create_directories(path("films/cam3"));
  std::filesystem::rename(path("films/cam3.avi"), path("films/cam3/video.avi"));
  EXPECT_EQ(import().frame_sets, 3);
  std::filesystem::remove(options_.output);
  std::filesystem::rename(path("films/cam3/video.avi"), path("cam3.avi"));
  input_.films = {path("films/cam1.avi"), path("films/cam0.avi"), path("cam3.avi"),
                  path("films/cam2.avi")};
  const ImportResult result = import();
  EXPECT_EQ(result.frame_sets, 3);
  EXPECT_EQ(result.cameras.at(0).name, "cam1");
  EXPECT_EQ(result.cameras.at(2).name, "cam3");
  input_.films.push_back(path("cam4.avi"));
  EXPECT_EQ(refusal(), "there is no file or folder " + path("cam4.avi"));
}

TEST_F(ImportFilms, FilmsOfTheEmptyRoomComeFirst) {
  for (int i = 0; i < 4; ++i) {
    const std::string camera = "cam" + std::to_string(i);
    writeImages(camera, 3);
    std::filesystem::create_directories(path("empty/" + camera));
    for (int k = 0; k < (i == 2 ? 2 : 5); ++k)
      cv::imwrite(path("empty/" + camera + "/" + std::to_string(k) + ".png"), frameOf(50 + k));
  }
  input_.background = {path("empty")};
  const ImportResult result = import();
  EXPECT_EQ(result.frame_sets, 5);  // the shortest film of the room has two frames
  EXPECT_NE(std::find(result.warnings.begin(), result.warnings.end(),
                      "the first 2 frame sets are of the empty room"),
            result.warnings.end());
  const auto frame_sets = written();
  ASSERT_EQ(frame_sets.size(), 5u);
  const int wanted[] = {50, 51, 0, 1, 2};
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(frame_sets[k].stamp_ns, 1000000000 + k * 40000000);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(numberOf(frame_sets[k].frames[i].image), wanted[k]);
  }
  cv::imwrite(path("empty/cam1/0.png"), cv::Mat(30, 40, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_EQ(refusal(), "the film of the empty room " + path("empty/cam1") + " is 40 x 30 pixels, " +
                           path("films/cam1") + " is 80 x 60");
}

TEST_F(ImportFilms, WhatDoesNotBelongTogetherIsTold) {
  EXPECT_EQ(refusal(),
            "the folder " + path("films") + " has no videos and no folders with images or a video");
  writeImages("cam7", 2);
  EXPECT_EQ(
      refusal(),
      "no camera of the calibration is called like the film cam7, there are cam0, cam1, cam2, "
      "cam3 and the films cam7");
  ASSERT_EQ(mkfifo(path("pipe.mp4").c_str(), 0600), 0);
  EXPECT_EQ(errorTextOf<std::exception>([&] { Film(path("pipe.mp4"), 25.0); }),
            "cannot read the film " + path("pipe.mp4") +
                ": it is a folder, pipe or device, allowed are files");
  std::filesystem::rename(path("films/cam7"), path("films/cam3"));
  writeImages("03", 2);
  EXPECT_EQ(refusal(),
            "two films belong to the camera of the calibration cam3, the films are 03, cam3");
  std::filesystem::remove_all(path("films/03"));
  writeText("timestamps.csv", "sync_index,cam_id,frame_time\n0,3,soon\n");
  input_.times = path("timestamps.csv");
  EXPECT_EQ(refusal(),
            path("timestamps.csv") + ", line 2: frame_time is 'soon', allowed are seconds");
  writeText("timestamps.csv", "a,b\n");
  EXPECT_EQ(refusal(), path("timestamps.csv") +
                           ": there is no column cam_id in the head line, wanted are cam_id and "
                           "frame_time");
  EXPECT_FALSE(std::filesystem::exists(options_.output));
}

TEST_F(ImportFilms, SizesOfFilmAndCalibrationAreMadeToAgree) {
  writeImages("cam0", 1);
  Film film(path("films/cam0"), 25.0);
  std::vector<std::string> notes;
  CameraCalibration camera = ringOfFour()[0];
  const Eigen::Vector3d point(0.1, 0.2, 1.3);
  const Eigen::Vector2d pixel = *Camera(camera).project(point);
  camera.width = 160;  // calibrated at twice the size
  camera.height = 120;
  camera.K.topRows<2>() *= 2.0;
  camera.K(0, 2) += 0.5;
  camera.K(1, 2) += 0.5;
  agreeInSize(&camera, &film, &notes);
  EXPECT_TRUE(Camera(camera).project(point)->isApprox(pixel, 1e-9));
  EXPECT_EQ(notes.at(0), "the calibration of cam0, 160 x 120, is scaled to the film's 80 x 60");
  camera.width = 90;
  EXPECT_EQ(errorTextOf([&] { agreeInSize(&camera, &film, &notes); }),
            "the film of cam0 is 80 x 60 pixels, the calibration is of 90 x 60");
  camera = ringOfFour()[0];
  camera.height = 0;
  camera.width = 0;
  agreeInSize(&camera, &film, &notes);
  EXPECT_EQ(camera.width, 80);
}

}  // namespace
}  // namespace markerless_mocap
