#include "studies/reproduce/fleischmann/fleischmann_variants.h"

#include <algorithm>
#include <stdexcept>

namespace markerless_mocap {

const std::vector<FleischmannVariant>& fleischmannVariants() {
  static const std::vector<FleischmannVariant> kVariants = {
      {"base60", "two soft stages, 60 fps", {}, 60, 5, 1000, false, 38.0, 86.4},
      {"base20", "two soft stages, 20 fps", {}, 20, 5, 1000, false, 46.3, 129.4},
      {"eval2000",
       "2000 evaluations, 60 fps",
       {{"particle_factor", "2"}},
       60,
       3,
       2000,
       false,
       37.3,
       82.3},
      {"eval4000",
       "4000 evaluations, 60 fps",
       {{"particle_factor", "4"}},
       60,
       1,
       4000,
       false,
       35.7,
       56.7},
      {"apf60", "annealed particle filter, 60 fps", {{"search", "annealed_filter"}}, 60},
      {"apf20", "annealed particle filter, 20 fps", {{"search", "annealed_filter"}}, 20},
      {"isa60", "interacting annealing (ours), 60 fps", {{"search", "interacting_annealing"}}, 60},
      {"isa20", "interacting annealing (ours), 20 fps", {{"search", "interacting_annealing"}}, 20},
      {"hard20", "two hard stages, 20 fps", {{"search", "two_hard"}}, 20},
      {"global20", "one global stage, 20 fps", {{"search", "one_global"}}, 20},
      {"global60", "one global stage, 60 fps", {{"search", "one_global"}}, 60},
      {"three20", "three soft stages, 20 fps", {{"search", "three_soft"}}, 20},
      {"twelve60",
       "twelve hard stages, 7200 evaluations, 60 fps",
       {{"search", "twelve_hard"}},
       60,
       5,
       7200},
      {"p2",
       "2 particles, 400 iterations",
       {{"final_stage_particles", "2"}, {"final_stage_iterations", "400"}},
       20,
       1},
      {"p10",
       "10 particles, 80 iterations",
       {{"final_stage_particles", "10"}, {"final_stage_iterations", "80"}},
       20,
       3},
      {"p40",
       "40 particles, 20 iterations",
       {{"final_stage_particles", "40"}, {"final_stage_iterations", "20"}},
       20,
       3},
      {"p400",
       "400 particles, 2 iterations",
       {{"final_stage_particles", "400"}, {"final_stage_iterations", "2"}},
       20,
       1},
      {"silhouettes20", "silhouettes alone, 20 fps", {{"use_edges", "false"}}, 20},
      {"notop20", "no upper edge of the torso, 20 fps", {{"use_torso_top_edge", "false"}}, 20},
      {"full60", "joint limits of adults, 60 fps", {{"joint_limits", "full"}}, 60},
      {"full20", "joint limits of adults, 20 fps", {{"joint_limits", "full"}}, 20},
      {"exact60", "exact silhouettes, 60 fps", {}, 60, 5, 1000, true},
      {"exact20", "exact silhouettes, 20 fps", {}, 20, 5, 1000, true},
  };
  return kVariants;
}

const FleischmannVariant& fleischmannVariant(const std::string& id) {
  const auto& all = fleischmannVariants();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& variant) { return variant.id == id; });
  if (found == all.end()) throw std::invalid_argument("there is no variant " + id);
  return *found;
}

const std::vector<FleischmannTable>& fleischmannTables() {
  static const std::vector<FleischmannTable> kTables = {
      {"6.3", "Base configuration (Fig. 6.5)", {"base60", "base20"}},
      {"6.4",
       "Evaluations per frame at 60 fps (Table 6.2, Fig. 6.7)",
       {"base60", "eval2000", "eval4000"}},
      {"6.5",
       "Annealed particle filter (Figs. 6.8, 6.9)",
       {"base60", "apf60", "isa60", "base20", "apf20", "isa20"}},
      {"6.6",
       "Partitions (Figs. 6.10-6.14)",
       {"base20", "hard20", "global20", "three20", "base60", "global60", "twelve60"}},
      {"6.8",
       "Particles against iterations, 20 fps (Table 6.4, Fig. 6.16)",
       {"p2", "p10", "base20", "p40", "p400"}},
      {"6.10",
       "Fitness functions, 20 fps (Figs. 6.21, 6.22)",
       {"base20", "silhouettes20", "notop20"}},
      {"5.3.2",
       "Joint limits, which the thesis leaves open",
       {"base60", "full60", "base20", "full20"}},
      {"Ours:",
       "exact silhouettes in place of noisy ones",
       {"base60", "exact60", "base20", "exact20"}},
  };
  return kTables;
}

}  // namespace markerless_mocap
