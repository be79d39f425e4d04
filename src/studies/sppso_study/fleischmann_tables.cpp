#include "studies/sppso_study/sppso_study.h"

namespace markerless_mocap {
namespace {

/// The base options, modified by `change`.
template <class Change>
StudyVariant variant(const std::string& name, const FleischmannOptions& base, double fps, int runs,
                     const Change& change) {
  StudyVariant v{name, base, fps, runs};
  change(v.options);
  return v;
}

void asItIs(FleischmannOptions&) {}

StudyVariant searching(const std::string& name, const FleischmannOptions& base, double fps,
                       const std::string& search) {
  return variant(name, base, fps, 5, [&](FleischmannOptions& o) { o.search = search; });
}

StudyTable evaluationRates(const FleischmannOptions& base) {
  const auto factor = [&](double times, int runs) {
    return variant(std::to_string(int(1000 * times)) + " evaluations, 60 fps", base, 60, runs,
                   [&](FleischmannOptions& o) { o.particle_factor = times; });
  };
  return {"6.2",
          "Evaluations per frame",
          {factor(1, 5), factor(2, 3), factor(4, 1),
           variant("1000 evaluations, 20 fps", base, 20, 5, asItIs)}};
}

StudyTable rivals(const FleischmannOptions& base) {
  StudyTable table{"6.5", "Swarm against annealed filters", {}};
  for (const double fps : {60.0, 20.0}) {
    const std::string rate = fps == 60.0 ? ", 60 fps" : ", 20 fps";
    table.variants.push_back(searching("two soft stages" + rate, base, fps, "two_soft"));
    table.variants.push_back(
        searching("annealed particle filter" + rate, base, fps, "annealed_filter"));
    table.variants.push_back(
        searching("interacting annealing" + rate, base, fps, "interacting_annealing"));
  }
  return table;
}

StudyTable partitions(const FleischmannOptions& base) {
  return {"6.6",
          "Partitions",
          {searching("two soft stages, 20 fps", base, 20, "two_soft"),
           searching("two hard stages, 20 fps", base, 20, "two_hard"),
           searching("one global stage, 20 fps", base, 20, "one_global"),
           searching("three soft stages, 20 fps", base, 20, "three_soft"),
           searching("two soft stages, 60 fps", base, 60, "two_soft"),
           searching("one global stage, 60 fps", base, 60, "one_global"),
           searching("twelve hard stages, 60 fps", base, 60, "twelve_hard")}};
}

StudyTable swarmSizes(const FleischmannOptions& base) {
  StudyTable table{"6.8", "Particles against iterations of the second stage, 20 fps", {}};
  const int sizes[][3] = {{2, 400, 1}, {10, 80, 3}, {20, 40, 5}, {40, 20, 3}, {400, 2, 1}};
  for (const auto& size : sizes)
    table.variants.push_back(variant(std::to_string(size[0]) + " x " + std::to_string(size[1]),
                                     base, 20, size[2], [&](FleischmannOptions& o) {
                                       o.final_stage_particles = size[0];
                                       o.final_stage_iterations = size[1];
                                     }));
  return table;
}

StudyTable fitnessTerms(const FleischmannOptions& base) {
  return {"6.10",
          "Fitness terms, 20 fps",
          {variant("silhouettes and edges", base, 20, 5, asItIs),
           variant("silhouettes alone", base, 20, 5,
                   [](FleischmannOptions& o) { o.use_edges = false; }),
           variant("no upper edge of the torso", base, 20, 5,
                   [](FleischmannOptions& o) { o.use_torso_top_edge = false; })}};
}

StudyTable otherStarts(const FleischmannOptions& base) {
  const auto keeping = [](FleischmannOptions& o) {
    o.include_start_particle = true;
    o.sigma_factor = 0.6;
  };
  const auto predicting = [](FleischmannOptions& o) {
    o.prediction_fraction = 1.0 / 3.0;
    o.sigma_factor = 0.5;
  };
  return {"ours",
          "The start pose included among the particles, or predicted from the last change",
          {variant("20 fps, as in the thesis", base, 20, 5, asItIs),
           variant("20 fps, kept start, 0.6 of the spread", base, 20, 5, keeping),
           variant("20 fps, predicted start, half the spread", base, 20, 5, predicting),
           variant("60 fps, kept start, 0.6 of the spread", base, 60, 5, keeping),
           variant("60 fps, predicted start, half the spread", base, 60, 5, predicting)}};
}

}  // namespace

std::vector<StudyTable> studyTables(const FleischmannOptions& base) {
  return {evaluationRates(base), rivals(base),       partitions(base),
          swarmSizes(base),      fitnessTerms(base), otherStarts(base)};
}

}  // namespace markerless_mocap
