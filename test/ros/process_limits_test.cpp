#include "nodes/common/process_limits.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>

namespace markerless_mocap {
namespace {

void limit(int resource, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  if (setrlimit(__rlimit_resource_t(resource), &value) != 0) std::_Exit(9);
}

void tellAndExit(const std::string& sentence) {
  std::fprintf(stderr, "%s", sentence.c_str());
  std::_Exit(sentence.empty() ? 0 : 1);
}

// Limits hold for a whole process, so each is tried in one of its own.
class ProcessLimits : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(ProcessLimits, ThoseThatMayBeRaisedAreRaised) {
  EXPECT_EXIT(
      {
        limit(RLIMIT_NOFILE, 16, 256);
        const std::string lack = raiseProcessLimits();
        rlimit now{};
        getrlimit(RLIMIT_NOFILE, &now);
        tellAndExit(now.rlim_cur == 256 ? lack : "not raised");
      },
      testing::ExitedWithCode(0), "^$");
}

TEST_F(ProcessLimits, TooFewFilesAreTold) {
  EXPECT_EXIT(
      {
        limit(RLIMIT_NOFILE, 32, 32);
        tellAndExit(raiseProcessLimits());
      },
      testing::ExitedWithCode(1),
      "may open 32 files and connections, allowed are 64 and more.*ulimit -n");
}

TEST_F(ProcessLimits, TooLittleMemoryIsTold) {
  EXPECT_EXIT(
      {
        limit(RLIMIT_AS, 700 << 20, 700 << 20);
        tellAndExit(raiseProcessLimits());
      },
      testing::ExitedWithCode(1),
      "may use 700 MB of addresses, allowed are 1000 MB and more.*ulimit -v");
}

TEST_F(ProcessLimits, FilesThatMayNotGrowAreToldAndDoNotEndTheProcess) {
  EXPECT_EXIT(
      {
        limit(RLIMIT_FSIZE, 4096, 4096);
        const std::string cut = raiseFileSizeLimit();
        std::FILE* file = std::tmpfile();
        const std::string bytes(9000, 'x');
        const bool written = file &&
                             std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() &&
                             std::fflush(file) == 0;
        tellAndExit(written ? "written" : cut);
      },
      testing::ExitedWithCode(1), "may write files of 4 kB only, .*ulimit -f");
}

TEST_F(ProcessLimits, FilesThatMayGrowFurtherAreAllowedTo) {
  EXPECT_EXIT(
      {
        limit(RLIMIT_FSIZE, 4096, RLIM_INFINITY);
        tellAndExit(raiseFileSizeLimit());
      },
      testing::ExitedWithCode(0), "^$");
}

TEST_F(ProcessLimits, AShortageOfFilesIsTold) {
  EXPECT_EXIT(
      {
        limit(RLIMIT_NOFILE, 64, 64);
        const std::string before = shortageOfFiles();
        while (open("/dev/null", O_RDONLY) >= 0) continue;
        tellAndExit(before.empty() ? shortageOfFiles() : "too early");
      },
      testing::ExitedWithCode(1), "of the 64 files and connections .* hardly any is left");
}

}  // namespace
}  // namespace markerless_mocap
