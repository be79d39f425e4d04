#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cerrno>
#include <memory>
#include <stdexcept>
#include <string>

#include "files/output_lock.h"

namespace markerless_mocap {

/// Opens a bag for reading. Throws std::runtime_error if the file is missing, is not a bag, or has
/// no index because the recording was cut off.
void openForReading(const std::string& path, rosbag::Bag& bag);

/// The message of an entry; null if it has another type or md5 sum. Throws std::runtime_error if
/// its bytes are damaged.
template <class Message>
boost::shared_ptr<const Message> messageOf(const rosbag::MessageInstance& entry) {
  try {
    return entry.instantiate<Message>();
  } catch (const std::exception&) {  // of rosbag, of the serialization, of an absurd length
    throw std::runtime_error("a message of " + entry.getTopic() + " is damaged");
  }
}

/// The first message of a topic. Throws std::runtime_error if the bag has none.
template <class Message>
Message firstMessage(const rosbag::Bag& bag, const std::string& topic) {
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(topic)))
    if (const auto message = messageOf<Message>(entry)) return *message;
  throw std::runtime_error(bag.getFileName() + " has no " + topic);
}

/// Writes a bag to a file of its own beside <path>; commit() renames it to <path>. Without commit()
/// the file is removed. What cannot be written is a std::runtime_error that says why, and so is an
/// output that another program is writing, and an interruption, see catchInterruptions().
class BagWriter {
 public:
  /// Throws std::runtime_error if the file cannot be written, or the path is no regular file.
  explicit BagWriter(std::string path,
                     rosbag::CompressionType compression = rosbag::compression::LZ4);
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  template <class Message>
  void write(const std::string& topic, const ros::Time& stamp, const Message& message) {
    guarded(topic, stamp, [&] { bag_->write(topic, stamp, message); });
  }

  /// For latched topics, such as /tf_static.
  template <class Message>
  void writeLatched(const std::string& topic, const ros::Time& stamp, const Message& message) {
    guarded(topic, stamp, [&] {
      bag_->write(topic, stamp, message,
                  latchedHeader(topic, ros::message_traits::datatype(message),
                                ros::message_traits::md5sum(message),
                                ros::message_traits::definition(message)));
    });
  }

  /// A message of another bag as it is, latched if it was.
  void copy(const rosbag::MessageInstance& message) {
    guarded(message.getTopic(), message.getTime(), [&] {
      bag_->write(message.getTopic(), message.getTime(), message, message.getConnectionHeader());
    });
  }

  void commit();

 private:
  static boost::shared_ptr<ros::M_string> latchedHeader(const std::string& topic,
                                                        const std::string& type,
                                                        const std::string& md5sum,
                                                        const std::string& definition);

  /// Throws std::runtime_error with our own sentence if the file cannot take the message.
  template <class Write>
  void guarded(const std::string& topic, const ros::Time& stamp, const Write& write) {
    check(topic, stamp);
    errno = 0;
    try {
      write();
    } catch (const rosbag::BagException&) {
      fail(errno);
    }
  }
  void check(const std::string& topic, const ros::Time& stamp) const;
  [[noreturn]] void fail(int error);
  void abandon();

  std::string path_, active_path_;
  std::unique_ptr<OutputLock> lock_;  ///< of path_
  bool committed_ = false;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace markerless_mocap
