#include "markerless_mocap/region/person_mask.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "body/body_fixture.h"
#include "error_text_of.h"
#include "evaluation/body_silhouette.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

const cv::Scalar kWall(150, 140, 90), kShirt(40, 40, 190), kBox(30, 90, 120);

Camera frontCamera() {
  CameraCalibration calibration;
  calibration.name = "front";
  calibration.width = 640;
  calibration.height = 480;
  calibration.K << 600, 0, 319.5, 0, 600, 239.5, 0, 0, 1;
  calibration.T_world_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  calibration.T_world_camera.translation() = Eigen::Vector3d(-3, 0, 0.9);
  return Camera(calibration);
}

/// Somebody who stands before a wall, with the arms away from the body.
class PersonMaskTest : public ::testing::Test {
 protected:
  PersonMaskTest() {
    pose.status = PoseStatus::kTracked;
    pose.T_world_body.translation() << 0, 0, 0.92;
    pose.part_seen.fill(true);
    pose.angles = Eigen::VectorXd::Zero(model->angleCount());
    LinkPoses T_world_link;
    model->forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
    person = bodySilhouette(*model, T_world_link, camera);
    silhouette = person.clone();
    image = cv::Mat(person.size(), CV_8UC3, kWall);
    image.setTo(kShirt, person);
    shape = cv::boundingRect(person);
  }

  /// Something behind the person that differs from the background.
  void put(const cv::Rect& thing, const cv::Scalar& color) {
    silhouette(thing).setTo(kPersonPixel);
    cv::Mat shown = image(thing);
    shown.setTo(color, ~person(thing));
  }
  cv::Rect boxAtTheLegs() const { return {shape.x + shape.width / 2, shape.br().y - 90, 140, 90}; }
  cv::Mat found() const { return personMask(camera, *model, pose, silhouette, image); }
  double overlap() const { return maskIou(found(), person); }

  const std::shared_ptr<const BodyModel> model = testBody();
  const Camera camera = frontCamera();
  BodyPose pose;
  cv::Mat person, silhouette, image;
  cv::Rect shape;
};

TEST_F(PersonMaskTest, ThePersonAloneStays) {
  ASSERT_GT(cv::countNonZero(person), 20000);
  EXPECT_EQ(cv::norm(found(), person, cv::NORM_INF), 0.0);
}

TEST_F(PersonMaskTest, ABystanderIsLeftOut) {
  put({20, 100, 60, 250}, kBox);
  EXPECT_EQ(cv::norm(found(), person, cv::NORM_INF), 0.0);
}

TEST_F(PersonMaskTest, ColoursTellABoxFromTheLegs) {
  put(boxAtTheLegs(), kBox);
  ASSERT_LT(maskIou(silhouette, person), 0.85);
  EXPECT_GT(overlap(), 0.96);
}

TEST_F(PersonMaskTest, WithoutColoursTheBoxIsUnknownNearTheBodyOnly) {
  put(boxAtTheLegs(), kBox);
  cv::cvtColor(image, image, cv::COLOR_BGR2GRAY);
  const cv::Mat mask = found();
  EXPECT_EQ(mask.at<uchar>(boxAtTheLegs().br() - cv::Point(5, 5)), kBackgroundPixel);
  EXPECT_GT(cv::countNonZero(mask == kUnknownPixel), 300);
  EXPECT_LT(cv::countNonZero((mask == kUnknownPixel) & (person != 0)), 100)
      << "cells at its border";
  image = cv::Mat();
  EXPECT_EQ(cv::norm(found(), mask, cv::NORM_INF), 0.0);
}

TEST_F(PersonMaskTest, AnUnknownBackgroundIsFilledByColour) {
  silhouette.setTo(kUnknownPixel, cv::Mat(silhouette == 0));
  silhouette(cv::Rect(0, 0, 640, shape.y + shape.height / 2)).setTo(kUnknownPixel);
  EXPECT_GT(overlap(), 0.96);
  EXPECT_EQ(cv::countNonZero(found() == kUnknownPixel), 0);
}

TEST_F(PersonMaskTest, AHoleInTheMiddleIsFilled) {
  const cv::Point chest(shape.x + shape.width / 2, shape.y + shape.height / 3);
  ASSERT_EQ(person.at<uchar>(chest), kPersonPixel);
  cv::circle(silhouette, chest, 9, kBackgroundPixel, cv::FILLED);
  EXPECT_EQ(found().at<uchar>(chest), kPersonPixel);
}

TEST_F(PersonMaskTest, WhatATableOfTheEmptyRoomHidesIsNotFilled) {
  const cv::Rect table(0, shape.br().y - shape.height / 2, 640, shape.height / 2);
  silhouette(table).setTo(kBackgroundPixel);
  image(table).setTo(kBox);
  pose.part_seen[size_t(PartLabel::kLeg1)] = pose.part_seen[size_t(PartLabel::kLeg2)] = false;
  person = silhouette.clone();
  EXPECT_GT(overlap(), 0.9);
  EXPECT_EQ(cv::countNonZero(found()(cv::Rect(0, table.y + 60, 640, table.height - 60))), 0);
}

TEST_F(PersonMaskTest, SomebodyOutsideTheViewIsNotInTheMask) {
  put({20, 100, 60, 250}, kBox);
  pose.T_world_body.translation().y() = 8;
  EXPECT_EQ(cv::countNonZero(found()), 0);
}

TEST_F(PersonMaskTest, BadInputIsRefused) {
  const auto error = [this] { return errorTextOf<std::invalid_argument>([this] { found(); }); };
  silhouette = silhouette(cv::Rect(0, 0, 320, 480));
  EXPECT_EQ(error(),
            "the silhouette of camera 'front' must have one channel of 8 bits and the size "
            "of its image");
  pose.status = PoseStatus::kLost;
  EXPECT_EQ(error(), "a mask of the person needs a pose that is not lost");
}

}  // namespace
}  // namespace markerless_mocap
