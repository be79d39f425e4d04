#include "silhouette/background/subtractor.h"
#include "silhouette/boundary/clean_mask.h"
#include "silhouette/network/person_net.h"

namespace markerless_mocap {
namespace {

/// A network's masks with this room's clean-up. There is no background.
class NetworkSubtractor : public Subtractor {
 public:
  explicit NetworkSubtractor(const SilhouetteOptions& options)
      : options_(options), net_(options.network) {}

  void change(const SilhouetteOptions& options) override { options_ = options; }
  void learn(const cv::Mat&) override {}
  void finishLearning() override {}

  Extraction extract(const cv::Mat& image) override {
    Extraction found;
    const cv::Mat person = net_.probability(image) >= options_.network.threshold;
    found.mask = cleanBits(BitMask::fromMat(person), options_);
    return found;
  }

 private:
  SilhouetteOptions options_;
  PersonNet net_;
};

}  // namespace

std::unique_ptr<Subtractor> makeNetworkSubtractor(const SilhouetteOptions& options) {
  return std::make_unique<NetworkSubtractor>(options);
}

}  // namespace markerless_mocap
