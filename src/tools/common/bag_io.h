#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace markerless_mocap {

/// Opens a bag for reading. Throws std::runtime_error if the file is missing, is not a bag, or has
/// no index because the recording was cut off.
void openForReading(const std::string& path, rosbag::Bag& bag);

/// The first message of a topic. Throws std::runtime_error if the bag has none.
template <class Message>
Message firstMessage(const rosbag::Bag& bag, const std::string& topic) {
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(topic)))
    if (const auto message = entry.instantiate<Message>()) return *message;
  throw std::runtime_error("the bag has no " + topic);
}

/// Writes a bag to <path>.active; commit() renames it to <path>. Without commit() the file is
/// removed.
class BagWriter {
 public:
  /// Throws std::runtime_error if the file cannot be written.
  explicit BagWriter(std::string path,
                     rosbag::CompressionType compression = rosbag::compression::LZ4);
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  template <class Message>
  void write(const std::string& topic, const ros::Time& stamp, const Message& message) {
    bag_.write(topic, stamp, message);
  }

  /// For latched topics, such as /tf_static.
  template <class Message>
  void writeLatched(const std::string& topic, const ros::Time& stamp, const Message& message) {
    bag_.write(topic, stamp, message,
               latchedHeader(topic, ros::message_traits::datatype(message),
                             ros::message_traits::md5sum(message),
                             ros::message_traits::definition(message)));
  }

  void commit();

 private:
  static boost::shared_ptr<ros::M_string> latchedHeader(const std::string& topic,
                                                        const std::string& type,
                                                        const std::string& md5sum,
                                                        const std::string& definition);

  std::string path_, active_path_;
  bool committed_ = false;
  rosbag::Bag bag_;
};

}  // namespace markerless_mocap
