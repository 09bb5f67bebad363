// Statistics and barriers over the API agree with the summary and the tables of the run.

#include "server/served_results.hpp"

#include <algorithm>
#include <map>

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Texts;

using RunStatistics = testing_tools::ServedResults;

/// Expects the counts of a histogram to be those of the numbers.
void expect_counts_of(const Json& histogram, const std::vector<double>& numbers) {
  const auto edges = histogram["edges"].get<std::vector<double>>();
  const auto counts = histogram["counts"].get<std::vector<std::uint64_t>>();
  ASSERT_EQ(counts.size() + 1, edges.size());
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const bool is_last = k + 1 == counts.size();
    const auto inside = std::ranges::count_if(
        numbers, [&](double x) { return x >= edges[k] && (x < edges[k + 1] || (is_last && x == edges[k + 1])); });
    EXPECT_EQ(counts[k], static_cast<std::uint64_t>(inside)) << edges[k];
  }
}

TEST_F(RunStatistics, OfTwoRunsHaveTheSameBins) {
  std::string faster = text_;
  const std::string name = "[[barrier]]\nname = \"";
  ASSERT_NE(faster.find(name), std::string::npos);
  faster.insert(faster.find(name) + name.size(), "Another ");
  const std::string other = begin(faster + "\n[sampling]\nseed = 9\n");
  ASSERT_EQ(wait_for(other, "done")["state"], "done");
  const auto column_of = [&](const std::string& id, std::size_t column) {
    std::vector<double> numbers;
    CsvReader row(folder_of(id) / "endpoints.csv", endpoint_columns);
    while (row.next()) numbers.push_back(row.number(column));
    return numbers;
  };
  for (const char* quantity : {"runout_xy_m", "max_ke_J"}) {
    const Json runs = of("/compared/" + other + "/statistics?of=" + quantity).json()["runs"];
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0]["histogram"]["edges"], runs[1]["histogram"]["edges"]);
    EXPECT_LE(runs[0]["histogram"]["counts"].size(), 50u);
    const auto column =
        static_cast<std::size_t>(std::ranges::find(endpoint_columns, quantity) - std::begin(endpoint_columns));
    expect_counts_of(runs[0]["histogram"], column_of(id_, column));
    expect_counts_of(runs[1]["histogram"], column_of(other, column));
    // Everything else is the same as for the run alone.
    Json alone = of(std::string("/statistics?of=") + quantity).json(), compared = runs[0];
    alone.erase("histogram");
    compared.erase("histogram");
    EXPECT_EQ(compared, alone);
  }
  // A filter may use names of only one run; barriers are matched by name.
  const Json barriers = get("/api/runs/" + other + "/barriers").json()["barriers"];
  const auto found = std::ranges::find_if(
      barriers, [](const Json& one) { return one["name"].get<std::string>().starts_with("Another "); });
  ASSERT_NE(found, barriers.end());
  const std::string barrier = "Another%20" + (*found)["name"].get<std::string>().substr(8);
  const std::string here = "/compared/" + other + "/statistics?of=";
  EXPECT_EQ(of(here + "x_m&barrier=" + barrier).json()["runs"][0]["count"], 0);
  const Json hits = of(here + "ke_total_J&hits_on=" + barrier).json()["runs"];
  EXPECT_EQ(hits[0]["count"], 0);
  EXPECT_EQ(hits[1]["count"], (*found)["hits"]);
  EXPECT_EQ(of(here + "nothing").status, 400);
  EXPECT_EQ(of("/compared/nothing/statistics?of=x_m").status, 404);
}

TEST_F(RunStatistics, AgreeWithTheSummary) {
  const Json summary = of("/summary").json();
  const std::map<std::string, std::string> columns{{"end_x_m", "x_m"},
                                                   {"runout_xy_m", "runout_xy_m"},
                                                   {"runout_total_m", "runout_total_m"},
                                                   {"max_ke_J", "max_ke_J"},
                                                   {"max_bounce_m", "max_bounce_m"}};
  for (const auto& [key, column] : columns) {
    const Json found = of("/statistics?of=" + column).json();
    EXPECT_EQ(found["statistics"].dump(), summary["statistics"][key].dump()) << key;
    EXPECT_EQ(found["count"], 75);
    EXPECT_EQ(found["histogram"]["edges"].size(), found["histogram"]["counts"].size() + 1);
    if (summary["histograms"].contains(key)) {
      EXPECT_EQ(found["histogram"]["counts"], summary["histograms"][key]["counts"]);
      EXPECT_EQ(found["histogram"]["edges"][0], summary["histograms"][key]["low"]);
    }
    EXPECT_EQ(found["box"]["median"], found["statistics"]["median"]);
    EXPECT_EQ(found["box"]["most"], found["statistics"]["maximum"]);
    EXPECT_EQ(found["cumulative"].back()[1], 1);
  }
  EXPECT_EQ(of("/statistics?of=max_ke_J").json()["unit"], "J");
  ASSERT_EQ(summary["barriers"].size(), 2U);
  for (std::size_t k = 0; k < 2; ++k)
    for (const auto& [column, known] : summary["barriers"][k]["statistics"].items())
      EXPECT_EQ(of("/barriers/" + std::to_string(k) + "/statistics?of=" + column).json()["statistics"].dump(),
                known.dump());
}

TEST_F(RunStatistics, CanBeFiltered) {
  const std::vector<Texts> rows = endpoints();
  const auto count = [&](const char* filter) {
    return of(std::string("/statistics?of=x_m&") + filter).json()["count"];
  };
  EXPECT_EQ(count("seeder=Ledge"), 25);
  EXPECT_EQ(count("seeder=Ledge&seeder=Crest"), 75);
  EXPECT_EQ(count("reason=at%20rest").get<std::size_t>(),
            static_cast<std::size_t>(
                std::count_if(rows.begin(), rows.end(), [](const Texts& row) { return row[11] == "at rest"; })));
  EXPECT_EQ(count("min_energy_kJ=100").get<std::size_t>(),
            static_cast<std::size_t>(
                std::count_if(rows.begin(), rows.end(), [](const Texts& row) { return std::stod(row[15]) >= 1e5; })));
  const Json none = of("/statistics?of=x_m&min_energy_kJ=1e9").json();
  EXPECT_EQ(none["count"], 0);
  EXPECT_TRUE(none["box"].is_null());
  EXPECT_TRUE(none["statistics"]["mean"].is_null());
  EXPECT_TRUE(none["histogram"]["counts"].empty());
  for (const char* wrong : {"of=seeder", "of=", "of=x_m&seeder=Nobody", "of=x_m&reason=tired", "of=x_m&barrier=Wall",
                            "of=x_m&source=%3Cb%3E", "of=x_m&min_energy_kJ=much", "of=x_m&max_energy_kJ=inf"})
    EXPECT_EQ(of(std::string("/statistics?") + wrong).status, 400) << wrong;
  EXPECT_EQ(of("/barriers/2/statistics?of=time_s").status, 404);
  EXPECT_EQ(of("/barriers/0/statistics?of=runout_xy_m").status, 400);
}

TEST_F(RunStatistics, OfBarriersAgreeWithTheSummary) {
  const Json summary = of("/summary").json(), barriers = of("/barriers").json()["barriers"];
  ASSERT_EQ(barriers.size(), 2U);
  const Json &fence = barriers[0], &known = summary["barriers"][0];
  EXPECT_EQ(fence["name"], "Fence");
  EXPECT_EQ(fence["kind"], "barrier");
  EXPECT_EQ(fence["height_m"], 1.5);
  EXPECT_EQ(fence["capacity_kJ"], 60);
  EXPECT_EQ(fence["hits"], known["hits"]);
  EXPECT_EQ(fence["stopped"], known["outcomes"]["stopped"]);
  EXPECT_EQ(fence["passed_through"], known["outcomes"]["broke through"]);
  EXPECT_EQ(fence["passed_above"], known["passed_above"]);
  EXPECT_EQ(fence["design"], summary["design"]["lines"][0]);
  EXPECT_EQ(barriers[1]["kind"], "collector");
  EXPECT_TRUE(barriers[1]["capacity_kJ"].is_null());
}

}  // namespace
}  // namespace talus
