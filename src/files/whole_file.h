#pragma once

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace markerless_mocap {

/// Why the last write failed, to be put behind "cannot write FILE"; empty if it is not known.
inline std::string reasonOfFailedWrite(int error) {
  if (error == ENOSPC || error == EDQUOT) return ": the disk is full";
  if (error == EFBIG) return ": files may not become that large (ulimit -f)";
  return "";
}

/// Throws std::runtime_error unless a file can be put at this path: it has a name and is none or a
/// regular file.
inline void checkTarget(const std::string& path) {
  if (path.empty()) throw std::runtime_error("the name of the file to write is empty");
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::runtime_error("cannot write " + path +
                             ": it is a folder, pipe or device, allowed are files");
}

/// The file beside <path> that is filled, one of its own for each writer.
inline std::string activePathOf(const std::string& path) {
  static std::atomic<int> count{0};
  return path + "." + std::to_string(getpid()) + "." + std::to_string(count++) + ".active";
}

/// Lets `write` fill a file beside <path> and renames it to <path>: the file is complete or as it
/// was. Throws std::runtime_error as checkTarget() or if it cannot be written.
/// \param write bool(const std::string& path); false: failed. What it throws is passed on
template <class Write>
void writeWholeFileBy(const std::string& path, const Write& write) {
  checkTarget(path);
  const std::string active = activePathOf(path);
  if (!std::ofstream(active))
    throw std::runtime_error("cannot write " + path +
                             ": its folder is missing or may not be written");
  errno = 0;
  bool written = false;
  std::error_code error, ignored;
  try {
    written = write(active);
  } catch (...) {
    std::filesystem::remove(active, ignored);
    throw;
  }
  const std::string reason = reasonOfFailedWrite(errno);
  if (written) std::filesystem::rename(active, path, error);
  if (written && !error) return;
  std::filesystem::remove(active, ignored);
  throw std::runtime_error("cannot write " + path + (error ? ": " + error.message() : reason));
}

/// The same with the bytes of the file.
inline void writeWholeFile(const std::string& path, const std::string& bytes) {
  writeWholeFileBy(path, [&](const std::string& active) {
    std::ofstream file(active, std::ios::binary);
    file << bytes;
    file.close();
    return bool(file);
  });
}

}  // namespace markerless_mocap
