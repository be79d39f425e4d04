#include "contour/track/pose_trust.h"

#include "contour/track/pose_report.h"

namespace markerless_mocap {
namespace {

// A start of lower quality is accepted only if a start on a later frame leads to the same body. The
// mean shape gives a lower quality than the person's own. Furniture confirms itself by standing
// still, so something must have moved in between.
constexpr double kMinQuality = 0.90, kMinQualityOfMeanShape = 0.86;
// A start with a smaller overlap is never accepted. A person in a long dress, with the shape
// estimated from one frame, gives an overlap of 0.78; a man together with the chair he sits on
// 0.68.
constexpr double kMinOverlap = 0.72;

// Colours follow a body wherever they are told to look. Where the background is known, the
// silhouettes must show the person, too: this fraction of what colours found, to report a pose and
// to go on. On films on which the pose is right it is 0.86 and more; a body that is beside a man at
// his desk, of whom little is seen, has 0.45 to 0.69.
constexpr double kMinAgreement = 0.75, kLostAgreement = 0.5;

// After a long gap the person may have moved too far for the prediction. A limb or the whole body
// is then fitted to the wrong place, nearly as well as usual; and so it is by some starts.
constexpr int64_t kDoubt_ns = 1000000000;

}  // namespace

void PoseTrust::take(const RegionObservation& found) {
  agreement_ = found.agreement;
  limb_agreement_ = found.limb_agreement;
}

bool PoseTrust::isContradicted() const {
  return agreement_ < kLostAgreement;
}

bool PoseTrust::mayBeAccepted(const JudgedPose& pose) const {
  const bool good =
      qualityOf(pose.fit) > (pose.of_mean_body ? kMinQualityOfMeanShape : kMinQuality);
  return pose.fit.overlap > kMinOverlap && agreement_ > kMinAgreement &&
         pose.hypotheses.isUnambiguous() &&
         (good || (pose.hypotheses.isConfirmed() && pose.contours.showLife(pose.seen)));
}

bool PoseTrust::isBelieved() const {
  return accepted_ && agreement_ > kMinAgreement;
}

std::string PoseTrust::whyUncertain(const ContourFit& fit,
                                    const ContourMultiHypothesisTracker& hypotheses) const {
  if (fit.overlap <= kMinOverlap) return overlapTooSmall(fit);
  if (agreement_ <= kMinAgreement)
    return "colours show a person where the silhouettes show background";
  if (accepted_ && hypotheses.isUnambiguous()) return "";
  return markerless_mocap::whyUncertain(hypotheses);
}

void PoseTrust::doubt(int64_t stamp_ns) {
  doubted_until_ns_ = stamp_ns + kDoubt_ns;
  accepted_ = false;
}

bool PoseTrust::doubtIfFarWorse(int64_t stamp_ns, const ContourFit& fit) {
  const bool is_far_worse = usual_quality_.isFarAbove(stamp_ns, fit.majority_quality);
  if (is_far_worse) doubt(stamp_ns);
  return is_far_worse;
}

void PoseTrust::agree(const ContourFit& fit) {
  if (usual_quality_.isNear(fit.majority_quality)) endDoubt();
}

bool PoseTrust::isDoubted(int64_t stamp_ns, const ContourFit& fit) const {
  return stamp_ns < doubted_until_ns_ && !usual_quality_.includes(fit.majority_quality);
}

void PoseTrust::learnQuality(int64_t stamp_ns, const ContourFit& fit) {
  if (stamp_ns >= doubted_until_ns_ && isBelieved()) usual_quality_.add(fit.majority_quality);
}

}  // namespace markerless_mocap
