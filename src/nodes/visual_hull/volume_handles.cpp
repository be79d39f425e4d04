#include "nodes/visual_hull/volume_handles.h"

#include <tf2_eigen/tf2_eigen.h>

#include <exception>
#include <utility>

#include "nodes/common/end_process.h"
#include "ros/volume_markers.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxWaiting = 1;

/// All six numbers: what is seen is what is meant, also of an automatic volume.
SettingChanges changesTo(const Eigen::AlignedBox3d& box) {
  SettingChanges changes{{"volume", std::string("explicit")}};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string suffix = std::string("_") + "xyz"[axis];
    changes[kLowCorner + suffix] = box.min()[axis];
    changes[kHighCorner + suffix] = box.max()[axis];
  }
  return changes;
}

}  // namespace

VolumeHandles::VolumeHandles(const std::string& topic, const std::string& frame, Actions actions,
                             StageStatus* status)
    : frame_(frame),
      actions_(std::move(actions)),
      status_(status),
      queue_(kMaxWaiting),
      server_(topic, "", true) {
  menu_.insert("Write to the volume file", [this](const Feedback&) {
    queue_.push([this] { attempt([this] { status_->remark("volume " + actions_.save()); }); });
  });
  menu_.insert("Automatic: all that most cameras see", [this](const Feedback&) {
    queue_.push([this] {
      attempt([this] { actions_.change({{"volume", std::string("auto")}}); });
    });
  });
  worker_ = std::thread([this] { runOrEndProcess("the volume's handles", [this] { work(); }); });
}

VolumeHandles::~VolumeHandles() {
  queue_.close();
  worker_.join();
}

void VolumeHandles::show(const Eigen::AlignedBox3d& box) {
  const std::lock_guard<std::mutex> show_lock(show_mutex_);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    box_ = box;
  }
  for (const char* name : {kLowCorner, kHighCorner}) {
    server_.insert(cornerMarker(name, box, frame_),
                   [this](const Feedback& feedback) { receive(feedback); });
    menu_.apply(server_, name);
  }
  server_.applyChanges();
}

void VolumeHandles::receive(const Feedback& feedback) {
  if (feedback->event_type != visualization_msgs::InteractiveMarkerFeedback::MOUSE_UP) return;
  Eigen::AlignedBox3d box;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    box = box_;
  }
  Eigen::Vector3d corner;
  tf2::fromMsg(feedback->pose.position, corner);
  (feedback->marker_name == kLowCorner ? box.min() : box.max()) = corner;
  const std::string frame = feedback->header.frame_id;
  queue_.push([this, box, frame] {
    attempt([&] {
      if (frame != frame_)
        throw std::invalid_argument("the volume can be dragged with the fixed frame \"" + frame_ +
                                    "\" only, it is \"" + frame + "\"");
      actions_.change(changesTo(box));
      show(box);
    });
  });
}

void VolumeHandles::work() {
  while (const auto action = queue_.take()) (*action)();
}

void VolumeHandles::attempt(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    status_->remark(error.what());
    Eigen::AlignedBox3d box;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      box = box_;
    }
    show(box);
  }
}

}  // namespace markerless_mocap
