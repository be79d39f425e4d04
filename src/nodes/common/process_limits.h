#pragma once

#include <sys/resource.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace markerless_mocap {

/// How many files may be open, raised as far as the user may.
inline uint64_t raisedFileLimit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return RLIM_INFINITY;
  const rlimit raised{limit.rlim_max, limit.rlim_max};
  return setrlimit(RLIMIT_NOFILE, &raised) == 0 ? raised.rlim_cur : limit.rlim_cur;
}

/// How many files and connections are open; all that may be if no further one can; 0: unknown.
inline uint64_t openFileCount(uint64_t allowed) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::directory_iterator file("/proc/self/fd", error);
  if (error) return error == std::errc::too_many_files_open ? allowed : 0;
  uint64_t count = 0;
  for (; !error && file != fs::directory_iterator(); file.increment(error)) ++count;
  return count;
}

/// Raises how much this process may open as far as its user may. Returns what is still too little
/// to run a stage, as connections then fail in silence and threads end the process; empty: nothing.
inline std::string raiseProcessLimits() {
  constexpr uint64_t kLeastFiles = 64;           // a stage of eight cameras has about 45 open
  constexpr uint64_t kLeastMemory = 1000 << 20;  // bytes of addresses, most of them for libraries
  rlimit memory{RLIM_INFINITY, RLIM_INFINITY};
  getrlimit(RLIMIT_AS, &memory);
  const uint64_t files = raisedFileLimit();
  if (files < kLeastFiles)
    return "this process may open " + std::to_string(files) +
           " files and connections, allowed are " + std::to_string(kLeastFiles) +
           " and more, for many cameras 1024 (ulimit -n)";
  if (memory.rlim_cur < kLeastMemory)
    return "this process may use " + std::to_string(memory.rlim_cur >> 20) +
           " MB of addresses, allowed are " + std::to_string(kLeastMemory >> 20) +
           " MB and more (ulimit -v)";
  return "";
}

/// Raises how large the files of this process may become as far as its user may, and lets writing
/// beyond it fail where the system would end the process without a word. Returns what is cut off;
/// empty: nothing.
inline std::string raiseFileSizeLimit() {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return "";
  const rlimit raised{limit.rlim_max, limit.rlim_max};
  if (setrlimit(RLIMIT_FSIZE, &raised) == 0) limit = raised;
  if (limit.rlim_cur == RLIM_INFINITY) return "";
  return "this process may write files of " + std::to_string(limit.rlim_cur >> 10) +
         " kB only, so that its log and kept backgrounds may be cut off or missing (ulimit -f)";
}

/// Tells if hardly any file or connection can be opened anymore; empty: enough can.
inline std::string shortageOfFiles() {
  constexpr uint64_t kSpareFiles = 8;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return "";
  if (openFileCount(limit.rlim_cur) + kSpareFiles <= limit.rlim_cur) return "";
  return "of the " + std::to_string(limit.rlim_cur) +
         " files and connections that this process may " +
         "open hardly any is left, so that further connections fail (ulimit -n)";
}

}  // namespace markerless_mocap
