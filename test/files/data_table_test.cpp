// Tables of users: what is read, and the exact text of what is refused.

#include "talus/files/data_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>

#include "support/input_folder.hpp"

namespace talus {
namespace {

using ::testing::ElementsAre;
using testing_tools::InputFolder;

class DataTables : public InputFolder {
 protected:
  using Rows = std::vector<std::vector<std::string>>;

  Rows rows_of(const std::string& text) {
    write("t.csv", text);
    DataTable table(path("t.csv"));
    columns_.assign(table.columns().begin(), table.columns().end());
    Rows rows;
    lines_.clear();
    while (table.next()) {
      rows.emplace_back();
      for (std::size_t k = 0; k < table.columns().size(); ++k) rows.back().emplace_back(table.text(k));
      lines_.push_back(table.line());
    }
    table.throw_if_any();
    return rows;
  }
  std::string refusal(const std::string& text) {
    return refusal_of([&] { static_cast<void>(rows_of(text)); });
  }

  std::vector<std::string> columns_;
  std::vector<int> lines_;
};

TEST_F(DataTables, AreSeparatedByCommasSemicolonsOrTabs) {
  for (const char separator : {',', ';', '\t'}) {
    std::string text = "a|b\n1|2\n";
    std::ranges::replace(text, '|', separator);
    EXPECT_EQ(rows_of(text), (Rows{{"1", "2"}})) << separator;
    EXPECT_THAT(columns_, ElementsAre("a", "b"));
  }
}

TEST_F(DataTables, MayHaveAByteOrderMarkCommentsEmptyLinesAndNoLastLineEnd) {
  EXPECT_EQ(rows_of("\xEF\xBB\xBF# made by hand\r\na , b\r\n\r\n1, 2 \r\n# the last\n3,4"),
            (Rows{{"1", "2"}, {"3", "4"}}));
  EXPECT_THAT(columns_, ElementsAre("a", "b"));
  EXPECT_THAT(lines_, ElementsAre(4, 6));
}

TEST_F(DataTables, MayQuoteValuesThatContainAnything) {
  EXPECT_EQ(rows_of("name,\"a,b\"\n\"one, \"\"two\"\"\nthree\",5\nx,6\n"),
            (Rows{{"one, \"two\"\nthree", "5"}, {"x", "6"}}));
  EXPECT_THAT(columns_, ElementsAre("name", "a,b"));
  EXPECT_THAT(lines_, ElementsAre(2, 4));
}

TEST_F(DataTables, MayEndTheirRowsWithASeparator) { EXPECT_EQ(rows_of("a;b\n1;2;\n"), (Rows{{"1", "2"}})); }

TEST_F(DataTables, MayHaveColumnsWithoutAName) { EXPECT_EQ(rows_of(",a\n0,5\n"), (Rows{{"0", "5"}})); }

TEST_F(DataTables, ReportAllBadRows) {
  EXPECT_EQ(refusal("a,b\n1\n1,2\n1,2,3\n"),
            "t.csv:2: the row has 1 value (the first line names 2 columns)\n"
            "t.csv:4: the row has 3 values (the first line names 2 columns). If its commas are decimal commas, write "
            "points, or separate the columns by semicolons");
}

TEST_F(DataTables, NeedNamesOfTheirColumns) {
  EXPECT_EQ(refusal(""), "t.csv: is empty (its first line must name the columns)");
  EXPECT_EQ(refusal("# nothing\n\n"), "t.csv: is empty (its first line must name the columns)");
  EXPECT_EQ(refusal("1,2\n3,4\n"),
            "t.csv:1: names no columns (its first line has only numbers). Write the names of the columns in a first "
            "line");
  EXPECT_EQ(refusal("a,x_m,Mass (kg),X [m]\n"),
            "t.csv:1: column 4 is named \"X [m]\", as column 2 is (it is not clear which one to read). Rename one of "
            "them");
}

TEST_F(DataTables, RefuseWhatIsNoTable) {
  EXPECT_EQ(refusal("a\n\"1\n2\n"), "t.csv:2: a quoted value has no end (the file ends inside it)");
  EXPECT_EQ(refusal("a\n" + std::string(2'000'000, '1') + "\n"),
            "t.csv:2: a row has more than 1048576 bytes (no row of a table is that long)");
  EXPECT_EQ(refusal_of([&] { DataTable(path("none.csv")); }),
            "none.csv: cannot be read (No such file or directory). Paths are relative to the project file");
  EXPECT_EQ(refusal_of([&] { DataTable(path(".")); }), ".: cannot be read (it is a folder). Name a file");
  ASSERT_EQ(::mkfifo(path("pipe.csv").c_str(), 0600), 0);
  EXPECT_EQ(refusal_of([&] { DataTable(path("pipe.csv")); }), "pipe.csv: cannot be read (it is a pipe). Name a file");
}

TEST(NumberInCell, IsAWholeText) {
  EXPECT_EQ(number_in_cell("12.5", false), 12.5);
  EXPECT_EQ(number_in_cell("+3e-2", false), 0.03);
  EXPECT_EQ(number_in_cell("12,5", true), 12.5);
  EXPECT_EQ(number_in_cell("12,5", false), std::nullopt);
  EXPECT_EQ(number_in_cell("1.5 m", false), std::nullopt);
  EXPECT_EQ(number_in_cell("", false), std::nullopt);
  EXPECT_TRUE(std::isnan(number_in_cell("nan", false).value()));
}

TEST(PlainColumnName, IsInTheFormOfTheTablesOfARun) {
  EXPECT_EQ(plain_column_name("vx_m_s"), "vx_m_s");
  EXPECT_EQ(plain_column_name(" Mass (kg)"), "mass_kg");
  EXPECT_EQ(plain_column_name("vx [m/s]"), "vx_m_s");
  EXPECT_EQ(plain_column_name("vx_mps"), "vx_m_s");
  EXPECT_EQ(plain_column_name("Volume (m\xC2\xB3)"), "volume_m3");
}

}  // namespace
}  // namespace talus
