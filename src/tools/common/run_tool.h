#pragma once

#include <functional>

namespace markerless_mocap {

/// Does the work of a program and says on the error stream why it could not be done. Returns the
/// exit code.
int runTool(const char* name, const std::function<void()>& work);

/// From now on SIGINT and SIGTERM only make the returned function true, so that a run can end by
/// itself and remove what it has begun to write; a second signal ends it at once.
std::function<bool()> catchInterruptions();

}  // namespace markerless_mocap
