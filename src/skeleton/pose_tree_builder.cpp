#include "markerless_mocap/skeleton/pose_tree_builder.h"

#include "skeleton/labelling.h"
#include "skeleton/plausibility_checks.h"
#include "skeleton/thinner.h"

namespace markerless_mocap {
namespace {

PoseTreeOptions validated(const PoseTreeOptions& options) {
  options.validate();
  return options;
}

PoseTree rejected(const Rejection& rejection) {
  PoseTree tree;
  tree.status = rejection.status;
  tree.reason = rejection.reason;
  return tree;
}

}  // namespace

class PoseTreeBuilder::State {
 public:
  State(const PoseTreeOptions& options, const PoseTreeModel& model)
      : options_(validated(options)), model_(model) {}

  PoseTree build(const VisualHull& hull, const CurveSkeleton* skeleton) {
    PreviousExtremities now;
    if (const auto rejection = rejectHull(hull)) {
      last_.reset();
      return rejected(*rejection);
    }
    PoseTree tree = Labelling(options_, model_, hull, skeleton ? *skeleton : thinner_.thin(hull))
                        .run(options_.follow_labels ? last_ : PreviousExtremities(), &now);
    last_ = now;
    return tree;
  }
  void reset() { last_.reset(); }

 private:
  PoseTreeOptions options_;
  PoseTreeModel model_;
  Thinner thinner_{options_.persistence};
  PreviousExtremities last_;
};

PoseTreeBuilder::PoseTreeBuilder(const PoseTreeOptions& options, const PoseTreeModel& model)
    : state_(std::make_unique<State>(options, model)) {}
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
