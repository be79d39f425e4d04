#include "checks/film_starts.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>

#include "checks/check_rig.h"

namespace markerless_mocap {
namespace {

/// A person of a few points who walks from place to place, at no even pace.
class Walker {
 public:
  /// \param reach how far from the middle of the room, metres along x and y
  explicit Walker(unsigned seed, double reach = 1.4) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-reach, reach), pace(0.5, 1.2), rest(0.0, 1.5);
    for (double time = -100; time < 200;) {
      const Eigen::Vector2d next(place(random), place(random));
      time += places_.empty() ? 0 : (next - places_.back()).norm() / pace(random);
      add(time, next);
      time += rest(random);
      add(time, next);
    }
  }

  Outline outline(const Camera& camera, double time) const {
    const Eigen::Vector2d feet = at(time), ahead = at(time + 0.1) - feet;
    const Eigen::Vector2d side =
        ahead.norm() > 1e-3
            ? Eigen::Vector2d(Eigen::Vector2d(-ahead.y(), ahead.x()) / ahead.norm() * 0.25)
            : Eigen::Vector2d(0.25, 0);
    std::vector<cv::Point2f> points;
    for (const auto& [across, height] :
         {std::pair(0.0, 1.75), std::pair(1.0, 1.45), std::pair(-1.0, 1.45), std::pair(1.0, 0.8),
          std::pair(-1.0, 0.8), std::pair(0.5, 0.0), std::pair(-0.5, 0.0)}) {
      const Eigen::Vector2d foot = feet + across * side;
      const auto pixel = camera.project(Eigen::Vector3d(foot.x(), foot.y(), height));
      if (!pixel) return {};
      points.emplace_back(float(pixel->x()), float(pixel->y()));
    }
    return outlineOf(points, camera.calibration());
  }

 private:
  static Outline outlineOf(const std::vector<cv::Point2f>& points,
                           const CameraCalibration& camera) {
    std::vector<cv::Point2f> hull;
    cv::convexHull(points, hull);
    Outline outline;
    const cv::Moments moments = cv::moments(hull);
    outline.centre = {moments.m10 / moments.m00, moments.m01 / moments.m00};
    outline.area = moments.m00;
    for (const cv::Point2f& corner : hull) {
      outline.hull.emplace_back(corner.x, corner.y);
      outline.cut |= corner.x < 1 || corner.y < 1 || corner.x > float(camera.width - 2) ||
                     corner.y > float(camera.height - 2);
    }
    return outline;
  }

  void add(double time, const Eigen::Vector2d& place) {
    times_.push_back(time);
    places_.push_back(place);
  }
  Eigen::Vector2d at(double time) const {
    const size_t i = size_t(std::upper_bound(times_.begin(), times_.end(), time) - times_.begin());
    const double gap = times_[i] - times_[i - 1];
    const double part = gap > 0 ? (time - times_[i - 1]) / gap : 0;
    return places_[i - 1] + part * (places_[i] - places_[i - 1]);
  }

  std::vector<double> times_;
  std::vector<Eigen::Vector2d> places_;
};

/// Cameras at the height of a chest around a room, all of which see all of it.
std::vector<CameraCalibration> ringOf(int count) {
  std::vector<CameraCalibration> cameras;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count + 0.3;
    CameraCalibration camera;
    camera.name = "cam" + std::to_string(i);
    camera.width = 640;
    camera.height = 480;
    camera.K << 450, 0, 320, 0, 450, 240, 0, 0, 1;
    const Eigen::Vector3d place(4.5 * std::cos(angle), 4.5 * std::sin(angle), 1.3 + 0.2 * (i % 2));
    const Eigen::Vector3d forward = (Eigen::Vector3d(0, 0, 0.9) - place).normalized();
    const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
    camera.T_world_camera.linear() << right, forward.cross(right), forward;
    camera.T_world_camera.translation() = place;
    cameras.push_back(camera);
  }
  return cameras;
}

std::vector<FilmedPerson> filmsOf(const Walker& walker, const std::vector<double>& starts,
                                  double seconds) {
  const std::vector<double> rates = {15, 12.5, 14.985, 15, 12.5};
  const auto cameras = ringOf(int(starts.size()));
  std::vector<FilmedPerson> films;
  for (size_t i = 0; i < starts.size(); ++i) {
    FilmedPerson film;
    film.calibration = cameras[i];
    const Camera camera(cameras[i]);
    for (int k = 0; k < int(seconds * rates[i]); ++k) {
      film.seconds.push_back(k / rates[i]);
      film.outlines.push_back(walker.outline(camera, film.seconds.back() + starts[i]));
    }
    films.push_back(std::move(film));
  }
  return films;
}

void expectStarts(const FilmClocks& clocks, const std::vector<double>& starts) {
  EXPECT_TRUE(clocks.certain()) << clocks.certainty[0] << " " << clocks.certainty[1];
  for (size_t i = 0; i < starts.size(); ++i)
    EXPECT_NEAR(clocks.offsets[i] - clocks.offsets[0], starts[i] - starts[0], 0.03) << i;
}

TEST(FilmStarts, FilmsOfAPersonThatBeganUpToAMinuteApart) {
  const std::vector<double> starts = {0, 23.417, -41.233, 7.062};
  const FilmClocks clocks = personClocks(filmsOf(Walker(1), starts, 90));
  expectStarts(clocks, starts);
  EXPECT_LT(clocks.for_none, 0.6);
}

/// A recording in which all stamps begin at one time, whatever the images show.
SeenRig recordingOf(const std::vector<FilmedPerson>& films) {
  SeenRig rig;
  uint64_t fingerprint = 0;
  for (const FilmedPerson& film : films) {
    SeenCamera camera;
    camera.name = film.calibration.name;
    camera.T_world_camera = film.calibration.T_world_camera;
    SeenInfo info;
    info.width = film.calibration.width;
    info.height = film.calibration.height;
    info.K = film.calibration.K;
    info.frame = camera.name + "_optical";
    camera.infos = {info};
    for (size_t k = 0; k < film.seconds.size(); ++k) {
      SeenImage image;
      image.stamp_ns = image.received_ns = 1000'000'000'000 + std::llround(1e9 * film.seconds[k]);
      image.width = info.width;
      image.height = info.height;
      image.fingerprint = ++fingerprint;
      image.outline = film.outlines[k];
      camera.images.push_back(image);
    }
    rig.cameras.push_back(camera);
  }
  return rig;
}

std::vector<std::string> offsetsIn(const Findings& findings) {
  std::vector<std::string> offsets;
  for (const Finding& finding : findings)
    if (finding.what == "time_offset") {
      const size_t at = finding.evidence.find("the person moves");
      offsets.push_back(finding.camera + ": " +
                        finding.evidence.substr(at, finding.evidence.find(" (") - at));
    }
  std::sort(offsets.begin(), offsets.end());
  return offsets;
}

TEST(FilmStarts, StampsThatAreManySecondsApartAreFindings) {
  const auto found =
      offsetsIn(checkRig(recordingOf(filmsOf(Walker(6), {0, 23.4, 0, -14.2, 0}, 60))));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].substr(0, 31), "cam1: the person moves in it 23");
  EXPECT_NE(found[0].find("s before in the other cameras"), std::string::npos) << found[0];
  EXPECT_EQ(found[1].substr(0, 31), "cam3: the person moves in it 14");
  EXPECT_NE(found[1].find("s later than in the other cameras"), std::string::npos) << found[1];
  EXPECT_TRUE(offsetsIn(checkRig(recordingOf(filmsOf(Walker(6), {0, 0, 0, 0}, 30)))).empty());
}

TEST(FilmStarts, ThreeCamerasSuffice) {
  const std::vector<double> starts = {0, -23.3, 11.2};
  expectStarts(personClocks(filmsOf(Walker(2), starts, 80)), starts);
}

TEST(FilmStarts, FilmsThatBeganTogether) {
  const std::vector<double> starts(5, 0.0);
  const FilmClocks clocks = personClocks(filmsOf(Walker(3), starts, 30));
  expectStarts(clocks, starts);
  EXPECT_GT(clocks.for_none, 0.9);
}

TEST(FilmStarts, SomebodyWhoStandsTellsNothing) {
  std::vector<FilmedPerson> films = filmsOf(Walker(4), {0, 5, 9, 2}, 40);
  for (FilmedPerson& film : films)
    for (Outline& outline : film.outlines) outline = film.outlines.front();
  EXPECT_FALSE(personClocks(films).certain());
}

TEST(FilmStarts, SomebodyWhoStaysOnTheSpotIsNotCertain) {
  const std::vector<double> starts = {0, 5, 9, 2};
  EXPECT_FALSE(personClocks(filmsOf(Walker(4, 0.2), starts, 40)).certain());
  EXPECT_TRUE(personClocks(filmsOf(Walker(4, 0.6), starts, 60)).certain());
}

TEST(FilmStarts, NobodyIsNoError) {
  std::vector<FilmedPerson> films = filmsOf(Walker(5), {0, 5, 9}, 20);
  for (FilmedPerson& film : films)
    for (Outline& outline : film.outlines) outline = {};
  EXPECT_FALSE(personClocks(films).certain());
}

}  // namespace
}  // namespace markerless_mocap
