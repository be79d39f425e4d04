#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace markerless_mocap {

/// Writes a file beside <path> and renames it to <path>: the file is complete or as it was. Throws
/// std::runtime_error if the path is no regular file or cannot be written.
inline void writeWholeFile(const std::string& path, const std::string& bytes) {
  static std::atomic<int> count{0};
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::runtime_error("cannot write " + path + ": it is a folder, pipe or device");
  const std::string active =
      path + "." + std::to_string(getpid()) + "." + std::to_string(count++) + ".active";
  std::ofstream file(active, std::ios::binary);
  if (!file)
    throw std::runtime_error("cannot write " + path +
                             ": its folder is missing or may not be written");
  file << bytes;
  file.close();
  if (file) std::filesystem::rename(active, path, error);
  if (file && !error) return;
  std::error_code ignored;
  std::filesystem::remove(active, ignored);
  throw std::runtime_error("cannot write " + path + (error ? ": " + error.message() : ""));
}

}  // namespace markerless_mocap
