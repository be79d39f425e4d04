#include <stdexcept>

#include "markerless_mocap/tracking/tracked_body.h"
#include "nodes/pose_fitting/fitting_stage.h"
#include "ros/package_files.h"

namespace markerless_mocap {

void FittingStage::advertiseServices() {
  const auto advertise = [this](const char* name, std::string (FittingStage::*act)()) {
    services_->onTrigger(name, [this, act] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return (this->*act)();
    });
  };
  advertise("reset_tracking", &FittingStage::resetTracking);
  advertise("measure_person", &FittingStage::measurePerson);
  advertise("load_body", &FittingStage::loadBody);
  advertise("save_body", &FittingStage::saveMeasuredBody);
  services_->onSwitch("set_running", [this](bool runs) { return setRunning(runs); });
}

void FittingStage::apply(const TrackerOptions& options) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::optional<PoseFilter> filter = makePoseFilter(body_->model, options.filter);  // may throw
  const std::lock_guard<std::mutex> announcing(announcing_);
  filter_ = std::move(filter);
  options_ = options;
}

std::string FittingStage::resetTracking() {
  successor_.forget();
  if (tracker_) tracker_->reset();
  const std::lock_guard<std::mutex> announcing(announcing_);
  filter_ = makePoseFilter(body_->model, options_.filter);
  return "the person is searched for anew, the body is kept";
}

std::string FittingStage::measurePerson() {
  resources_.known_shape.reset();
  restartWith(initialBody(resources_, options_.person.stature));
  const bool measures = options_.method == "contour" && options_.person.measure;
  return measures ? "the person is measured anew"
                  : "the body is that of the stature again, as the method or measure is set";
}

std::string FittingStage::loadBody() {
  const std::string& file = node_options_.body_file;
  if (file.empty()) throw std::invalid_argument("body_file is empty, allowed is the file to read");
  resources_.known_shape =
      readPersonResources(node_options_.body_id, node_options_.urdf_template, file).known_shape;
  restartWith(initialBody(resources_, options_.person.stature));
  return "the body is that of " + file;
}

void FittingStage::restartWith(const std::shared_ptr<const TrackedBody>& body) {
  successor_.forget();
  useTracker(nullptr, nullptr);
  follows_ = false;
  takeOver(body);
}

std::string FittingStage::saveMeasuredBody() {
  const std::string& file = node_options_.body_file;
  if (file.empty()) throw std::invalid_argument("body_file is empty, allowed is the file to write");
  if (!body_->shape_estimated) throw std::invalid_argument("the person has not been measured yet");
  writeBodyFile(file, body_->shape);
  return "saved in " + file;
}

std::string FittingStage::setRunning(bool runs) {
  const std::lock_guard<std::mutex> lock(mutex_);
  runs_ = runs;
  if (runs) return resetTracking();
  const std::lock_guard<std::mutex> announcing(announcing_);
  announce(false, ros::Time::now());
  return "no more poses are fitted";
}

}  // namespace markerless_mocap
