// Statistics of a run's tables equal those of its summary; filters are compared with counts made here.

#include "talus/archive/column_statistics.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/run_columns.hpp"
#include "support/sample_run.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/summary_json.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/csv_reader.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/run.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::map<std::string, std::string>;

/// 75 rocks of two sources, with a fence and a collector (run_files.hpp).
class StatisticsOfARun : public ::testing::Test {
 protected:
  StatisticsOfARun() : folder_("column-statistics") {
    const test::Workplace work;
    const std::string file = test::write_slope_with_barrier(work);
    Problems warnings;
    const project::Project project = project::read_project(file).project;
    const Model model = project::build_model(project, warnings);
    (void)project::run_into(folder_.path, project, model, warnings, {});
    facts_ = read_run_facts(folder_.path);
    summary_ = Json::parse(folder_.read("summary.json"));
    rows_of("endpoints.csv", endpoint_columns, ends_);
    rows_of("barriers.csv", barrier_columns, hits_);
  }

  [[nodiscard]] std::uint64_t count(const RockFilter& filter) const {
    return endpoint_statistics(folder_.path, facts_, "x_m", filter).count();
  }
  [[nodiscard]] std::uint64_t count_if(const std::function<bool(const Row&)>& passes) const {
    return static_cast<std::uint64_t>(std::count_if(ends_.begin(), ends_.end(), passes));
  }
  [[nodiscard]] bool hit(const std::string& rock, const std::string& barrier) const {
    return std::any_of(hits_.begin(), hits_.end(),
                       [&](const Row& row) { return row.at("rock") == rock && row.at("barrier") == barrier; });
  }

  sample_run::Folder folder_;
  RunFacts facts_;
  Json summary_;
  std::vector<Row> ends_, hits_;

 private:
  void rows_of(const char* name, std::span<const std::string_view> columns, std::vector<Row>& rows) const {
    CsvReader row(folder_.path / name, columns);
    while (row.next()) {
      Row& texts = rows.emplace_back();
      for (std::size_t k = 0; k < columns.size(); ++k) texts[std::string(columns[k])] = row.text(k);
    }
  }
};

TEST_F(StatisticsOfARun, AreThoseOfItsSummary) {
  const std::map<std::string, std::string> columns{{"end_x_m", "x_m"},
                                                   {"runout_xy_m", "runout_xy_m"},
                                                   {"runout_total_m", "runout_total_m"},
                                                   {"max_ke_J", "max_ke_J"},
                                                   {"max_bounce_m", "max_bounce_m"}};
  ASSERT_EQ(summary_["statistics"].size(), columns.size());
  for (const auto& [key, column] : columns) {
    const Tally tally = endpoint_statistics(folder_.path, facts_, column, {});
    EXPECT_EQ(json_of(statistics_of(tally)), summary_["statistics"][key]) << key;
  }
}

TEST_F(StatisticsOfARun, OfABarrierAreThoseOfItsSummary) {
  ASSERT_EQ(facts_.barriers.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const Json& known = summary_["barriers"][k]["statistics"];
    ASSERT_GT(known["velocity_m_s"]["count"], 5);
    for (const char* column : {"velocity_m_s", "impact_height_m"}) {
      const Tally tally = barrier_statistics(folder_.path, facts_, facts_.barriers[k].name, column, {});
      EXPECT_EQ(json_of(statistics_of(tally)), known[column]) << column;
    }
    // Their squares are summed in another order in the table.
    for (const char* column : {"ke_translational_J", "ke_total_J"}) {
      const Descriptive found =
          barrier_statistics(folder_.path, facts_, facts_.barriers[k].name, column, {}).describe();
      EXPECT_EQ(found.count, known[column]["count"]);
      EXPECT_NEAR(*found.mean, known[column]["mean"], 1e-14 * *found.mean);
      EXPECT_NEAR(*found.maximum, known[column]["maximum"], 1e-15 * *found.maximum);
    }
  }
}

TEST_F(StatisticsOfARun, CountTheRocksThatPassAFilter) {
  const auto is = [](const char* column, const std::string& text) {
    return [=](const Row& row) { return row.at(column) == text; };
  };
  EXPECT_EQ(count({}), ends_.size());
  const std::uint64_t at_rest = count_if(is("end_reason", "at rest"));
  const std::uint64_t stopped = count_if(is("end_reason", "stopped by a barrier"));
  ASSERT_TRUE(at_rest > 0 && stopped > 0 && at_rest + stopped <= ends_.size());
  EXPECT_EQ(count({.end_reasons = {"at rest"}}), at_rest);
  EXPECT_EQ(count({.end_reasons = {"at rest", "stopped by a barrier"}}), at_rest + stopped);
  EXPECT_EQ(count({.end_reasons = {"lost"}}), 0U);
  EXPECT_EQ(count({.seeders = {"Ledge"}}), 25U);
  EXPECT_EQ(count({.sources = {"Ledge"}}), 25U);
  EXPECT_EQ(count({.sources = {"Ledge", ends_[0].at("seeder")}}), ends_.size());
  EXPECT_EQ(count({.end_reasons = {"at rest"}, .seeders = {"Ledge"}}),
            count_if([](const Row& row) { return row.at("seeder") == "Ledge" && row.at("end_reason") == "at rest"; }));

  const std::uint64_t fence = count_if([&](const Row& row) { return hit(row.at("rock"), "Fence"); });
  ASSERT_TRUE(fence > 0 && fence < ends_.size());
  EXPECT_EQ(count({.barriers = {"Fence"}}), fence);
  EXPECT_EQ(count({.barriers = {"Fence", facts_.barriers[1].name}}), count_if([&](const Row& row) {
              return hit(row.at("rock"), "Fence") || hit(row.at("rock"), facts_.barriers[1].name);
            }));

  const double energy = std::stod(ends_[10].at("max_ke_J"));  // a limit is inclusive
  const std::uint64_t most = count_if([&](const Row& row) { return std::stod(row.at("max_ke_J")) <= energy; });
  ASSERT_TRUE(most > 0 && most < ends_.size());
  EXPECT_EQ(count({.most_energy_J = energy}), most);
  EXPECT_EQ(count({.least_energy_J = energy}) + most, ends_.size() + 1);
  EXPECT_EQ(count({.least_energy_J = energy, .most_energy_J = energy}), 1U);
}

TEST_F(StatisticsOfARun, OfABarrierCountTheHitsOfThoseRocks) {
  const RockFilter filter{.seeders = {"Ledge"}};
  std::map<std::string, std::string> seeder_of;
  for (const Row& row : ends_) seeder_of[row.at("rock")] = row.at("seeder");
  std::vector<double> heights;
  for (const Row& row : hits_)
    if (row.at("barrier") == "Fence" && seeder_of.at(row.at("rock")) == "Ledge")
      heights.push_back(std::stod(row.at("impact_height_m")));
  ASSERT_FALSE(heights.empty());
  const Tally tally = barrier_statistics(folder_.path, facts_, "Fence", "impact_height_m", filter);
  EXPECT_EQ(tally.count(), heights.size());
  EXPECT_EQ(tally.describe().maximum, *std::max_element(heights.begin(), heights.end()));
  // The fence runs along y from 0.
  const Descriptive stations = barrier_statistics(folder_.path, facts_, "Fence", "station_m", {}).describe();
  const Descriptive y = barrier_statistics(folder_.path, facts_, "Fence", "y_m", {}).describe();
  EXPECT_NEAR(*stations.minimum, *y.minimum, 1e-9);
  EXPECT_NEAR(*stations.maximum, *y.maximum, 1e-9);
}

TEST_F(StatisticsOfARun, CoverEveryQuantity) {
  constexpr std::array<std::string_view, 4> of_blocks{"a_m", "b_m", "c_m", "short_axis_share"};
  const auto check = [&](const auto& columns, const std::vector<NumberColumn>& numbers, const auto& tally_of) {
    for (const std::string_view column : columns) {
      const bool is_number = column != "rock" && column != "seeder" && column != "end_reason" && column != "ground" &&
                             column != "barrier" && column != "outcome" && column != "ensemble";
      const auto found = std::ranges::find(numbers, column, &NumberColumn::name);
      EXPECT_EQ(found != numbers.end(), is_number) << column;
    }
    for (const NumberColumn& number : numbers) {
      const bool is_of_blocks = std::ranges::find(of_blocks, number.name) != std::end(of_blocks);
      const bool has_values = number.name != "lateral_m" && !is_of_blocks;  // there is no line, and rocks are points
      EXPECT_EQ(tally_of(number.name).count() > 0, has_values) << number.name;
    }
  };
  check(column_names<EndpointRow>, endpoint_numbers(),
        [&](std::string_view column) { return endpoint_statistics(folder_.path, facts_, column, {}); });
  check(barrier_columns, barrier_numbers(),
        [&](std::string_view column) { return barrier_statistics(folder_.path, facts_, "Fence", column, {}); });
}

TEST_F(StatisticsOfARun, AreRefusedForADamagedTable) {
  folder_.write("endpoints.csv", folder_.read("endpoints.csv") + "75,cut");
  EXPECT_THROW((void)endpoint_statistics(folder_.path, facts_, "x_m", {}), BadInput);
}

// A section in map coordinates, with too many rocks to keep their values: quantiles come from counts in bins.
TEST(StatisticsOfManyRocks, AreAccurateForLargeCoordinates) {
  const sample_run::Folder folder("column-statistics");
  folder.write("utm.toml", R"(
name = "Eastings"
[terrain]
section = [[652100, 1830], [652110, 1820], [652200, 1790], [652300, 1788]]
[[material]]
name = "A"
normal_restitution = { mean = 0.35, distribution = "normal", std_dev = 0.04 }
tangential_restitution = { mean = 0.85, distribution = "uniform", rel_min = 0.1, rel_max = 0.1 }
friction_angle_deg = 30
[[seeder]]
position = [652101, "surface"]
rocks = 100001
mass_kg = 1000
horizontal_velocity_m_s = 2
[output]
paths = "none"
report = false
)");
  Problems warnings;
  const project::Project project = project::read_project(folder.path / "utm.toml").project;
  const Model model = project::build_model(project, warnings);
  (void)project::run_into(folder.path, project, model, warnings, {});
  const RunFacts facts = read_run_facts(folder.path);
  const Json summary = Json::parse(folder.read("summary.json"));
  EXPECT_EQ(summary["origin_m"].dump(), "[652288.0,0.0,2048.0]");
  std::map<std::string, std::vector<double>> values;
  CsvReader row(folder.path / "endpoints.csv", endpoint_columns);
  while (row.next()) {
    values["x_m"].push_back(row.number(2));
    values["z_m"].push_back(row.number(4));
  }
  for (auto& [column, list] : values) {
    std::sort(list.begin(), list.end());
    const Tally tally = endpoint_statistics(folder.path, facts, column, {});
    EXPECT_FALSE(tally.sketch().is_exact());
    for (const double p : {0.25, 0.5, 0.75, 0.95}) {  // most are at least 260 m from the origin
      const double exact = list[static_cast<std::size_t>(p * 100'000)];
      EXPECT_NEAR(*tally.sketch().quantile(p), exact, 0.0005 * 260) << column << " " << p;
    }
    EXPECT_GT(tally.histogram(40)->counts().size(), 10U);
  }
  EXPECT_EQ(json_of(statistics_of(endpoint_statistics(folder.path, facts, "x_m", {}))),
            summary["statistics"]["end_x_m"]);
}

TEST(Cumulative, RisesToOneThroughTheValues) {
  Tally tally(1000);
  for (int k = 0; k < 1000; ++k) tally.add(k % 500);
  const auto points = cumulative(tally, 50);
  EXPECT_LE(points.size(), 52U);
  EXPECT_GE(points.size(), 40U);
  EXPECT_EQ(points.front().value, 0);
  EXPECT_DOUBLE_EQ(points.front().share, 2.0 / 1000);
  EXPECT_EQ(points.back().value, 499);
  EXPECT_DOUBLE_EQ(points.back().share, 1);
  for (const auto& [value, share] : points) EXPECT_DOUBLE_EQ(share, (value + 1) / 500);
}

TEST(Cumulative, HasAllOfAFewValues) {
  Tally tally(3);
  for (const double x : {2.0, 7.0, 2.0}) tally.add(x);
  const auto points = cumulative(tally, 50);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_DOUBLE_EQ(points[0].share, 2.0 / 3);
  EXPECT_TRUE(cumulative(Tally(3), 50).empty());
}

}  // namespace
}  // namespace talus
