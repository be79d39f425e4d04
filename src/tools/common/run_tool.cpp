#include "tools/common/run_tool.h"

#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include "text/printable.h"

namespace markerless_mocap {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

/// In place of the words of libraries where the system gives too little.
std::string sentenceOf(const std::exception& error) {
  const std::string words = error.what();
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "there is not enough memory, or this process may not use it (ulimit -v)";
  if (words.find(std::strerror(EAGAIN)) != std::string::npos)  // of the standard library or TBB
    return "no further thread can be started (ulimit -u): " + words;
  return words;
}

/// Raised as far as the user may. ROS does not find its packages without some.
void requireOpenFiles() {
  constexpr rlim_t kLeast = 16;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  const rlimit raised{limit.rlim_max, limit.rlim_max};
  if (setrlimit(RLIMIT_NOFILE, &raised) == 0) limit = raised;
  if (limit.rlim_cur < kLeast)
    throw std::runtime_error("this process may open " + std::to_string(limit.rlim_cur) +
                             " files, allowed are " + std::to_string(kLeast) +
                             " and more (ulimit -n)");
}

}  // namespace

int runTool(const char* name, const std::function<void()>& work) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is told as any that cannot be written
  try {
    requireOpenFiles();
    work();
  } catch (const std::exception& error) {
    std::cerr << name << ": " << printable(sentenceOf(error)) << std::endl;
    return 1;
  }
  return 0;
}

std::function<bool()> catchInterruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup wants
  return isInterrupted;
}

bool isInterrupted() {
  return interrupted != 0;
}

std::string callOf(const std::string& program) {
  const char* caller = std::getenv("MARKERLESS_MOCAP_RUN");
  return (caller ? std::string(caller) : "rosrun markerless_mocap") + ' ' + program;
}

}  // namespace markerless_mocap
