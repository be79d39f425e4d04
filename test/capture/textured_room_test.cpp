#include "capture/scene/textured_room.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <stdexcept>

#include "capture/mesh_fixture.h"

namespace markerless_mocap {
namespace {

TEST(TexturedRoomTest, raysEndOnTheBox) {
  const TexturedRoom room(1, 5, 4, 3);
  const Eigen::Vector3d eye(1, 0.5, 1);
  EXPECT_LT((room.at(eye, {1, 0, 0}).position - Eigen::Vector3f(5, 0.5f, 1)).norm(), 1e-6);
  EXPECT_LT((room.at(eye, {0, -2, 0}).position - Eigen::Vector3f(1, -4, 1)).norm(), 1e-6);
  EXPECT_LT((room.at(eye, {0.1, 0, -1}).position - Eigen::Vector3f(1.1f, 0.5f, 0)).norm(), 1e-6);
  EXPECT_LT((room.at(eye, {0, 0.1, 1}).position - Eigen::Vector3f(1, 0.7f, 3)).norm(), 1e-6);
}

TEST(TexturedRoomTest, seedsGiveOtherRooms) {
  const auto picture = [](uint64_t seed) {
    return MeshRenderer(sideCamera(), TexturedRoom(seed, 5, 5, 3.2)).background();
  };
  EXPECT_EQ(cv::norm(picture(1), picture(1), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(picture(1), picture(2), cv::NORM_L1) / (160 * 120 * 3), 5.0);
}

TEST(TexturedRoomTest, hasContrastWithoutBurningOut) {
  for (const uint64_t seed : {1, 2, 3, 4}) {
    const TexturedRoom room(seed, 5, 5, 3.2);
    cv::Scalar mean, deviation;
    cv::meanStdDev(MeshRenderer(sideCamera(), room).background(), mean, deviation);
    EXPECT_GT(mean[1], 70.0);
    EXPECT_LT(mean[1], 190.0);
    EXPECT_GT(deviation[1], 12.0);
    EXPECT_LT(deviation[1], 60.0);
    EXPECT_NEAR(255.0 * room.wallColor().y(), mean[1], 60.0);
  }
}

TEST(TexturedRoomTest, lampsSharesSumToOneUnderTheCeiling) {
  const TexturedRoom room(1, 6, 5, 3);
  float sum = 0.0f;
  for (const Lamp& lamp : room.lamps()) {
    sum += lamp.fraction;
    EXPECT_LT(lamp.position.cwiseAbs().x(), 6.0f);
    EXPECT_LT(lamp.position.cwiseAbs().y(), 5.0f);
    EXPECT_LT(lamp.position.z(), 3.0f);
    EXPECT_GT(lamp.position.z(), 2.5f);
  }
  EXPECT_NEAR(sum, 1.0f, 1e-6f);
}

TEST(TexturedRoomTest, surroundsTheRig) {
  CameraCalibration far = sideCamera().calibration();
  far.T_world_camera.translation() << 2, -7, 4;
  const TexturedRoom room = TexturedRoom::around(1, {sideCamera(), Camera(far)});
  EXPECT_GT(room.halfSize().y(), 8.0f);
  EXPECT_GT(room.halfSize().z(), 4.2f);
  far.T_world_camera.translation() << 2, -7, -1;
  EXPECT_THROW(TexturedRoom::around(1, {Camera(far)}), std::invalid_argument);
  far.T_world_camera.translation() << 2, -70, 1;
  EXPECT_THROW(TexturedRoom::around(1, {Camera(far)}), std::invalid_argument);
}

TEST(TexturedRoomTest, impossibleSizesAreRefused) {
  EXPECT_THROW(TexturedRoom(1, 0.5, 5, 3), std::invalid_argument);
  EXPECT_THROW(TexturedRoom(1, 5, 60, 3), std::invalid_argument);
  EXPECT_THROW(TexturedRoom(1, 5, 5, 1), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
