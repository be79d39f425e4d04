#include "tools/common/bags_in_threads.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace markerless_mocap {
namespace {

// Without the object, the process crashes each time.
TEST(BagsInThreads, BagsAreMadeAndEndedByTwoThreads) {
  constexpr int kThreads = 2, kBags = 200;
  const BagsInThreads held;
  std::vector<int> made(kThreads, 0);
  std::vector<std::thread> threads;
  for (int& count : made)
    threads.emplace_back([&count] {
      for (int i = 0; i < kBags; ++i) {
        const rosbag::Bag bag;
        ++count;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, std::vector<int>(kThreads, kBags));
}

}  // namespace
}  // namespace markerless_mocap
