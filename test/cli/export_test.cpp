// The store of trajectories of whole runs: its rocks, paths.csv made from it, the reader in Python of its page.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/places.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/files/csv_table.hpp"
#include "talus/store/ground_parts.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;

/// Runs the slope with a barrier, with all paths, into `name`.
void run_slope(const Workplace& work, const std::string& name, const std::string& settings = "") {
  const Said said = talus_says("run " + write_slope_with_barrier(work) + " --rocks 300 --set output.paths=all" +
                               " --set output.report=false -o " + (work / name).string() + " " + settings);
  ASSERT_EQ(said.exit_code, 0) << said.text;
}

std::vector<PathEventRow> rows_of(const fs::path& table) {
  std::vector<PathEventRow> rows;
  TableReader<PathEventRow> row(table);
  while (row.next()) rows.push_back(row.whole());
  return rows;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return (vector(a) - vector(b)).norm();
}

TEST(Export, MakesThePathsOfTheRun) {
  const Workplace work;
  for (const std::string& settings : {std::string(), std::string("--set analysis.model=rigid_sphere")}) {
    run_slope(work, "out", settings);
    const Said said = talus_says("export " + (work / "out").string() + " -o " + (work / "paths.csv").string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
    EXPECT_EQ(said.text, (work / "paths.csv").string() + "\n");
    const auto were = rows_of(work / "out/paths.csv"), are = rows_of(work / "paths.csv");
    ASSERT_EQ(are.size(), were.size());
    std::size_t exact = 0;
    for (std::size_t k = 0; k < are.size(); ++k) {
      const PathEventRow &is = are[k], &was = were[k];
      EXPECT_EQ(std::tie(is.rock, is.event, is.state), std::tie(was.rock, was.event, was.state));
      const bool is_exact = is.time_s == was.time_s && is.position_m == was.position_m &&
                            is.velocity_m_s == was.velocity_m_s && is.spin_rad_s == was.spin_rad_s;
      exact += is_exact ? 1 : 0;
      const bool flies = was.state == PathState::projectile || was.state == PathState::ended;
      EXPECT_TRUE(is_exact || !flies) << "rock " << is.rock << ", event " << is.event;
      EXPECT_NEAR(is.time_s, was.time_s, StoreStep::time);
      EXPECT_LE(distance(is.position_m, was.position_m), StoreStep::place);
      EXPECT_LE(distance(is.velocity_m_s, was.velocity_m_s), StoreStep::velocity);
      EXPECT_LE(distance(is.spin_rad_s, was.spin_rad_s), 10 * StoreStep::velocity) << "radii are over 0.1 m";
      // E ~ v^2, and the spin of a rolling rock follows its velocity.
      const double by_step = is_exact ? 0 : 4 * StoreStep::velocity / vector(was.velocity_m_s).norm();
      EXPECT_NEAR(is.total_J(), was.total_J(), (1e-9 + by_step) * (1 + std::abs(was.total_J())));
    }
    EXPECT_GT(4 * exact, 3 * are.size());
  }
}

TEST(Export, MakesTheSameRowsForASample) {
  const Workplace work;
  run_slope(work, "out");
  const Said all = talus_says("export " + (work / "out").string());
  const Said some = talus_says("export " + (work / "out").string() + " --paths 20");
  EXPECT_EQ(some.exit_code, 0);
  std::istringstream lines(some.text);
  std::size_t ended = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_NE(all.text.find(line + "\n"), std::string::npos);
    ended += line.find(",ended,") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(ended, 20U);
}

TEST(Export, RefusesWhatItCannotDo) {
  const Workplace work;
  run_slope(work, "out", "--set output.trajectories_MB=none");
  const std::string folder = (work / "out").string();
  EXPECT_EQ(talus_says("export " + folder).text, folder +
                                                     "/trajectories.bin: cannot use this store of trajectories (No "
                                                     "such file or directory). Run the project again to write it "
                                                     "anew\n");
  const Said said = talus_says("export " + folder + " --paths some");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, "--paths: \"some\" is not a number of rocks (expected \"all\" or a whole number)\n");
  EXPECT_EQ(talus_says("export " + folder + " -o " + folder + "/paths.csv").text,
            folder + "/paths.csv: cannot write the table here (this file is a result of a run). Choose another name\n");
  (void)work.write("notes.csv", "mine\n");
  EXPECT_EQ(talus_says("export " + folder + " -o " + (work / "notes.csv").string()).text,
            (work / "notes.csv").string() +
                ": this file already exists (it is not a table of paths written by this command, and only those are "
                "replaced). Choose another name\n");
}

TEST(Store, SaysWhichShareItHas) {
  const Workplace work;
  const Said said = talus_says("run " + std::string(tutorial("2d")) +
                               " --rocks 20000 --set output.trajectories_MB=1 --set output.report=false -o " +
                               (work / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  const auto summary = nlohmann::json::parse(std::ifstream(work / "out/summary.json"));
  const auto& stored = summary.at("trajectories");
  const auto size = fs::file_size(work / "out/trajectories.bin");
  EXPECT_EQ(stored.at("bytes"), size);
  EXPECT_LT(size, 1'010'000U);
  EXPECT_GT(size, 950'000U);
  EXPECT_LT(stored.at("rocks"), 20'000);
  EXPECT_DOUBLE_EQ(stored.at("share").get<double>(), stored.at("rocks").get<double>() / 20'000);
  EXPECT_LT(size, 40 * stored.at("rows").get<std::uint64_t>());
  const std::string text = fmt::format(
      "  trajectories of {} rocks are stored, {:.3g} % of all: a fair sample; more with "
      "output.trajectories\n",
      stored.at("rocks").get<int>(), 100 * stored.at("share").get<double>());
  EXPECT_NE(said.text.find(text), std::string::npos) << said.text;
}

TEST(Store, HasASampleUnlessMoreIsWanted) {
  const Workplace work;
  const auto stored_by = [&](const std::string& settings) {
    const Said said = talus_says("run " + std::string(tutorial("2d")) + " --rocks 12000 --set output.report=false " +
                                 settings + " -o " + (work / "out").string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
    return nlohmann::json::parse(std::ifstream(work / "out/summary.json")).at("trajectories").at("rocks").get<int>();
  };
  EXPECT_EQ(stored_by(""), 10'000);
  EXPECT_EQ(stored_by("--set output.trajectories=1234"), 1234);
  EXPECT_EQ(stored_by("--set output.trajectories=all"), 12'000);
  EXPECT_EQ(stored_by("--set output.trajectories_MB=16"), 12'000);
  EXPECT_LT(stored_by("--set output.trajectories=5000 --set output.trajectories_MB=1"), 5000);
}

TEST(Store, IsNotWrittenIfNoneIsWanted) {
  const Workplace work;
  run_slope(work, "out");
  EXPECT_TRUE(fs::exists(work / "out/trajectories.bin"));
  run_slope(work, "out", "--set output.trajectories_MB=0");
  EXPECT_FALSE(fs::exists(work / "out/trajectories.bin"));
}

TEST(Store, AllDivisionsOfTheRocksGiveItsBytes) {
  const Workplace work;
  const std::string project = write_slope_with_barrier(work);
  const std::string options =
      " --rocks 6000 --set output.trajectories_MB=1 --set output.report=false --set output.maps=false -o ";
  ASSERT_EQ(talus_says("run " + project + options + (work / "whole").string() + " --threads 1").exit_code, 0);
  const std::string whole = bytes_of(work / "whole/trajectories.bin");
  for (const char* shard : {"2/3", "1/3", "3/3"}) {
    const std::string name = std::string("shards/") + shard[0];
    ASSERT_EQ(talus_says("run " + project + options + (work / name).string() + " --shard " + shard).exit_code, 0);
    EXPECT_FALSE(fs::exists(work / name / "trajectories.bin"));
  }
  ASSERT_EQ(talus_says("merge " + (work / "shards").string() + " -o " + (work / "merged").string()).exit_code, 0);
  EXPECT_TRUE(bytes_of(work / "merged/trajectories.bin") == whole);
}

TEST(Store, IsReadByTheExample) {
  const Workplace work;
  for (const char* settings : {"", "--set analysis.model=rigid_sphere",
                               "--set material.0.forest_drag_kg_s=300 --set material.0.forest_height_m=5"}) {
    run_slope(work, "out", settings);
    ASSERT_EQ(talus_says("export " + (work / "out").string() + " -o " + (work / "paths.csv").string()).exit_code, 0);
    (void)work.write("read.py", bytes_of(talus::places::in_source("/examples/trajectories/read_trajectories.py")) + R"(
import csv, sys

store = Store(sys.argv[1])
rows = csv.DictReader(open(sys.argv[2]))
count = 0
for place in range(len(store.rocks)):
    rock = store.read(place)
    for state, (p, v, w, t) in rock["rows"]:
        row = next(rows)
        p = [x + o for x, o in zip(p, store.origin)]
        numbers = [t, *p, *v, *w]
        names = "time_s x_m y_m z_m vx_m_s vy_m_s vz_m_s wx_rad_s wy_rad_s wz_rad_s".split()
        assert int(row["rock"]) == rock["rock"] and row["state"] == state
        for name, number in zip(names, numbers):
            assert abs(float(row[name]) - number) <= 1e-12 * (1 + abs(number)), (name, row[name], number)
        count += 1
    x, y = (rock["end"][0][k] + store.origin[k] for k in (0, 1))
    assert place in store.rocks_in(x, y) and len(rock["pieces"]) > 0
assert next(rows, None) is None and count == store.row_count
print(len(store.rocks), "rocks as exported")
)");
    const Said said = says("python3 " + (work / "read.py").string() + " " + (work / "out/trajectories.bin").string() +
                           " " + (work / "paths.csv").string());
    EXPECT_EQ(said.text, "300 rocks as exported\n") << settings;
  }
}

}  // namespace
}  // namespace talus::test
