#include "markerless_mocap/skeleton/pose_tree_builder.h"

#include "markerless_mocap/skeleton/thinner.h"
#include "skeleton/labelling.h"
#include "skeleton/validity_checks.h"

namespace markerless_mocap {
namespace {

PoseTreeOptions validated(const PoseTreeOptions& options) {
  options.validate();
  return options;
}

PoseTree refused(const Refusal& refusal) {
  PoseTree tree;
  tree.status = refusal.status;
  tree.reason = refusal.reason;
  return tree;
}

}  // namespace

class PoseTreeBuilder::State {
 public:
  explicit State(const PoseTreeOptions& options) : options_(validated(options)) {}

  PoseTree build(const VisualHull& hull, const CurveSkeleton* skeleton) {
    LastEnds now;
    if (const auto refusal = refuseHull(hull)) {
      last_.reset();
      return refused(*refusal);
    }
    PoseTree tree = Labelling(options_, hull, skeleton ? *skeleton : thinner_.thin(hull))
                        .run(options_.follow_labels ? last_ : LastEnds(), &now);
    last_ = now;
    return tree;
  }
  void reset() { last_.reset(); }

 private:
  PoseTreeOptions options_;
  Thinner thinner_{kTreePersistence};
  LastEnds last_;
};

PoseTreeBuilder::PoseTreeBuilder(const PoseTreeOptions& options)
    : state_(std::make_unique<State>(options)) {}
PoseTreeBuilder::~PoseTreeBuilder() = default;
PoseTreeBuilder::PoseTreeBuilder(PoseTreeBuilder&&) noexcept = default;
PoseTreeBuilder& PoseTreeBuilder::operator=(PoseTreeBuilder&&) noexcept = default;

PoseTree PoseTreeBuilder::build(const VisualHull& hull, const CurveSkeleton& skeleton) {
  return state_->build(hull, &skeleton);
}

PoseTree PoseTreeBuilder::build(const VisualHull& hull) {
  return state_->build(hull, nullptr);
}

void PoseTreeBuilder::reset() {
  state_->reset();
}

}  // namespace markerless_mocap
