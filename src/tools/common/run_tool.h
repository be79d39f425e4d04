#pragma once

#include <functional>
#include <string>

namespace markerless_mocap {

/// Runs the work of a program. An exception is printed to the error stream. Returns the exit code.
int runTool(const char* name, const std::function<void()>& work);

/// After this call, SIGINT, SIGTERM and SIGHUP set the result of the returned function to true, so
/// that a run can stop and remove incomplete output. A second signal ends the program at once.
std::function<bool()> catchInterruptions();
/// What that function returns.
bool isInterrupted();

/// How whoever called this program calls another one of the package: by scripts/run, which says so
/// in MARKERLESS_MOCAP_RUN, else by rosrun.
std::string callOf(const std::string& program);

}  // namespace markerless_mocap
