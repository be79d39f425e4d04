#include "nodes/common/settings_server.h"

#include <dynamic_reconfigure/Reconfigure.h>

#include <boost/function.hpp>
#include <exception>

namespace markerless_mocap {

SettingsServer::SettingsServer(const ros::NodeHandle& handle, const std::vector<Setting>& settings,
                               std::function<void(const SettingChanges&)> change)
    : change_(std::move(change)) {
  using Request = dynamic_reconfigure::Reconfigure::Request;
  using Response = dynamic_reconfigure::Reconfigure::Response;
  ros::NodeHandle node(handle);
  descriptions_ =
      node.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true);
  updates_ = node.advertise<Config>("parameter_updates", 1, true);
  descriptions_.publish(messageFromSettings(settings));
  publish(settings);
  const auto guarded =
      gate_.guarded([this](const Config& wanted, Config* used, std::exception_ptr* refusal) {
        try {
          receive(wanted, used);
        } catch (const std::exception&) {
          *refusal = std::current_exception();
        }
      });
  // roscpp logs what a service throws and hands it to the caller.
  const boost::function<bool(Request&, Response&)> callback = [guarded](Request& request,
                                                                        Response& response) {
    std::exception_ptr refusal;
    guarded(request.config, &response.config, &refusal);
    if (refusal) std::rethrow_exception(refusal);
    return true;
  };
  service_ = node.advertiseService("set_parameters", callback);
}

void SettingsServer::publish(const std::vector<Setting>& settings) {
  const std::lock_guard<std::mutex> lock(mutex_);
  used_ = valuesMessage(settings);
  updates_.publish(used_);
}

void SettingsServer::receive(const Config& wanted, Config* used) {
  try {
    change_(changesFromMessage(wanted));
    const std::lock_guard<std::mutex> lock(mutex_);
    *used = used_;
  } catch (...) {
    const std::lock_guard<std::mutex> lock(mutex_);
    updates_.publish(used_);  // sliders go back
    throw;
  }
}

}  // namespace markerless_mocap
