#include "talus/archive/rock_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/sample_run.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using Texts = std::vector<std::string>;

template <class Row>
std::vector<Texts> texts_of_rows(const std::vector<Row>& rows) {
  std::vector<Texts> texts;
  for (const Row& row : rows) texts.push_back(texts_of(row));
  return texts;
}

/// Rocks 0, 3, 6 ... with 0 to 2 hits each on barriers whose names need quotes, some with a line end in them.
struct Hits {
  std::string text = sample_run::barriers_head;
  std::vector<std::vector<Texts>> of_rock;
};

Hits many_hits(std::uint64_t rocks) {
  Hits hits;
  hits.of_rock.resize(rocks);
  for (std::uint64_t rock = 0; rock < rocks; rock += 3) {
    for (std::uint64_t k = 0; k < rock % 4 % 3; ++k) {
      const std::string name = k == 0 ? "upper, \"old\"" : "lower\n17,17,";
      const std::string quoted = k == 0 ? R"("upper, ""old""")" : "\"lower\n17,17,\"";
      const std::string time = fmt::format("{}.5", rock + k);
      hits.text += fmt::format("{},{},{},1,2,3,0.5,1,0,-1,10,5,6,11,stopped,,1.5\n", quoted, rock, time);
      hits.of_rock[rock].push_back({name, std::to_string(rock), time, "1", "2", "3", "0.5", "1", "0", "-1", "10", "5",
                                    "6", "11", "stopped", "", "1.5"});
    }
  }
  return hits;
}

TEST(RowsOfARock, AreFoundAnywhereInTheTable) {
  const sample_run::Folder folder("rock-rows");
  constexpr std::uint64_t rocks = 60'000;
  const Hits hits = many_hits(rocks);
  ASSERT_GT(hits.text.size(), 5U << 16U) << "too small to be searched";
  folder.write("barriers.csv", hits.text);
  for (std::uint64_t rock = 0; rock < rocks; rock += rock < 40 || rock > rocks - 40 ? 1 : 193)
    EXPECT_EQ(texts_of_rows(rows_of_rock<HitRow>(folder.path, rock)), hits.of_rock[rock]) << rock;
  EXPECT_TRUE(rows_of_rock<HitRow>(folder.path, rocks + 5).empty());
}

TEST(RowsOfARock, AreAllRowsOfItsPath) {
  const sample_run::Folder folder("rock-rows");
  std::string text = sample_run::paths_head;
  for (std::uint64_t rock = 0; rock < 3000; ++rock) text += sample_run::path_rows(rock);
  ASSERT_GT(text.size(), 5U << 16U);
  folder.write("paths.csv", text);
  for (const std::uint64_t rock : {0, 1, 999, 1000, 2047, 2999}) {
    const auto rows = texts_of_rows(rows_of_rock<PathEventRow>(folder.path, rock));
    ASSERT_EQ(rows.size(), 4U) << rock;
    EXPECT_EQ(rows[1], (Texts{std::to_string(rock), "1", "impact", "1.577", "3.1", "0", "-12.2", "1.5", "0", "-15.47",
                              "0", "0", "0", "120766.13", "0", "0"}));
  }
}

// Columns have been added at the end, and all of them may be empty.
TEST(RowsOfARock, MayBeOfATableOfAnOlderProgram) {
  const sample_run::Folder folder("rock-rows");
  folder.write(
      "endpoints.csv",
      "rock,seeder,x_m,y_m,z_m,runout_xy_m,runout_z_m,runout_total_m,lateral_m,time_s,events,end_reason,ground,"
      "mass_kg,radius_m,max_ke_J,max_bounce_m,ensemble\n"
      "0,Crest,1,2,3,4,5,6,,7,8,at rest,Rock,9,1,10,11,4\n");
  const std::vector<EndpointRow> rows = rows_of_rock<EndpointRow>(folder.path, 0);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].max_bounce_m, 11);
  EXPECT_EQ(rows[0].ensemble, 4U);
  EXPECT_EQ(rows[0].a_m, std::nullopt);
  EXPECT_EQ(rows[0].short_axis_share, std::nullopt);
}

TEST(RowsOfARock, AreRefusedFromAnotherFile) {
  const sample_run::Folder folder("rock-rows");
  folder.write("endpoints.csv", "rock,seeder\n0,Crest\n");
  EXPECT_THROW((void)rows_of_rock<EndpointRow>(folder.path, 0), BadInput);
  folder.write("endpoints.csv", sample_run::endpoints_head + "0,cut");
  EXPECT_THROW((void)rows_of_rock<EndpointRow>(folder.path, 0), BadInput);
  EXPECT_THROW((void)rows_of_rock<EndpointRow>(folder.path / "nothing", 0), BadInput);
}

}  // namespace
}  // namespace talus
