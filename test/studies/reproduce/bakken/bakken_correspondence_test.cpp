// A quarter of a second of the dance in which both legs are near each other.
#include "studies/reproduce/bakken/bakken_correspondence.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "resources/resources.h"
#include "tools/common/studio_settings.h"
#include "tools/render/render_capture.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

/// Exchanges in pairs of frames that are labelled right, sides included; by step.
std::map<int, int> exchangesIn(const Capture& capture, int edge) {
  const Json found = followLabels(capture, edge);
  std::map<int, int> exchanges;
  for (const Json& every : found["every"]) {
    EXPECT_GT(every["pairs"].get<int>(), 0);
    exchanges[every["step"].get<int>()] = every["exchanged"].get<int>();
  }
  return exchanges;
}

// Figure 7.
TEST(BakkenCorrespondence, LegsChangePlacesWhileSidesAreRight) {
  Capture capture{"dance",
                  {{"motion", "whirling_dance"},
                   {"motion_start", "6.75"},
                   {"rig", "ring7_overhead"},
                   {"width", "400"},
                   {"height", "300"},
                   {"fps", "30"},
                   {"duration", "0.25"},
                   {"background_frames", "0"},
                   {"stature", "1.62"},
                   {"male", "0.1"}}};
  const fs::path bag = fs::temp_directory_path() / ("mocap_legs_" + std::to_string(getpid()));
  RenderOptions render;
  render.studio = readStudioOptions("", capture.studio);
  render.files = {humanUrdfTemplate(), std::string(MOCAP_SOURCE_DIR) + "/config/motions"};
  render.images = "none";
  render.masks = true;
  render.output = capture.bag = bag;
  renderCapture(render, nullptr, false);
  const std::map<int, int> coarse = exchangesIn(capture, 64), fine = exchangesIn(capture, 128);
  fs::remove(bag);
  EXPECT_GE(coarse.at(1) + fine.at(4), 1) << "every frame at 64, every fourth at 128 voxels";
  EXPECT_EQ(fine.at(1), 0) << "every frame at 128 voxels";
}

}  // namespace
}  // namespace markerless_mocap
