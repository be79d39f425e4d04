#include "numerics/order_statistics.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(OrderStatisticsTest, MedianIsTheMiddleOrTheUpperOfTwo) {
  EXPECT_EQ(medianOf(std::vector<int>{9, 1, 5}), 5);
  EXPECT_EQ(medianOf(std::vector<int>{9, 1, 5, 7}), 7);
  EXPECT_EQ(medianOf(std::vector<double>{2.5}), 2.5);
}

TEST(OrderStatisticsTest, QuantileIsAValueThatOccurs) {
  const std::vector<double> values{40, 10, 30, 20, 50};
  EXPECT_EQ(quantileOf(values, 0), 10);
  EXPECT_EQ(quantileOf(values, 0.25), 20);
  EXPECT_EQ(quantileOf(values, 0.3), 20);
  EXPECT_EQ(quantileOf(values, 1), 50);
}

TEST(OrderStatisticsTest, NearestQuantileRoundsThePlace) {
  const std::vector<double> values{40, 10, 30, 20, 50};
  EXPECT_EQ(nearestQuantile(values, 0.3), 20);
  EXPECT_EQ(nearestQuantile(values, 0.4), 30);
  EXPECT_EQ(nearestQuantile({}, 0.5), 0);
}

TEST(OrderStatisticsTest, InterpolatedQuantileLiesBetweenValues) {
  const std::vector<double> sorted{1, 2, 4, 8};
  EXPECT_DOUBLE_EQ(interpolatedQuantile(sorted, 0), 1);
  EXPECT_DOUBLE_EQ(interpolatedQuantile(sorted, 0.5), 3);
  EXPECT_DOUBLE_EQ(interpolatedQuantile(sorted, 0.9), 4 + 0.7 * 4);
  EXPECT_DOUBLE_EQ(interpolatedQuantile(sorted, 1), 8);
}

}  // namespace
}  // namespace markerless_mocap
