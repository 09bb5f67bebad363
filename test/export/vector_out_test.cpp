// results.gpkg, read back with OGR as QGIS does.

#include "talus/export/vector_out.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/file_size_limit.hpp"
#include "support/run_columns.hpp"
#include "support/sample_run_3d.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/core/problems.hpp"
#include "talus/export/derived_files.hpp"

#ifdef TALUS_HAS_GDAL
#include <ogrsf_frmts.h>

#include "talus/gdal/gdal_raster.hpp"
#endif

namespace talus {
namespace {

using sample_run::endpoint_row;
using sample_run::endpoints_head;
using sample_run::path_rows;
using sample_run::paths_head;
using sample_run::summary_3d;
using sample_run::write_3d;
using Json = nlohmann::ordered_json;

std::string message(const std::filesystem::path& folder) {
  try {
    write_geopackage(read_run_facts(folder), folder);
  } catch (const BadInput& bad) {
    return std::string(bad.what()).substr(folder.string().size() + 1);
  }
  return "was written";
}

#ifdef TALUS_HAS_GDAL

using testing::ElementsAre;

struct Opened {
  explicit Opened(const std::filesystem::path& file) {
    const GdalMessages gdal{GdalFiles(file)};
    dataset.reset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR));
    EXPECT_TRUE(dataset);
  }
  OGRLayer& layer(const char* name) const {
    OGRLayer* found = dataset->GetLayerByName(name);
    if (found == nullptr) throw std::runtime_error(std::string("no layer ") + name);
    return *found;
  }
  GDALDatasetUniquePtr dataset;
};

std::vector<std::int64_t> rocks_of(OGRLayer& layer) {
  std::vector<std::int64_t> rocks;
  for (const auto& feature : layer) rocks.push_back(feature->GetFieldAsInteger64("rock"));
  return rocks;
}

std::string utm_33() {
  OGRSpatialReference crs;
  crs.importFromEPSG(32633);
  char* wkt = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  crs.exportToWkt(&wkt, options);
  std::string out = wkt;
  CPLFree(wkt);
  return out;
}

TEST(GeoPackage, HasFourLayersInTheTerrainsCoordinateSystem) {
  const sample_run::Folder folder("gpkg");
  Json summary = summary_3d();
  summary["terrain"]["crs_wkt"] = utm_33();
  write_3d(folder, summary);
  EXPECT_EQ(message(folder.path), "was written");
  EXPECT_FALSE(std::filesystem::exists(folder.path / "results.gpkg.part"));
  const Opened file(folder.path / "results.gpkg");
  EXPECT_EQ(file.dataset->GetLayerCount(), 4);
  for (const char* name : {"barriers", "endpoints", "paths", "releases"}) {
    OGRLayer& layer = file.layer(name);
    ASSERT_NE(layer.GetSpatialRef(), nullptr);
    EXPECT_STREQ(layer.GetSpatialRef()->GetAuthorityCode(nullptr), "32633");
    EXPECT_EQ(layer.GetGeomType(), std::string_view(name) == "barriers" || std::string_view(name) == "paths"
                                       ? wkbLineString25D
                                       : wkbPoint25D);
    EXPECT_TRUE(layer.TestCapability(OLCFastSpatialFilter)) << name;  // it has a spatial index
  }
}

TEST(GeoPackage, HasTheSectionsOfADesign) {
  const sample_run::Folder folder("gpkg");
  Json summary = summary_3d();
  const auto section = [](double from, double to, std::uint64_t rocks) {
    Json percentiles = Json::object();
    for (const char* quantity : {"ke_translational_J", "ke_total_J", "velocity_m_s", "height_m"}) {
      percentiles[quantity] = rocks > 0 ? Json{{"97.5", {1.5, 1, nullptr}}} : Json::object();
    }
    return Json{{"from_m", from},
                {"to_m", to},
                {"rocks", rocks},
                {"share", {{"value", 0.25}, {"low", 0.125}, {"high", 0.5}}},
                {"percentiles", percentiles},
                {"needs", rocks > 0 ? Json{{"energy_J", 3e5}, {"class", 2}, {"height_m", 3.5}} : Json(nullptr)}};
  };
  summary["project"]["design"] = {{"percentiles", {97.5}}};
  summary["design"] = {{"lines", Json::array({{{"name", "Fence"},
                                               {"sections", Json::array({section(0, 30, 4), section(30, 50, 0)})}}})}};
  write_3d(folder, summary);
  EXPECT_EQ(message(folder.path), "was written");
  const Opened file(folder.path / "results.gpkg");
  EXPECT_EQ(file.dataset->GetLayerCount(), 5);
  OGRLayer& layer = file.layer("design");
  EXPECT_EQ(layer.GetFeatureCount(), 2);
  const OGRFeatureUniquePtr first(layer.GetNextFeature()), second(layer.GetNextFeature());
  EXPECT_STREQ(first->GetFieldAsString("line"), "Fence");
  EXPECT_EQ(first->GetFieldAsInteger64("section"), 1);
  EXPECT_EQ(first->GetFieldAsInteger64("rocks"), 4);
  EXPECT_EQ(first->GetFieldAsDouble("share"), 0.25);
  EXPECT_EQ(first->GetFieldAsDouble("ke_total_p97.5_J"), 1.5);
  EXPECT_EQ(first->GetFieldAsDouble("needs_energy_J"), 3e5);
  EXPECT_EQ(first->GetFieldAsDouble("needs_height_m"), 3.5);
  const OGRLineString* foot = first->GetGeometryRef()->toLineString();
  ASSERT_EQ(foot->getNumPoints(), 3);
  EXPECT_EQ(foot->getY(2), 30);
  EXPECT_TRUE(second->IsFieldNull(second->GetFieldIndex("needs_class")));
  EXPECT_TRUE(second->IsFieldNull(second->GetFieldIndex("height_p97.5_m")));
}

TEST(GeoPackage, HasAnUndefinedCartesianSystemByDefault) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  EXPECT_EQ(message(folder.path), "was written");
  const Opened file(folder.path / "results.gpkg");
  EXPECT_STREQ(file.layer("paths").GetSpatialRef()->GetName(), "Undefined Cartesian SRS");
}

TEST(GeoPackage, HasTheTableOfEndPoints) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  EXPECT_EQ(message(folder.path), "was written");
  const Opened file(folder.path / "results.gpkg");
  OGRLayer& layer = file.layer("endpoints");
  for (const std::string_view column : endpoint_columns) {
    EXPECT_GE(layer.GetLayerDefn()->GetFieldIndex(std::string(column).c_str()), 0) << column;
  }
  EXPECT_THAT(rocks_of(layer), ElementsAre(0, 1, 2, 3, 4, 5));
  layer.SetAttributeFilter("rock = 3");
  layer.ResetReading();
  const OGRFeatureUniquePtr third(layer.GetNextFeature());
  ASSERT_TRUE(third);
  EXPECT_STREQ(third->GetFieldAsString("seeder"), "seeder 1");
  EXPECT_STREQ(third->GetFieldAsString("source"), "Tower, \"old\"");
  EXPECT_STREQ(third->GetFieldAsString("end_reason"), "at rest");
  EXPECT_EQ(third->GetFieldAsInteger64("events"), 4);
  EXPECT_EQ(third->GetFieldAsDouble("max_ke_J"), 120000);
  EXPECT_EQ(third->GetFieldAsDouble("radius_m"), 0.4455);
  const OGRPoint* place = third->GetGeometryRef()->toPoint();
  EXPECT_EQ(place->getX(), 8);
  EXPECT_EQ(place->getY(), 0);
  EXPECT_EQ(place->getZ(), -12.2);
}

TEST(GeoPackage, HasPathsWithTheirArcsAndReleases) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  EXPECT_EQ(message(folder.path), "was written");
  const Opened file(folder.path / "results.gpkg");
  OGRLayer &paths = file.layer("paths"), &releases = file.layer("releases");
  EXPECT_THAT(rocks_of(paths), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(rocks_of(releases), ElementsAre(0, 1, 2, 3, 4, 5));
  paths.ResetReading();
  const OGRFeatureUniquePtr path(paths.GetNextFeature());
  EXPECT_STREQ(path->GetFieldAsString("seeder"), "seeder 1");
  EXPECT_STREQ(path->GetFieldAsString("source"), "Wall");
  EXPECT_STREQ(path->GetFieldAsString("end_reason"), "at rest");
  EXPECT_EQ(path->GetFieldAsDouble("max_ke_J"), 120000);
  EXPECT_EQ(path->GetFieldAsDouble("max_bounce_m"), 1.5);
  // A fall of 1.577 s: sqrt(9.81/(8 0.25)) 1.577 = 3.5, four pieces; then the slide. The two rows of the contact are
  // one point.
  const OGRLineString& line = *path->GetGeometryRef()->toLineString();
  ASSERT_EQ(line.getNumPoints(), 1 + 4 + 1);
  EXPECT_EQ(line.getX(0), 0.5);
  EXPECT_NEAR(line.getZ(2), -9.81 / 2 * 0.7885 * 0.7885, 0.01);
  EXPECT_EQ(line.getX(4), 3.1);
  EXPECT_EQ(line.getZ(5), -12.2);
  releases.ResetReading();
  const OGRFeatureUniquePtr release(releases.GetNextFeature());
  EXPECT_EQ(release->GetGeometryRef()->toPoint()->getX(), 0.5);
}

TEST(GeoPackage, HasBarriersWithTheirStatistics) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  EXPECT_EQ(message(folder.path), "was written");
  const Opened file(folder.path / "results.gpkg");
  OGRLayer& layer = file.layer("barriers");
  EXPECT_EQ(layer.GetFeatureCount(), 2);
  const OGRFeatureUniquePtr fence(layer.GetNextFeature()), track(layer.GetNextFeature());
  EXPECT_STREQ(fence->GetFieldAsString("name"), "Fence");
  EXPECT_STREQ(fence->GetFieldAsString("kind"), "barrier");
  const std::pair<const char*, double> expected[] = {{"height_m", 3},
                                                     {"inclination_deg", -10},
                                                     {"capacity_kJ", 500},
                                                     {"hits", 3},
                                                     {"rocks_hit", 2},
                                                     {"passed_above", 1},
                                                     {"stopped", 2},
                                                     {"rebounded", 1},
                                                     {"broke_through", 0},
                                                     {"passed", 0},
                                                     {"least_clearance_m", 0.25},
                                                     {"ke_total_p95_J", 9.6e4},
                                                     {"ke_total_p99_J", 9.95e4},
                                                     {"ke_total_max_J", 1.1e5},
                                                     {"ke_translational_p95_J", 9.5e4},
                                                     {"ke_translational_p99_J", 9.9e4},
                                                     {"ke_translational_max_J", 1e5},
                                                     {"impact_height_p95_m", 1.5},
                                                     {"impact_height_p99_m", 2.5},
                                                     {"impact_height_max_m", 3},
                                                     {"velocity_p95_m_s", 15},
                                                     {"velocity_p99_m_s", 16},
                                                     {"velocity_max_m_s", 17}};
  for (const auto& [name, value] : expected) EXPECT_EQ(fence->GetFieldAsDouble(name), value) << name;
  EXPECT_EQ(layer.GetLayerDefn()->GetFieldCount(), 2 + static_cast<int>(std::size(expected)));
  const OGRLineString& foot = *fence->GetGeometryRef()->toLineString();
  ASSERT_EQ(foot.getNumPoints(), 3);
  EXPECT_EQ(foot.getZ(1), 5.5);
  EXPECT_FALSE(track->IsFieldSetAndNotNull(track->GetFieldIndex("capacity_kJ")));
  EXPECT_FALSE(track->IsFieldSetAndNotNull(track->GetFieldIndex("least_clearance_m")));
  EXPECT_FALSE(track->IsFieldSetAndNotNull(track->GetFieldIndex("velocity_max_m_s")));
}

/// The numbers of `wanted` evenly chosen rocks.
std::vector<std::int64_t> chosen(std::uint64_t wanted, const std::vector<std::int64_t>& of) {
  const EvenChoice choice(wanted, of.size());
  std::vector<std::int64_t> rocks;
  for (std::size_t k = 0; k < of.size(); ++k) {
    if (choice.contains(k)) rocks.push_back(of[k]);
  }
  return rocks;
}

TEST(GeoPackage, HasAnEvenChoiceOfManyRocks) {
  const sample_run::Folder folder("gpkg");
  const std::vector<std::int64_t> all{0, 1, 2, 3, 4, 5};
  Json summary = summary_3d();
  const auto write = [&](const std::vector<std::int64_t>& ends, const std::vector<std::int64_t>& ways) {
    write_3d(folder, summary);
    std::string endpoints = endpoints_head, paths = paths_head;
    for (const std::int64_t rock : ends) endpoints += endpoint_row(static_cast<std::uint64_t>(rock));
    for (const std::int64_t rock : ways) paths += path_rows(static_cast<std::uint64_t>(rock));
    folder.write("endpoints.csv", endpoints);
    folder.write("paths.csv", paths);
    EXPECT_EQ(message(folder.path), "was written");
  };
  const auto expect = [&](const std::vector<std::int64_t>& ends, const std::vector<std::int64_t>& ways) {
    const Opened file(folder.path / "results.gpkg");
    EXPECT_EQ(rocks_of(file.layer("endpoints")), ends);
    EXPECT_EQ(rocks_of(file.layer("paths")), ways);
  };
  summary["project"]["output"]["geopackage"] = 3;
  write(all, all);
  expect(chosen(3, all), chosen(3, all));
  // Both of two paths are shown, and three of four.
  for (const std::uint64_t with_path : {2, 4}) {
    const auto ways = chosen(with_path, all);
    summary["project"]["output"]["paths"] = with_path;
    write(all, ways);
    expect(chosen(3, all), chosen(3, ways));
  }
  // The table does not have the end points of all rocks either.
  summary["project"]["output"]["endpoints"] = 5;
  const auto ends = chosen(5, all), ways = chosen(4, ends);
  write(ends, ways);
  expect(chosen(3, ends), chosen(3, ways));
}

TEST(GeoPackage, HasTheRocksDoneOfAnInterruptedRun) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  folder.write("endpoints.csv", endpoints_head + endpoint_row(0) + endpoint_row(1));
  folder.write("paths.csv", paths_head + path_rows(0) + path_rows(1));
  EXPECT_EQ(message(folder.path), "was written");
  EXPECT_THAT(rocks_of(Opened(folder.path / "results.gpkg").layer("paths")), ElementsAre(0, 1));
  folder.write("endpoints.csv", endpoints_head);
  folder.write("paths.csv", paths_head);
  EXPECT_EQ(message(folder.path), "was written");
  EXPECT_EQ(Opened(folder.path / "results.gpkg").layer("endpoints").GetFeatureCount(), 0);
}

TEST(GeoPackage, HasTheSameBytesEachTime) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  EXPECT_EQ(message(folder.path), "was written");
  const std::string once = folder.read("results.gpkg");
  EXPECT_GT(once.size(), 10'000U);
  EXPECT_EQ(message(folder.path), "was written");  // overwrites itself
  EXPECT_TRUE(folder.read("results.gpkg") == once);
  const sample_run::Folder other("gpkg");
  write_3d(other);
  EXPECT_EQ(message(other.path), "was written");
  EXPECT_TRUE(other.read("results.gpkg") == once);
  folder.write("endpoints.csv", endpoints_head);
  folder.write("paths.csv", paths_head);
  EXPECT_EQ(message(folder.path), "was written");
  EXPECT_FALSE(folder.read("results.gpkg") == once);
}

TEST(GeoPackage, RefusesTablesOfDifferentRuns) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  folder.write("paths.csv", paths_head + path_rows(7));
  const std::string message_of_seven =
      "paths.csv: has the path of rock 7 (endpoints.csv has no such rock after those before it). The files are of "
      "different runs; run the project again";
  EXPECT_EQ(message(folder.path), message_of_seven);
  EXPECT_FALSE(std::filesystem::exists(folder.path / "results.gpkg"));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "results.gpkg.part"));
  folder.write("paths.csv", paths_head + path_rows(4) + path_rows(2));
  EXPECT_EQ(
      message(folder.path),
      "paths.csv: has the path of rock 2 (endpoints.csv has no such rock after those before it). The files are of "
      "different runs; run the project again");
  std::filesystem::remove(folder.path / "paths.csv");
  EXPECT_EQ(message(folder.path), "paths.csv: cannot be opened (it must be a readable file)");
}

TEST(GeoPackage, ReportsWhereItCannotBeWritten) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  std::filesystem::create_directories(folder.path / "results.gpkg/in the way");
  EXPECT_EQ(message(folder.path),
            "results.gpkg: cannot finish this file (Is a directory). Choose another folder with -o");
  std::filesystem::remove_all(folder.path / "results.gpkg");
  std::filesystem::create_directories(folder.path / "results.gpkg.part/in the way");
  const std::string text = message(folder.path);
  EXPECT_EQ(text.find("results.gpkg: cannot write this file (GDAL: "), 0U) << text;
  EXPECT_NE(text.find("). Free some space, or choose another folder with -o"), std::string::npos) << text;
}

TEST(GeoPackage, LeavesNoPartOnAFullDisk) {
  const sample_run::Folder folder("gpkg");
  Json summary = summary_3d();
  summary["rocks"]["planned"] = 3000;
  write_3d(folder, summary);
  std::string endpoints = endpoints_head;
  for (std::uint64_t rock = 0; rock < 3000; ++rock) endpoints += endpoint_row(rock);
  folder.write("endpoints.csv", endpoints);
  std::string text;
  {
    const testing_tools::FileSizeLimit limit(262'144);
    text = message(folder.path);
  }
  EXPECT_EQ(text.find("results.gpkg: cannot write this file (GDAL: "), 0U) << text;
  EXPECT_FALSE(std::filesystem::exists(folder.path / "results.gpkg"));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "results.gpkg.part"));
  EXPECT_EQ(message(folder.path), "was written");  // with space again
}

#else

TEST(GeoPackage, IsRefusedWithoutGdal) {
  const sample_run::Folder folder("gpkg");
  write_3d(folder);
  EXPECT_FALSE(can_write_geopackage());
  EXPECT_EQ(message(folder.path),
            "results.gpkg: cannot write this file (this program was built without GDAL). Build it with GDAL, or set "
            "geopackage = \"none\"");
}

#endif

TEST(DerivedFiles, AreThoseOfTheProject) {
  const sample_run::Folder folder("derived");
  Json summary = summary_3d();
  write_3d(folder, summary);
  write_derived_files(folder.path);
  EXPECT_EQ(std::filesystem::exists(folder.path / "results.gpkg"), can_write_geopackage());
  EXPECT_TRUE(std::filesystem::exists(folder.path / "paths.vtp"));
  summary["project"]["output"]["geopackage"] = "none";
  summary["project"]["output"]["vtk"] = false;
  write_3d(folder, summary);
  write_derived_files(folder.path);  // removes those of the previous run
  EXPECT_FALSE(std::filesystem::exists(folder.path / "results.gpkg"));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "paths.vtp"));
}

}  // namespace
}  // namespace talus
