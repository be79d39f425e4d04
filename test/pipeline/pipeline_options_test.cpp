#include <gtest/gtest.h>

#include <stdexcept>

#include "error_text_of.h"
#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {
namespace {

std::string refusal(const std::string& yaml) {
  return errorTextOf([&] { loadPipelineOptions(YAML::Load(yaml)); });
}

TEST(PipelineOptions, EmptyConfigurationKeepsDefaults) {
  const PipelineOptions options = loadPipelineOptions(YAML::Load(""));
  EXPECT_EQ(options.hull.pitch, HullOptions().pitch);
}

// docs/papers.md.
TEST(PipelineOptions, FleischmannAsPublishedIsRead) {
  const PipelineOptions options =
      loadPipelineOptions(YAML::LoadFile(MOCAP_SOURCE_DIR "/config/as_published/fleischmann.yaml"));
  EXPECT_EQ(options.fitting.method, "fleischmann");
  const FleischmannOptions& published = options.fitting.fleischmann;
  EXPECT_FALSE(published.include_start_particle);  // Algorithm 2
  EXPECT_FALSE(published.reconsider);
  EXPECT_EQ(published.min_silhouette_fitness, 0.0);
  EXPECT_EQ(published.body.collision_pairs, "all");
  EXPECT_GT(published.swarm.crossover, 0.0);
  EXPECT_TRUE(published.swarm.carry_particles);
}

TEST(PipelineOptions, EachSectionReachesItsStage) {
  const PipelineOptions options = loadPipelineOptions(
      YAML::Load("{silhouette: {background_frames: 7}, visual_hull: {pitch: 0.05}, "
                 "body_segmentation: {modes: 6}, pose_tree: {prune_ratio: 0.1}, pose_fitting: "
                 "{stature: 1.6}}"));
  EXPECT_EQ(options.silhouette.background_frames, 7);
  EXPECT_EQ(options.hull.pitch, 0.05);
  EXPECT_EQ(options.segmentation.modes, 6);
  EXPECT_EQ(options.pose_tree.prune_ratio, 0.1);
  EXPECT_EQ(options.fitting.person.stature, 1.6);
}

TEST(PipelineOptions, UnknownSectionNamesTheNearestOne) {
  EXPECT_EQ(refusal("{visual_hul: {pitch: 0.02}}"),
            "configuration/visual_hul is not an option (value {pitch: 0.02}), did you mean "
            "visual_hull?");
}

TEST(PipelineOptions, UnknownKeyNamesItsSection) {
  EXPECT_EQ(refusal("{visual_hull: {pich: 0.02}}"),
            "visual_hull/pich is not an option (value 0.02), did you mean pitch?");
}

TEST(PipelineOptions, ListInPlaceOfSectionsIsRefused) {
  EXPECT_EQ(refusal("[1, 2]"), "configuration is [1, 2], allowed is a map of keys to values");
  EXPECT_EQ(refusal("visual_hull: 3"), "visual_hull is 3, allowed is a map of keys to values");
}

}  // namespace
}  // namespace markerless_mocap
