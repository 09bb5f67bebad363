// Work that is stopped on request.

#include "talus/core/stop.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace talus::core_stop_test {
namespace {

using namespace std::chrono_literals;

TEST(StopPoints, DoNothingWithoutAScope) {
  EXPECT_EQ(StopScope::current(), nullptr);
  EXPECT_NO_THROW(stop_point());
}

TEST(StopPoints, StopTheWorkOfTheirScope) {
  std::atomic<bool> outer_stop{false}, inner_stop{false};
  const StopScope outer(&outer_stop);
  EXPECT_NO_THROW(stop_point());
  {
    const StopScope inner(&inner_stop);
    EXPECT_NO_THROW(stop_point());
    inner_stop = true;
    EXPECT_THROW(stop_point(), Stopped);
  }
  EXPECT_NO_THROW(stop_point()) << "only the inner work was stopped";
  outer_stop = true;
  inner_stop = false;
  const StopScope inner(&inner_stop);
  EXPECT_THROW(stop_point(), Stopped) << "the outer work was stopped, and all within it";
}

TEST(StopPoints, OfALoopCheckAtIntervals) {
  const std::atomic<bool> stop{true};
  const StopScope scope(&stop);
  EXPECT_THROW(stop_point(0), Stopped);
  EXPECT_NO_THROW(stop_point(1));
  EXPECT_THROW(stop_point(1024), Stopped);
}

TEST(StopPoints, StopOtherThreadsThroughAScopeOfTheirOwn) {
  const std::atomic<bool> stop{true};
  const StopScope here(&stop);
  bool without = false, with = false;
  std::thread([&] {
    const auto is_stopped = [] {
      try {
        stop_point();
      } catch (const Stopped&) {
        return true;
      }
      return false;
    };
    without = is_stopped();
    const StopScope there(&here);
    with = is_stopped();
  }).join();
  EXPECT_FALSE(without);
  EXPECT_TRUE(with);
}

TEST(StopPoints, StopWorkWhoseTimeIsOver) {
  const TimeLimit none(0s), much(1h), little(50ms);
  EXPECT_TRUE(none.is_over());
  EXPECT_FALSE(much.is_over());
  const auto begin = std::chrono::steady_clock::now();
  while (!little.is_over() && std::chrono::steady_clock::now() - begin < 1min) {
  }
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 50ms);
  const StopScope endless(nullptr, &much);
  EXPECT_NO_THROW(stop_point());
  const StopScope scope(nullptr, &little);
  EXPECT_THROW(stop_point(), Stopped);
}

}  // namespace
}  // namespace talus::core_stop_test
