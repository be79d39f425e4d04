#pragma once

#include <cstdint>
#include <optional>

namespace markerless_mocap {

/// Judges the stamps of one camera, whose images come in the order of time. What is against that
/// order is first left out; a second stamp that continues it tells that the clock was set.
class StampOrder {
 public:
  enum class Verdict {
    kInOrder,
    kZero,       ///< the stamp was never set
    kDuplicate,  ///< as the last one
    kDoubtful,   ///< behind the last one, or too far ahead for the time that has passed
    kStepped,    ///< in order, but the clock was set before it
  };
  struct Judgement {
    Verdict verdict = Verdict::kInOrder;
    double step = 0.0;  ///< s, by how much the clock was set; 0 unless kStepped
    /// Whether the image is to be used.
    bool isUsable() const { return verdict == Verdict::kInOrder || verdict == Verdict::kStepped; }
  };

  /// \param arrival_ns by a clock that is never set
  Judgement judge(int64_t stamp_ns, int64_t arrival_ns);

 private:
  bool continues(int64_t from_ns, int64_t stamp_ns, int64_t passed_ns) const;
  Judgement accept(int64_t stamp_ns, int64_t arrival_ns, Judgement judgement);

  struct Arrival {
    int64_t stamp_ns, arrival_ns;
  };
  std::optional<Arrival> last_;
  std::optional<Arrival> doubtful_;  ///< the last one that was left out
  double period_ns_ = 0.0;           ///< between images in order; 0: not known yet
};

}  // namespace markerless_mocap
