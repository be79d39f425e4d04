#include "files/whole_file.h"

#include <gtest/gtest.h>

#include <iterator>

#include "error_text_of.h"
#include "files/output_lock.h"

namespace markerless_mocap {
namespace {

class WholeFile : public ::testing::Test {
 protected:
  WholeFile()
      : folder_(std::filesystem::temp_directory_path() /
                ("mocap_files_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~WholeFile() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string bytesOf(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  long files() const { return std::distance(std::filesystem::directory_iterator(folder_), {}); }

  std::filesystem::path folder_;
};

TEST_F(WholeFile, ReplacesAFile) {
  writeWholeFile(path("a"), "first");
  writeWholeFile(path("a"), std::string("se\0cond", 7));
  EXPECT_EQ(bytesOf("a"), std::string("se\0cond", 7));
  EXPECT_EQ(files(), 1);
}

TEST_F(WholeFile, StaysAsItWasIfWritingFails) {
  writeWholeFile(path("a"), "first");
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] {
              writeWholeFileBy(path("a"), [](const std::string& active) {
                std::ofstream(active) << "hal";
                return false;
              });
            }),
            "cannot write " + path("a"));
  EXPECT_EQ(bytesOf("a"), "first");
  EXPECT_EQ(files(), 1);
}

TEST_F(WholeFile, AnExceptionLeavesNoDraft) {
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] {
              writeWholeFileBy(path("a"), [](const std::string&) -> bool {
                throw std::runtime_error("no more room");
              });
            }),
            "no more room");
  EXPECT_EQ(files(), 0);
}

TEST_F(WholeFile, TheSecondWriterOfAnOutputIsRefused) {
  {
    const OutputLock first(path("a"));
    EXPECT_EQ(errorTextOf<std::runtime_error>([&] { OutputLock second(path("a")); }),
              "cannot write " + path("a") + ": another program is writing it now");
    const OutputLock other(path("b"));
  }
  EXPECT_EQ(files(), 0);
  EXPECT_NO_THROW(OutputLock(path("a")));
}

TEST_F(WholeFile, ALockThatAKilledProgramLeftBehindHoldsNothing) {
  std::ofstream(path("a.lock")) << "";
  EXPECT_NO_THROW(OutputLock(path("a")));
}

TEST_F(WholeFile, WhatIsNoFileIsTold) {
  EXPECT_EQ(
      errorTextOf<std::runtime_error>([&] { writeWholeFile(folder_.string(), "x"); }),
      "cannot write " + folder_.string() + ": it is a folder, pipe or device, allowed are files");
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { writeWholeFile("", "x"); }),
            "the name of the file to write is empty");
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { writeWholeFile(path("no/a"), "x"); }),
            "cannot write " + path("no/a") + ": its folder is missing or may not be written");
}

}  // namespace
}  // namespace markerless_mocap
