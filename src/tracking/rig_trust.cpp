#include "tracking/rig_trust.h"

#include <algorithm>

#include "camera/camera_difference.h"
#include "tracking/body_in_mask.h"

namespace markerless_mocap {
namespace {

bool isSame(const Camera& a, const Camera& b) {
  const CameraCalibration &one = a.calibration(), &other = b.calibration();
  return one.width == other.width && one.height == other.height && one.K == other.K &&
         one.D == other.D && one.lens == other.lens &&
         one.T_world_camera.matrix() == other.T_world_camera.matrix();
}

}  // namespace

RigTrust::RigPointer RigTrust::rigFor(const RigPointer& told, const Evidence& evidence) {
  if (!used_) {
    agreements_.assign(told->size(), 0);
    return told_ = used_ = told;
  }
  if (told != told_) {
    judgeChanges(*told, evidence);
    told_ = told;
  } else if (refused_ != 0) {
    takeBack(evidence);
  } else {
    return used_;
  }
  return used_ = composed();
}

RigTrust::Verdict RigTrust::judge(const Camera& camera, size_t index,
                                  const Evidence& evidence) const {
  if (evidence.joints.empty()) return Verdict::kAgrees;
  const cv::Mat mask = evidence.mask(index);
  if (mask.empty()) return Verdict::kNotSeen;
  return mayShowBody(camera, mask, evidence.joints) ? Verdict::kAgrees : Verdict::kContradicts;
}

void RigTrust::judgeChanges(const CameraRig& told, const Evidence& evidence) {
  for (size_t i = 0; i < told.size(); ++i) {
    if (isSame(told[i], (*told_)[i]) && isRefused(i)) continue;
    const bool changed = seeDifferently(told[i], (*used_)[i]);
    const Verdict verdict = changed ? judge(told[i], i, evidence) : Verdict::kAgrees;
    refuse(i, verdict != Verdict::kAgrees);
    agreements_[i] = verdict == Verdict::kNotSeen ? kConvincing - 1 : 0;
  }
}

void RigTrust::takeBack(const Evidence& evidence) {
  if (evidence.joints.empty()) return;
  for (size_t i = 0; i < agreements_.size(); ++i) {
    if (!isRefused(i)) continue;
    const Verdict verdict = judge((*told_)[i], i, evidence);
    if (verdict == Verdict::kContradicts) agreements_[i] = 0;
    if (verdict == Verdict::kAgrees && ++agreements_[i] >= kConvincing) refuse(i, false);
  }
}

void RigTrust::refuse(size_t camera, bool refused) {
  const uint32_t bit = uint32_t(1) << camera;
  if (refused)
    refused_ |= bit;
  else
    refused_ &= ~bit;
}

RigTrust::RigPointer RigTrust::composed() const {
  if (refused_ == 0 && !std::equal(told_->begin(), told_->end(), used_->begin(), isSame))
    return told_;
  CameraRig rig;
  bool changed = false;
  for (size_t i = 0; i < told_->size(); ++i) {
    const Camera& camera = isRefused(i) ? (*used_)[i] : (*told_)[i];
    changed = changed || !isSame(camera, (*used_)[i]);
    rig.push_back(camera);
  }
  return changed ? std::make_shared<const CameraRig>(std::move(rig)) : used_;
}

}  // namespace markerless_mocap
