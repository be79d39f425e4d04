#pragma once

#include <XmlRpcValue.h>
#include <ros/publisher.h>
#include <ros/time.h>

#include <atomic>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace markerless_mocap {

/// Notices that roscore was started again, which then knows neither this node nor its parameters,
/// and registers the node's topics and services and sets its parameters again. Both this and a
/// roscore that cannot be reached are told on /diagnostics. Connections between nodes outlive
/// roscore. Tells, too, if hardly any connection can be opened anymore.
class MasterWatch {
 public:
  /// \param namespaces whose parameters are kept, such as "/visual_hull". Those of other stages
  /// beside it are, too, as such a one may have ended and not know them when roscore is back
  explicit MasterWatch(const std::vector<std::string>& namespaces);
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

 private:
  void run();
  bool sleep(double seconds) const;
  void keepParameters(const std::vector<std::string>& namespaces);
  void setParameters() const;
  void registerAgain();
  void tell(const std::string& about, const std::string& message) const;

  std::vector<std::string> namespaces_;                    ///< of the stages in this process
  std::map<std::string, XmlRpc::XmlRpcValue> parameters_;  ///< by namespace
  std::map<std::string, std::string> services_;            ///< address by name
  ros::Publisher diagnostics_;
  ros::SteadyTime told_until_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace markerless_mocap
