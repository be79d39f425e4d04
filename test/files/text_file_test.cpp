#include "files/text_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

class TextFileTest : public testing::Test {
 protected:
  TextFileTest() { std::filesystem::create_directories(folder_); }
  ~TextFileTest() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string refusal(const std::string& path) {
    return errorTextOf<std::runtime_error>([&] { readTextFile(path, "the text"); });
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("text_file_test_" + std::to_string(getpid()));
};

TEST_F(TextFileTest, BytesComeAsTheyAre) {
  const std::string text = std::string("a\r\n\0b", 5) + std::string(40000, 'x');
  std::ofstream(path("text"), std::ios::binary) << text;
  EXPECT_EQ(readTextFile(path("text"), "the text"), text);
  std::ofstream(path("empty")).close();
  EXPECT_EQ(readTextFile(path("empty"), "the text"), "");
}

TEST_F(TextFileTest, WhatIsNoFileIsRefusedAndDoesNotBlock) {
  EXPECT_EQ(refusal(path("nothing")), "cannot read the text: there is no such file");
  ASSERT_EQ(mkfifo(path("fifo").c_str(), 0600), 0);
  const std::string sentence =
      "cannot read the text: it is a folder, pipe or device, allowed are files";
  EXPECT_EQ(refusal(path("fifo")), sentence);
  EXPECT_EQ(refusal("/dev/zero"), sentence);
  EXPECT_EQ(refusal(folder_.string()), sentence);
  EXPECT_EQ(refusal(""), "cannot read a file: its name is empty");
}

TEST_F(TextFileTest, LargeFilesAreRefusedUnread) {
  std::ofstream(path("large")).close();
  std::filesystem::resize_file(path("large"), 17u << 20);
  EXPECT_EQ(refusal(path("large")), "cannot read the text: it has 17 MB, allowed are 16 MB");
}

}  // namespace
}  // namespace markerless_mocap
