#include "talus/archive/table_rocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace talus {
namespace {

TEST(TableRocks, HaveAnEndPointForEveryPath) {
  constexpr std::uint64_t rocks = 5000;
  const TableRocks::Limit all;
  for (const TableRocks::Limit endpoints : {all, TableRocks::Limit(0), TableRocks::Limit(30), TableRocks::Limit(777)}) {
    for (const TableRocks::Limit paths : {all, TableRocks::Limit(0), TableRocks::Limit(100)}) {
      const TableRocks tables(rocks, {endpoints, paths});
      std::uint64_t ends = 0, ways = 0;
      for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        EXPECT_EQ(tables.endpoints_before(rock), ends);
        EXPECT_EQ(tables.paths_before(rock), ways);
        EXPECT_TRUE(tables.has_endpoint(rock) || !tables.has_path(rock)) << rock;
        ends += tables.has_endpoint(rock) ? 1 : 0;
        ways += tables.has_path(rock) ? 1 : 0;
      }
      EXPECT_EQ(ways, paths.value_or(rocks));
      EXPECT_EQ(ends, std::max(ways, endpoints.value_or(rocks)));
      EXPECT_EQ(tables.paths(), ways);
      EXPECT_EQ(tables.endpoints(), ends);
    }
  }
}

}  // namespace
}  // namespace talus
