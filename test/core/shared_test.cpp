// Values that copies share.

#include "talus/core/shared.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace talus::shared_test {
namespace {

TEST(Shared, IsNotCopied) {
  const Shared<std::vector<int>> list = std::vector{1, 2, 3};
  const Shared<std::vector<int>> copy = list;
  EXPECT_EQ(copy->data(), list->data());
  EXPECT_EQ(copy->size(), 3u);
}

TEST(Shared, OfACopyCanBeReplaced) {
  Shared<std::vector<int>> list = std::vector{1, 2, 3};
  const Shared<std::vector<int>> copy = list;
  list = std::vector{4};
  EXPECT_EQ(*list, std::vector{4});
  EXPECT_EQ(*copy, (std::vector{1, 2, 3}));
  EXPECT_TRUE(Shared<std::vector<int>>()->empty());
}

}  // namespace
}  // namespace talus::shared_test
