// Results over the wire are those of the files.

#include "server/served_runs.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/run_files.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/files/csv_reader.hpp"

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;
using Texts = std::vector<std::string>;

/// 75 rocks of two sources in 3D, with a fence and a collector, maps and a design (run_files.hpp).
class Results : public ServedRuns {
 protected:
  Results() {
    const test::Workplace work;
    text_ = text_of(test::write_slope_with_barrier(work));
    id_ = begin(text_);
    EXPECT_EQ(wait_for(id_, "done")["state"], "done");
    folder_ = folder_of(id_);
  }
  [[nodiscard]] Reply of(const std::string& what) const { return get("/api/runs/" + id_ + what); }
  [[nodiscard]] std::vector<Texts> rows_of(const char* name, std::span<const std::string_view> columns) const {
    std::vector<Texts> rows;
    CsvReader row(folder_ / name, columns);
    while (row.next()) {
      Texts& texts = rows.emplace_back();
      for (std::size_t k = 0; k < columns.size(); ++k) texts.emplace_back(row.text(k));
    }
    return rows;
  }
  [[nodiscard]] std::vector<Texts> endpoints() const { return rows_of("endpoints.csv", endpoint_columns); }
  [[nodiscard]] std::vector<Texts> hits() const { return rows_of("barriers.csv", barrier_columns); }

  std::string text_, id_;
  std::filesystem::path folder_;
};

TEST_F(Results, AreTheFilesOfTheRun) {
  const Json files = of("/files").json()["files"];
  std::map<std::string, std::uint64_t> listed;
  for (const Json& file : files) listed[file["name"]] = file["bytes"];
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    const std::string name = entry.path().lexically_relative(folder_).generic_string();
    if (!entry.is_regular_file() || name == "run.json") continue;
    ASSERT_TRUE(listed.contains(name)) << name;
    EXPECT_EQ(listed[name], entry.file_size());
    const Reply reply = of("/files/" + name);
    EXPECT_EQ(reply.status, 200) << name;
    EXPECT_EQ(reply.body, test::bytes_of(entry.path())) << name;
    const auto disposition = reply.headers.find("Content-Disposition");
    ASSERT_NE(disposition, reply.headers.end());
    EXPECT_EQ(disposition->second, "attachment; filename*=UTF-8''" + entry.path().filename().string());
    listed.erase(name);
  }
  EXPECT_TRUE(listed.empty()) << listed.begin()->first;
}

/// Numbers of a histogram and its edges.
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

TEST_F(Results, OfTwoRunsAreCountedInTheSameBins) {
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
    // All else is as of each alone.
    Json alone = of(std::string("/statistics?of=") + quantity).json(), beside = runs[0];
    alone.erase("histogram");
    beside.erase("histogram");
    EXPECT_EQ(beside, alone);
  }
  // A filter may name what only one of them has; hits are of barriers by their names.
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

TEST_F(Results, HaveNoFilesBesideThose) {
  std::filesystem::create_symlink("/etc/passwd", folder_ / "link.csv");
  for (const char* name : {"run.json", "../../../slope.toml", "%2e%2e/%2e%2e/slope.toml", "maps", "maps/",
                           "nothing.csv", "link.csv", "/etc/passwd", "%2fetc%2fpasswd", ".", "maps/../summary.json"})
    EXPECT_EQ(of(std::string("/files/") + name).status, 404) << name;
  for (const char* name : {"nothing", "../endpoints", "passages.tif", "by_source/x/passages", "%2e%2e/passages"})
    EXPECT_EQ(of(std::string("/maps/") + name).status, 404) << name;
}

TEST_F(Results, AreOrdinaryFilesOfTheirFolder) {
  const std::filesystem::path summary = folder_ / "summary.json", elsewhere = base_ / "elsewhere.json";
  const auto expect_none = [&] {
    for (const char* what : {"/summary", "/paths", "/endpoints", "/statistics?of=x_m", "/barriers", "/maps"})
      EXPECT_EQ(of(what).problem(), id_ + ": this run has no results (its summary.json is not an ordinary file)")
          << what;
    EXPECT_EQ(run(id_)["has_results"], false);
  };
  std::filesystem::rename(summary, elsewhere);
  std::filesystem::create_symlink(elsewhere, summary);
  expect_none();
  std::filesystem::remove(summary);
  ASSERT_EQ(mkfifo(summary.c_str(), 0600), 0);
  expect_none();
  std::filesystem::remove(summary);
  std::filesystem::rename(elsewhere, summary);
  EXPECT_EQ(of("/summary").status, 200);
}

TEST_F(Results, OfEveryPathAreItsPointsWithTheRowsAmongThem) {
  const ArraysOf paths(of("/paths"));
  const auto rocks = paths.get<std::uint32_t>("rocks", "u32"), starts = paths.get<std::uint32_t>("starts", "u32");
  const auto times = paths.get<float>("times", "f32"), positions = paths.get<float>("positions", "f32");
  const auto speeds = paths.get<float>("speeds", "f32"), energies = paths.get<float>("energies", "f32");
  const auto heights = paths.get<float>("heights", "f32"), max_heights = paths.get<float>("max_heights", "f32");
  const auto states = paths.get<std::uint8_t>("states", "u8");
  ASSERT_EQ(rocks.size(), 75U);
  ASSERT_EQ(starts.size(), 76U);
  EXPECT_EQ(starts.front(), 0U);
  EXPECT_EQ(starts.back(), times.size());
  EXPECT_EQ(positions.size(), 3 * times.size());
  for (const std::size_t size : {speeds.size(), energies.size(), heights.size(), states.size()})
    EXPECT_EQ(size, times.size());
  EXPECT_EQ(paths.header["total"], 75);
  EXPECT_EQ(paths.header["states"][4], "barrier");

  PathReader reader(folder_ / "paths.csv");
  std::size_t rock = 0, rows = 0;
  float greatest_difference = 0;
  for (; reader.next([](std::uint64_t) { return true; }); ++rock) {
    ASSERT_EQ(reader.path().rock, rocks[rock]);
    std::size_t k = starts[rock];
    float highest = 0;
    for (const PathEventRow& row : reader.path().rows) {
      while (k < starts[rock + 1] &&
             (times[k] != static_cast<float>(row.time_s) || states[k] != static_cast<std::uint8_t>(row.state)))
        highest = std::max(highest, heights[k++]);
      ASSERT_LT(k, starts[rock + 1]) << "a row of rock " << rock << " at " << row.time_s << " s is missing";
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(positions[3 * k + axis] + paths.header["origin"][axis].get<double>(), row.position_m[axis], 1e-4);
      EXPECT_EQ(energies[k], static_cast<float>((row.ke_translational_J + row.ke_rotational_J) / 1000));
      if (row.state == PathState::impact) {
        EXPECT_LT(heights[k], 1e-3F) << "it strikes the ground";
      }
      highest = std::max(highest, heights[k++]);
      ++rows;
    }
    EXPECT_EQ(k, starts[rock + 1]);
    EXPECT_LE(highest, max_heights[rock] + 1e-3F);
    greatest_difference = std::max(greatest_difference, max_heights[rock] - highest);
  }
  EXPECT_EQ(rock, 75U);
  // Between two points of an arc the ground may fall away; here it is as steep as four to one.
  EXPECT_LT(greatest_difference, 1.5F);
  EXPECT_GT(times.size(), 2 * rows) << "flights have no points between";
}

TEST_F(Results, OfEveryRockAreThoseOfItsTables) {
  for (const char* what : {"/paths", "/endpoints"}) {
    const ArraysOf arrays(of(what));
    const Json& header = arrays.header;
    const auto sources = arrays.get<std::uint16_t>("sources", "u16"),
               seeders = arrays.get<std::uint16_t>("seeders", "u16");
    const auto reasons = arrays.get<std::uint8_t>("reasons", "u8");
    const auto masses = arrays.get<float>("masses", "f32"), energies = arrays.get<float>("max_energies", "f32");
    const auto radii = arrays.get<float>("radii", "f32");
    const auto barriers = arrays.get<std::uint32_t>("barriers", "u32");
    const std::vector<Texts> rows = endpoints(), all_hits = hits();
    ASSERT_EQ(rows.size(), masses.size());
    EXPECT_EQ(header["barriers"][0], "Fence");
    std::uint32_t seen = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      EXPECT_EQ(header["seeders"][seeders[k]], rows[k][1]);
      EXPECT_EQ(header["sources"][sources[k]], rows[k][1]) << "a seeder without another source is its own";
      EXPECT_EQ(header["reasons"][reasons[k]], rows[k][10]);
      EXPECT_EQ(masses[k], static_cast<float>(std::stod(rows[k][11])));
      EXPECT_EQ(radii[k], static_cast<float>(std::stod(rows[k][12])));
      EXPECT_EQ(energies[k], static_cast<float>(std::stod(rows[k][13]) / 1000));
      std::uint32_t expected = 0;
      for (const Texts& hit : all_hits)
        if (hit[1] == rows[k][0]) expected |= hit[0] == header["barriers"][0] ? 1U : 2U;
      EXPECT_EQ(barriers[k], expected) << k;
      seen |= expected;
    }
    EXPECT_EQ(seen, 3U) << "a barrier that no rock hits shows nothing";
  }
}

TEST_F(Results, KnowWhichOfManyBarriersARockHit) {
  std::string text = section();
  for (int k = 1; k < 70; ++k)
    text += fmt::format("\n[[collector]]\nname = \"C{}\"\nline = {}\nheight_m = 9\n", k, 10 + 0.1 * k);
  id_ = begin(text);
  ASSERT_EQ(wait_for(id_, "done")["state"], "done");
  folder_ = folder_of(id_);
  const ArraysOf arrays(of("/endpoints"));
  const auto rocks = arrays.get<std::uint32_t>("rocks", "u32"), barriers = arrays.get<std::uint32_t>("barriers", "u32");
  constexpr std::size_t words = 3;
  ASSERT_EQ(barriers.size(), words * rocks.size());
  const auto names = arrays.header["barriers"].get<Texts>();
  std::vector<std::uint32_t> expected(barriers.size());
  for (const Texts& hit : hits()) {
    const auto number = static_cast<std::size_t>(std::ranges::find(names, hit[0]) - names.begin());
    expected[words * std::stoull(hit[1]) + number / 32] |= 1U << number % 32;
  }
  EXPECT_EQ(barriers, expected);
  std::uint32_t seen = 0;
  for (std::size_t k = words - 1; k < barriers.size(); k += words) seen |= barriers[k];
  EXPECT_NE(seen, 0U) << "no rock hits one beyond the 64th";
}

TEST_F(Results, OfTheEndsAreWhereTheyEnd) {
  const ArraysOf ends(of("/endpoints"));
  const auto positions = ends.get<float>("positions", "f32");
  const std::vector<Texts> rows = endpoints();
  ASSERT_EQ(positions.size(), 3 * rows.size());
  for (std::size_t k = 0; k < positions.size(); ++k)
    EXPECT_NEAR(positions[k] + ends.header["origin"][k % 3].get<double>(), std::stod(rows[k / 3][2 + k % 3]), 1e-4);
  const ArraysOf ten(of("/endpoints?rocks=10"));
  EXPECT_EQ(ten.get<std::uint32_t>("rocks", "u32").size(), 10U);
  EXPECT_EQ(ten.header["total"], 75);
  EXPECT_EQ(ArraysOf(of("/paths?rocks=7")).get<std::uint32_t>("starts", "u32").size(), 8U);
  EXPECT_EQ(ArraysOf(of("/paths?rocks=0")).get<std::uint32_t>("starts", "u32").size(), 1U);
  EXPECT_EQ(of("/paths?rocks=-1").status, 400);
}

TEST_F(Results, OfOneRockAreItsRowsAsTheyStand) {
  const std::vector<Texts> ends = endpoints(), all_hits = hits();
  std::map<std::string, std::vector<Texts>> paths;
  for (const Texts& row : rows_of("paths.csv", path_columns)) paths[row[0]].push_back(row);
  for (const Texts& end : ends) {
    const Json rock = of("/rocks/" + end[0]).json();
    EXPECT_EQ(rock["in_table"], true);
    EXPECT_EQ(rock["columns"], Json(path_columns));
    EXPECT_EQ(rock["rows"], Json(paths[end[0]]));
    ASSERT_EQ(rock["endpoint"].size(), end.size());
    for (std::size_t k = 0; k < end.size(); ++k) EXPECT_EQ(rock["endpoint"][std::string(endpoint_columns[k])], end[k]);
    std::size_t count = 0;
    for (const Texts& hit : all_hits) count += hit[1] == end[0] ? 1 : 0;
    EXPECT_EQ(rock["hits"].size(), count);
    EXPECT_EQ(rock["energy"].front()[1], std::stod(paths[end[0]].front()[13]));
    EXPECT_EQ(rock["energy"].back()[3], std::stod(paths[end[0]].back()[15]));
  }
  EXPECT_EQ(of("/rocks/75").status, 404);
  EXPECT_EQ(of("/rocks/9999999999999999999").status, 404);
  EXPECT_EQ(of("/rocks/-1").status, 404);
}

TEST_F(Results, OfARockWithoutAPathInTheTableAreComputedAgain) {
  const std::string few = begin(text_ + "\n[output]\npaths = 5\n");
  ASSERT_EQ(wait_for(few, "done")["state"], "done");
  int again = 0;
  for (int rock = 0; rock < 75; ++rock) {
    const Json here = of("/rocks/" + std::to_string(rock)).json();
    const Json there = get("/api/runs/" + few + "/rocks/" + std::to_string(rock)).json();
    again += there["in_table"] == false ? 1 : 0;
    EXPECT_EQ(there["rows"], here["rows"]) << rock;
    EXPECT_EQ(there["energy"], here["energy"]) << rock;
    EXPECT_EQ(there["endpoint"], here["endpoint"]) << rock;
  }
  EXPECT_EQ(again, 70);
}

TEST_F(Results, OfASampleOfEndPointsSayThatTheyAre) {
  const std::string few = begin(text_ + "\n[output]\nendpoints = 30\npaths = 5\n");
  ASSERT_EQ(wait_for(few, "done")["state"], "done");
  const auto of_few = [&](const std::string& what) { return get("/api/runs/" + few + what); };
  const ArraysOf ends(of_few("/endpoints"));
  EXPECT_EQ(ends.header["total"], 30);
  const auto rocks = ends.get<std::uint32_t>("rocks", "u32");
  EXPECT_EQ(rocks.size(), 30U);
  for (const std::uint32_t rock : ArraysOf(of_few("/paths")).get<std::uint32_t>("rocks", "u32"))
    EXPECT_TRUE(std::ranges::binary_search(rocks, rock)) << rock;
  for (int rock = 0; rock < 75; ++rock) {
    const std::string which = "/rocks/" + std::to_string(rock);
    EXPECT_EQ(of_few(which).json()["endpoint"], of(which).json()["endpoint"]) << rock;
  }
  EXPECT_EQ(of_few("/rocks/75").status, 404);

  const Json found = of_few("/statistics?of=x_m").json();
  EXPECT_EQ(found["count"], 30);
  EXPECT_EQ(found["sample"], (Json{{"rocks", 30}, {"of", 75}}));
  EXPECT_EQ(of("/statistics?of=x_m").json()["sample"], Json());
  // All hits are there; those of some rocks only where it is known of these rocks how they ended.
  const std::string on_fence = "/barriers/0/statistics?of=time_s";
  EXPECT_EQ(of_few(on_fence).json()["sample"], Json());
  EXPECT_EQ(of_few(on_fence).json()["count"], of(on_fence).json()["count"]);
  EXPECT_EQ(of_few(on_fence + "&min_energy_kJ=0").json()["sample"], (Json{{"rocks", 30}, {"of", 75}}));
}

// Of another project the paths would be others: then nothing is said rather than something wrong.
TEST_F(Results, OfAChangedProjectAreNotComputedAgain) {
  const std::string few = begin(text_ + "\n[output]\npaths = 5\n");
  ASSERT_EQ(wait_for(few, "done")["state"], "done");
  const std::string file = run(few)["folder"].get<std::string>() + "/project.toml";
  const std::string text = read(file);
  write(file, std::string(text).replace(text.find("position = [5, 20"), 17, "position = [5, 21"));
  int refused = 0;
  for (int rock = 0; rock < 75; ++rock)
    refused += get("/api/runs/" + few + "/rocks/" + std::to_string(rock)).status == 404 ? 1 : 0;
  EXPECT_EQ(refused, 70);
  for (const float height : ArraysOf(get("/api/runs/" + few + "/paths")).get<float>("heights", "f32"))
    EXPECT_TRUE(std::isnan(height));
  write(file, text);
  EXPECT_EQ(get("/api/runs/" + few + "/rocks/1").status, 200);
}

TEST_F(Results, InStatisticsAreThoseOfTheSummary) {
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

TEST_F(Results, InStatisticsCanBeFiltered) {
  const std::vector<Texts> rows = endpoints();
  const auto count = [&](const char* filter) {
    return of(std::string("/statistics?of=x_m&") + filter).json()["count"];
  };
  EXPECT_EQ(count("seeder=Ledge"), 25);
  EXPECT_EQ(count("seeder=Ledge&seeder="
                  "Crest"),
            75);
  EXPECT_EQ(count("reason=at%20rest").get<std::size_t>(),
            static_cast<std::size_t>(
                std::count_if(rows.begin(), rows.end(), [](const Texts& row) { return row[10] == "at rest"; })));
  EXPECT_EQ(count("min_energy_kJ=100").get<std::size_t>(),
            static_cast<std::size_t>(
                std::count_if(rows.begin(), rows.end(), [](const Texts& row) { return std::stod(row[13]) >= 1e5; })));
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

TEST_F(Results, OfBarriersAreThoseOfTheSummary) {
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

#ifdef TALUS_HAS_GDAL
TEST_F(Results, OfMapsAreThoseOfTheFiles) {
  const Json maps = of("/maps").json()["maps"];
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "maps"))
    files += entry.path().extension() == ".tif" ? 1 : 0;
  EXPECT_EQ(maps.size(), files);
  EXPECT_EQ(maps[0]["name"], "passages");
  EXPECT_TRUE(maps[0]["source"].is_null());
  for (const Json& map : maps) {
    const ArraysOf values(of("/maps/" + map["name"].get<std::string>()));
    const auto cells = values.get<float>("values", "f32");
    EXPECT_EQ(cells.size(), values.header["columns"].get<std::size_t>() * values.header["rows"].get<std::size_t>());
    float most = 0;
    for (const float value : cells) most = std::isnan(value) ? most : std::max(most, value);
    EXPECT_EQ(most, map["most"].get<float>()) << map["name"];
    const Json& classes = values.header["classes"];
    EXPECT_EQ(classes, map["classes"]);
    EXPECT_EQ(classes[0]["from"], 0);
    for (std::size_t k = 1; k < classes.size(); ++k) EXPECT_EQ(classes[k]["from"], classes[k - 1]["to"]);
    EXPECT_TRUE(classes.back()["to"].is_null());
  }
  // Every rock that came to rest lies in a cell of the map.
  const ArraysOf deposits(of("/maps/deposits"));
  const auto cells = deposits.get<float>("values", "f32");
  const Json& header = deposits.header;
  for (const Texts& row : endpoints()) {
    if (row[10] != "at rest") continue;
    const auto column = static_cast<std::size_t>((std::stod(row[2]) - header["origin"][0].get<double>()) /
                                                 header["cell"][0].get<double>());
    const auto line = static_cast<std::size_t>((std::stod(row[3]) - header["origin"][1].get<double>()) /
                                               header["cell"][1].get<double>());
    EXPECT_GE(cells[line * header["columns"].get<std::size_t>() + column], 1) << row[0];
  }
}
#endif

}  // namespace
}  // namespace talus
