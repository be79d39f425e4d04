#include "tools/common/run_tool.h"

#include <csignal>
#include <exception>
#include <iostream>

namespace markerless_mocap {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

int runTool(const char* name, const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
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

}  // namespace markerless_mocap
