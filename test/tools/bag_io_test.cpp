#include "tools/common/bag_io.h"

#include <std_msgs/String.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>

#include "tools/common/run_tool.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

/// From now on this process cannot write more to a file, as on a full disk.
void limitFiles(rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

class BagIo : public ToolTest {
 protected:
  static std_msgs::String textOf(size_t bytes) {
    std_msgs::String message;
    for (size_t i = 0; i < bytes; ++i) message.data.push_back(char('a' + i * i % 23));
    return message;
  }
  std::string refusal(const std::string& output) const {
    return errorTextOf<std::runtime_error>([&] { BagWriter bag(output); });
  }
};

TEST_F(BagIo, ADiskThatIsFullAtTheStartIsASentenceAndLeavesNoFile) {
  EXPECT_EXIT(
      {
        limitFiles(1000);
        std::_Exit(runTool("tool", [&] { BagWriter bag(path("out.bag")); }));
      },
      testing::ExitedWithCode(1), "tool: cannot write .*out.bag: the disk is full");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(BagIo, AFullDiskIsASentenceAndLeavesNoFile) {
  EXPECT_EXIT(
      {
        limitFiles(200000);
        std::_Exit(runTool("tool", [&] {
          BagWriter bag(path("out.bag"), rosbag::compression::Uncompressed);
          for (int i = 1; i < 100; ++i) bag.write("/text", ros::Time(i), textOf(50000));
          bag.commit();
        }));
      },
      testing::ExitedWithCode(1), "tool: cannot write .*out.bag: files may not become that large");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(BagIo, OutputsThatAreNoFilesAreRefusedAtOnce) {
  EXPECT_EQ(refusal(folder_.string()), "cannot write " + folder_.string() +
                                           ": it is a folder, pipe or device, allowed are files");
  EXPECT_EQ(refusal(""), "the name of the file to write is empty");
  EXPECT_EQ(refusal("/dev/null"),
            "cannot write /dev/null: it is a folder, pipe or device, allowed are files");
  EXPECT_EQ(refusal(path("none/out.bag")), "cannot write " + path("none/out.bag") +
                                               ": its folder is missing or may not be written");
}

TEST_F(BagIo, TheSecondWriterOfOneOutputIsRefused) {
  {
    BagWriter first(path("out.bag"));
    first.write("/first", ros::Time(1.0), textOf(10));
    EXPECT_EQ(refusal(path("out.bag")),
              "cannot write " + path("out.bag") + ": another program is writing it now");
    first.commit();
  }
  {
    rosbag::Bag bag;
    openForReading(path("out.bag"), bag);
    EXPECT_EQ(firstMessage<std_msgs::String>(bag, "/first").data, textOf(10).data);
  }
  EXPECT_EQ(refusal(path("out.bag")), "");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(BagIo, DamagedIndexesAreRefusedBeforeTheyAreRead) {
  {
    BagWriter bag(path("in.bag"));
    for (int i = 1; i < 4; ++i) bag.write("/text", ros::Time(i), textOf(500));
    bag.commit();
  }
  const std::string good = bytesOf("in.bag");
  const size_t name = good.find("index_pos=");
  ASSERT_NE(name, std::string::npos);
  uint64_t index = 0;
  std::memcpy(&index, &good[name + 10], sizeof(index));
  for (const size_t at : {index, index + 4}) {  // of the first header, of its first field
    std::string bad = good;
    const uint32_t length = 900000;
    std::memcpy(&bad[at], &length, sizeof(length));
    writeText("bad.bag", bad);
    rosbag::Bag bag;
    EXPECT_EQ(errorTextOf<std::runtime_error>([&] { openForReading(path("bad.bag"), bag); }),
              path("bad.bag") + " is not a bag or was cut off or damaged");
  }
  rosbag::Bag bag;
  EXPECT_NO_THROW(openForReading(path("in.bag"), bag));
}

TEST_F(BagIo, WhatIsNoFileIsToldSo) {
  rosbag::Bag bag;
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { openForReading(folder_.string(), bag); }),
            folder_.string() + " is a folder, pipe or device, allowed are bags");
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { openForReading(path("none.bag"), bag); }),
            "there is no bag " + path("none.bag"));
}

TEST_F(BagIo, AnInterruptionIsASentenceAndLeavesTheFileThatWas) {
  std::ofstream(path("out.bag")) << "the file that was";
  EXPECT_EXIT(
      {
        std::_Exit(runTool("tool", [&] {
          catchInterruptions();
          BagWriter bag(path("out.bag"));
          for (int i = 1; i < 100; ++i) {
            bag.write("/text", ros::Time(i), textOf(10));
            if (i == 10) std::raise(SIGHUP);
          }
          bag.commit();
        }));
      },
      testing::ExitedWithCode(1), "tool: interrupted, .*out.bag is not written");
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    files.push_back(entry.path().filename());
  EXPECT_EQ(files, std::vector<std::string>{"out.bag"});
  EXPECT_EQ(std::filesystem::file_size(path("out.bag")), 17u);
}

TEST_F(BagIo, TheStampZeroIsRefusedInOurWords) {
  BagWriter bag(path("out.bag"));
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { bag.write("/a", ros::Time(), textOf(1)); }),
            "a message of /a has the stamp 0, bags hold later ones");
}

}  // namespace
}  // namespace markerless_mocap
