#include "talus/archive/report_envelopes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Optional;

ReportEnvelopes envelopes_read(const std::string& text) {
  const sample_run::Folder folder("report-envelopes");
  folder.write("envelopes.csv", text);
  return read_report_envelopes(folder.path / "envelopes.csv");
}

std::string envelopes_message(const std::string& text) {
  try {
    (void)envelopes_read(text);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "none";
}

TEST(ReportEnvelopes, HaveTheColumnsThatAreDrawn) {
  const ReportEnvelopes read = envelopes_read(
      "x_m,passages,reach_share,energy_total_max_kJ,energy_translational_max_kJ,velocity_p95_m_s\n"
      "0.5,2,1,200,150,3.5\n1.5,0,0,,,\n");
  EXPECT_THAT(read.columns, ElementsAre("reach_share", "energy_total_max_kJ", "velocity_p95_m_s"));
  ASSERT_EQ(read.cells.size(), 2U);
  EXPECT_EQ(read.cells_each, 1U);
  EXPECT_EQ(read.cells[0].from_x_m, 0.5);
  EXPECT_EQ(read.cells[0].to_x_m, 0.5);
  EXPECT_THAT(read.cells[0].values, ElementsAre(Optional(1.0), Optional(200.0), Optional(3.5)));
  EXPECT_THAT(read.cells[1].values, ElementsAre(Optional(0.0), std::nullopt, std::nullopt));
}

TEST(ReportEnvelopes, CombineCellsByTheirMaximum) {
  const std::size_t rows = 2 * most_report_envelope_cells + 500;
  std::string text = "x_m,velocity_max_m_s\n";
  // The first of every three is the fastest; the last two rows have no value.
  for (std::size_t k = 0; k < rows; ++k) {
    text += fmt::format("{},{}\n", k, k + 2 < rows ? (k % 3 == 0 ? fmt::format("{}.5", k) : "0.25") : "");
  }
  const ReportEnvelopes read = envelopes_read(text);
  EXPECT_EQ(read.cells_each, 3U);
  ASSERT_EQ(read.cells.size(), (rows + 2) / 3);
  for (std::size_t n = 0; n + 1 < read.cells.size(); ++n) {
    EXPECT_EQ(read.cells[n].from_x_m, 3.0 * static_cast<double>(n));
    EXPECT_EQ(read.cells[n].to_x_m, 3.0 * static_cast<double>(n) + 2);
    EXPECT_THAT(read.cells[n].values, ElementsAre(Optional(3.0 * static_cast<double>(n) + 0.5)));
  }
  EXPECT_EQ(read.cells.back().to_x_m, static_cast<double>(rows - 1));
  EXPECT_EQ(envelopes_read(text.substr(0, text.find("\n1000,") + 1)).cells_each, 1U) << "as many as a page can show";
}

TEST(ReportEnvelopes, RefuseOtherFiles) {
  EXPECT_THAT(envelopes_message("rock,time_s\n0,1\n"),
              HasSubstr("envelopes.csv:1: the columns are \"rock,time_s\" (expected \"x_m,...\")"));
  EXPECT_THAT(envelopes_message("x_m,velocity_max_m_s\n0.5,fast\n"),
              HasSubstr("envelopes.csv:2: velocity_max_m_s: \"fast\" is not a number"));
  EXPECT_THAT(envelopes_message("x_m,velocity_max_m_s\n0.5,1\n1.5\n"),
              HasSubstr("envelopes.csv:3: the row has 1 values"));
  EXPECT_THAT(envelopes_message(""), HasSubstr("the file is empty"));
}

}  // namespace
}  // namespace talus
