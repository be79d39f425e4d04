#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace markerless_mocap {

/// Holds an output that takes long to write: of two programs that are told to write the same file,
/// the second one is refused at once. Ends with its process, however that ends.
class OutputLock {
 public:
  /// Throws std::runtime_error if another program is writing `path`. Where no lock can be made,
  /// such as in folders of some networks, there is none.
  explicit OutputLock(const std::string& path) : file_(path + ".lock") {
    handle_ = open(file_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (handle_ < 0 || flock(handle_, LOCK_EX | LOCK_NB) == 0) return;
    const bool taken = errno == EWOULDBLOCK;
    close(handle_);
    handle_ = -1;
    if (taken)
      throw std::runtime_error("cannot write " + path + ": another program is writing it now");
  }
  ~OutputLock() {
    if (handle_ < 0) return;
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);  // before others may have it
    close(handle_);
  }
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

 private:
  std::string file_;
  int handle_ = -1;
};

}  // namespace markerless_mocap
