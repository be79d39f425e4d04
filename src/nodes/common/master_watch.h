#pragma once

#include <XmlRpcValue.h>

#include <atomic>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace markerless_mocap {

/// Notices that roscore was started again, which then knows neither this node nor its parameters,
/// and registers the node's topics and sets its parameters again. Its services are not registered:
/// that is told. Connections between nodes outlive roscore.
class MasterWatch {
 public:
  /// \param namespaces whose parameters are kept, such as "/visual_hull"
  explicit MasterWatch(const std::vector<std::string>& namespaces);
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

 private:
  void run();
  bool sleep(double seconds) const;
  void keepParameters();
  void registerAgain();

  std::vector<std::string> namespaces_;
  std::map<std::string, XmlRpc::XmlRpcValue> parameters_;  ///< by namespace
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace markerless_mocap
