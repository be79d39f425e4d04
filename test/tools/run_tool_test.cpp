#include "tools/common/run_tool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <system_error>

#include "files/whole_file.h"

namespace markerless_mocap {
namespace {

TEST(RunTool, SaysWhyTheWorkCouldNotBeDone) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(runTool("tool", [] { throw std::runtime_error("there is no bag"); }), 1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "tool: there is no bag\n");
}

TEST(RunTool, WhatStoodInADamagedFileIsShownSafely) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(runTool("tool", [] { throw std::runtime_error("'x' holds \x1b[2J"); }), 1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "tool: 'x' holds ?[2J\n");
}

TEST(RunTool, TooLittleMemoryAndThreadsAreTold) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(runTool("tool", [] { throw std::bad_alloc(); }), 1);
  EXPECT_EQ(runTool("tool", [] { throw std::system_error(EAGAIN, std::generic_category()); }), 1);
  EXPECT_EQ(
      testing::internal::GetCapturedStderr(),
      "tool: there is not enough memory, or this process may not use it (ulimit -v)\n"
      "tool: no further thread can be started (ulimit -u): Resource temporarily unavailable\n");
}

TEST(RunTool, TooFewOpenFilesAreTold) {
  EXPECT_EXIT(
      {
        rlimit few{};
        few.rlim_cur = few.rlim_max = 8;
        setrlimit(RLIMIT_NOFILE, &few);
        std::_Exit(runTool("tool", [] {}));
      },
      testing::ExitedWithCode(1), "^tool: this process may open 8 files, allowed are 16 and more");
}

TEST(RunTool, AFileThatMayNotGrowFailsToBeWritten) {
  EXPECT_EXIT(
      {
        rlimit size{};
        size.rlim_cur = size.rlim_max = 4096;
        setrlimit(RLIMIT_FSIZE, &size);
        const std::string file = ::testing::TempDir() + "run_tool_test_" + std::to_string(getpid());
        const int code = runTool("tool", [&] { writeWholeFile(file, std::string(9000, 'x')); });
        std::_Exit(code + (std::filesystem::exists(file) ? 2 : 0));
      },
      testing::ExitedWithCode(1), "^tool: cannot write .*: files may not become that large");
}

TEST(RunTool, IsSilentWhenAllIsWell) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(runTool("tool", [] {}), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(RunTool, ProgramsAreNamedAsTheirCallerCallsThem) {
  unsetenv("MARKERLESS_MOCAP_RUN");
  EXPECT_EQ(callOf("mocap_offline"), "rosrun markerless_mocap mocap_offline");
  setenv("MARKERLESS_MOCAP_RUN", "../mocap/scripts/run", 1);
  EXPECT_EQ(callOf("mocap_offline"), "../mocap/scripts/run mocap_offline");
  unsetenv("MARKERLESS_MOCAP_RUN");
}

TEST(RunTool, TheFirstSignalAsksAndTheSecondEnds) {
  EXPECT_EXIT(
      {
        const auto interrupted = catchInterruptions();
        if (interrupted()) std::_Exit(1);
        std::raise(SIGINT);
        if (!interrupted()) std::_Exit(2);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(RunTool, AClosedTerminalAsksUnlessItIsToBeIgnored) {
  EXPECT_EXIT(
      {
        const auto interrupted = catchInterruptions();
        std::raise(SIGHUP);
        std::_Exit(interrupted() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        const auto interrupted = catchInterruptions();
        std::raise(SIGHUP);
        std::_Exit(interrupted() ? 1 : 0);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace markerless_mocap
