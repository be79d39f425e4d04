#include "tools/common/run_tool.h"

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "text/printable.h"

namespace markerless_mocap {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

int runTool(const char* name, const std::function<void()>& work) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is told as any that cannot be written
  try {
    work();
  } catch (const std::exception& error) {
    std::cerr << name << ": " << printable(error.what()) << std::endl;
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
