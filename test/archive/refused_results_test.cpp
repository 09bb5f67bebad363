// Hostile results of a run that would exhaust memory or the stack.

#include <gtest/gtest.h>

#include "support/sample_run.hpp"
#include "talus/archive/run_description.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/core/bytes.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/csv_reader.hpp"
#include "talus/files/json_text.hpp"

namespace talus {
namespace {

using sample_run::Folder;

constexpr const char* cut_short = ". The file was cut short or damaged; run the project again to write it anew";

std::string refusal(const Folder& folder) {
  try {
    (void)read_run_folder(folder.path);
  } catch (const BadInput& bad) {
    return std::string(bad.what()).substr(folder.path.string().size() + 1);
  }
  return "was read";
}

TEST(RefusedResults, ARowOfAMegabyte) {
  const Folder folder("refused");
  folder.write("summary.json", sample_run::summary("Refused").dump());
  folder.write("endpoints.csv", sample_run::endpoints_head + std::string(std::size_t{1} << 20, '1') + "\n");
  EXPECT_EQ(refusal(folder),
            "endpoints.csv:2: the row has 1 values (expected 18, one for each column)" + std::string(cut_short));
  folder.write("endpoints.csv", sample_run::endpoints_head + std::string((std::size_t{1} << 20) + 1, '1') + "\n");
  EXPECT_EQ(refusal(folder), "endpoints.csv:2: the row has more than 1048576 bytes (no row of a table is that long)" +
                                 std::string(cut_short));
}

TEST(RefusedResults, AQuoteThatStaysOpenForAMegabyte) {
  const Folder folder("refused");
  folder.write("summary.json", sample_run::summary("Refused").dump());
  // It must also be fast: every line is read once.
  folder.write("endpoints.csv", sample_run::endpoints_head + '"' + std::string(std::size_t{4} << 20, '\n'));
  EXPECT_EQ(refusal(folder), "endpoints.csv:2: the row has more than 1048576 bytes (no row of a table is that long)" +
                                 std::string(cut_short));
}

TEST(RefusedResults, ASummaryOfNestedLists) {
  const Folder folder("refused");
  const std::size_t deep = 1'000'000;
  folder.write("summary.json", "{\"project\": " + std::string(deep, '[') + std::string(deep, ']') + "}");
  EXPECT_EQ(refusal(folder),
            "summary.json: is damaged (its lists are nested 1000001 deep; expected at most 100). Name a folder that "
            "`talus run` has written");
}

TEST(RefusedResults, ANumberTooLargeForADouble) {
  const Folder folder("refused");
  folder.write("summary.json", "{\"rocks\": {\"done\": 1e999}}");
  EXPECT_EQ(refusal(folder), "summary.json: has a number that is too large (expected numbers that 64 bits can hold)" +
                                 std::string(cut_short));
}

TEST(RefusedResults, AStatisticWhoseNameIsNotAJsonPointer) {
  const Folder folder("refused");
  auto summary = sample_run::summary("Refused");
  summary["statistics"]["a~b/c"] = 1;
  folder.write("summary.json", summary.dump());
  EXPECT_EQ(refusal(folder),
            "summary.json: statistics/a~b/c: is of type number (expected an object). Name a folder that "
            "`talus run` has written");
}

TEST(RefusedResults, ASummaryOfManyGigabytes) {
  const Folder folder("refused");
  folder.write("summary.json", "{}");
  std::filesystem::resize_file(folder.path / "summary.json", std::uintmax_t{1} << 34);  // sparse on disk
  EXPECT_EQ(
      refusal(folder),
      "summary.json: cannot be read (it has 16384 MiB; expected at most 1024). Name a folder that `talus run` has "
      "written");
}

TEST(RefusedResults, ADescriptionOfNestedLists) {
  const std::string json = "{\"name\":" + std::string(100'000, '[') + std::string(100'000, ']') + "}";
  EXPECT_THROW((void)description_from(json), BadBytes);
}

TEST(DepthOfJson, IgnoresBracketsInStrings) {
  EXPECT_EQ(depth_of_json(""), 0U);
  EXPECT_EQ(depth_of_json("1"), 0U);
  EXPECT_EQ(depth_of_json("[[], {}]"), 2U);
  EXPECT_EQ(depth_of_json(R"({"a": [{"b]": "[[[\"[["}]})"), 3U);
  EXPECT_EQ(depth_of_json("]]]["), 1U);
}

}  // namespace
}  // namespace talus
