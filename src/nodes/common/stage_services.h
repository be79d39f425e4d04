#pragma once

#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <boost/function.hpp>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "nodes/common/callback_gate.h"

namespace markerless_mocap {

/// The services of a stage. They run one at a time, and none after the destruction: declare it
/// after all that they use. What one does returns a sentence for the caller; an exception is the
/// reason why it has failed.
class StageServices {
 public:
  /// \param handle private to the node, of several threads: a service may wait for a frame set
  explicit StageServices(const ros::NodeHandle& handle) : handle_(handle) {}

  void onTrigger(const std::string& name, const std::function<std::string()>& act) {
    advertise<std_srvs::Trigger>(name, [act](const std_srvs::TriggerRequest&) { return act(); });
  }
  void onSwitch(const std::string& name, const std::function<std::string(bool)>& act) {
    advertise<std_srvs::SetBool>(
        name, [act](const std_srvs::SetBoolRequest& request) { return act(request.data); });
  }

 private:
  template <class ServiceT, class ActT>
  void advertise(const std::string& name, const ActT& act) {
    using Request = typename ServiceT::Request;
    using Response = typename ServiceT::Response;
    const auto run = gate_.guarded([act](const Request& request, Response* response) {
      try {
        response->message = act(request);
        response->success = true;
      } catch (const std::exception& error) {
        response->message = error.what();
        response->success = false;
      }
    });
    const boost::function<bool(Request&, Response&)> callback = [run](Request& request,
                                                                      Response& response) {
      run(request, &response);
      return true;
    };
    servers_.push_back(handle_.advertiseService(name, callback));
  }

  ros::NodeHandle handle_;
  std::vector<ros::ServiceServer> servers_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
