// Hostile or contradictory vector files, and errors in single features.

#ifdef TALUS_HAS_GDAL

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/rasters.hpp"
#include "support/vectors.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/survey_files.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {
namespace {

using namespace testing_tools;

class RefusedVectors : public RasterFolder {
 protected:
  void layer(const std::string& file, const std::string& crs, const std::vector<WrittenFeature>& features) {
    std::filesystem::remove(path(file));
    add_layer(path(file), "layer", crs, "name", features);
  }
  [[nodiscard]] std::string refusal(const std::string& file, const VectorRequest& request = {}) {
    return refusal_of([&] { static_cast<void>(read_vector_file(path(file), request, warnings_)); });
  }
  [[nodiscard]] std::string survey_refusal(const SurveySources& sources) {
    return refusal_of([&] { static_cast<void>(read_survey(sources, warnings_)); });
  }
};

TEST_F(RefusedVectors, APipe) {
  ASSERT_EQ(::mkfifo(path("pipe.gpkg").c_str(), 0600), 0);
  EXPECT_EQ(refusal("pipe.gpkg"), "pipe.gpkg: cannot be read (it is a pipe). Name a file");
}

TEST_F(RefusedVectors, AFeatureThatCannotBeTransformed) {
  // A gnomonic projection does not cover the other side of the earth.
  OGRSpatialReference gnomonic;
  ASSERT_EQ(gnomonic.SetFromUserInput("+proj=gnom +lat_0=47 +lon_0=13 +datum=WGS84 +units=m"), OGRERR_NONE);
  layer("lines.gpkg", "EPSG:4326", {{"LINESTRING (13 47, 13.01 47)", "a"}, {"LINESTRING (13 47, -167 -47)", "b"}});
  VectorRequest request;
  request.terrain_crs_wkt = wkt_of(gnomonic);
  EXPECT_EQ(refusal("lines.gpkg", request),
            "lines.gpkg: feature 2 is at (-167, -47) (it cannot be transformed from EPSG:4326 to unknown, that of the "
            "terrain). "
            "Assign the right one: ogr2ogr -a_srs EPSG:XXXX lines_placed.gpkg lines.gpkg");
}

TEST_F(RefusedVectors, AnOpenRing) {
  layer("ground.gpkg", "EPSG:31287",
        {{"POLYGON ((400000 300000, 400010 300000, 400010 300010, 400000 300010, 400000 300000))", "a"},
         {"POLYGON ((400000 300000, 400010 300000, 400010 300010, 400003 300004))", "b"}});
  EXPECT_EQ(refusal("ground.gpkg"),
            "ground.gpkg: feature 2 is not closed (its ends are 5 apart). Repeat its first vertex at its end");
}

TEST_F(RefusedVectors, HeightsInFeet) {
  layer("cliff.gpkg", "EPSG:32610+6360", {{"LINESTRING Z (500000 4000000 100, 500010 4000000 100)", "a"}});
  VectorRequest request;
  request.terrain_crs_wkt = wkt("EPSG:32610");
  EXPECT_EQ(refusal("cliff.gpkg", request), "was read") << "its heights are not used";
  request.heights_are_used = true;
  EXPECT_EQ(refusal("cliff.gpkg", request),
            "cliff.gpkg: has heights in US survey foot (that is the unit of WGS 84 / UTM zone 10N + NAVD88 height "
            "(ftUS), 0.3048006096 m; Talus needs metres). Transform it to one with heights in metres: ogr2ogr "
            "-t_srs EPSG:XXXX+XXXX cliff_metres.gpkg cliff.gpkg");
  layer("flat.gpkg", "EPSG:32610+6360", {{"LINESTRING (500000 4000000, 500010 4000000)", "a"}});
  EXPECT_EQ(refusal("flat.gpkg", request), "was read") << "it has no heights";
}

TEST_F(RefusedVectors, HeightsInAnUnknownUnitWithFeetOnPlan) {
  layer("cliff.gpkg", "EPSG:2263", {{"LINESTRING Z (1000000 200000 100, 1000010 200000 100)", "a"}});
  VectorRequest request;
  request.terrain_crs_wkt = wkt("EPSG:32618");
  request.heights_are_used = true;
  EXPECT_EQ(refusal("cliff.gpkg", request),
            "cliff.gpkg: has heights without a unit (the unit of EPSG:2263 is US survey foot on plan, and it has none "
            "for heights). Transform it to one with heights in metres: ogr2ogr -t_srs EPSG:XXXX+XXXX "
            "cliff_metres.gpkg cliff.gpkg");
}

TEST_F(RefusedVectors, Depths) {
  layer("bed.gpkg", "EPSG:31287+5715", {{"POINT Z (400000 300000 12)", "a"}});
  VectorRequest request;
  request.heights_are_used = true;
  EXPECT_EQ(refusal("bed.gpkg", request),
            "bed.gpkg: has depths (MGI / Austria Lambert + MSL depth measures them downwards; Talus needs heights). "
            "Transform it to one with heights in metres: ogr2ogr -t_srs EPSG:XXXX+XXXX bed_metres.gpkg bed.gpkg");
}

TEST_F(RefusedVectors, NamesThatAreNotUtf8) {
  write("cliffs.csv", "WKT,name\n\"LINESTRING (0 0,1 1)\",M\xC3\xBCller\n\"LINESTRING (0 0,1 1)\",M\xFCller\n");
  VectorRequest request;
  request.attributes = {"name"};
  EXPECT_EQ(refusal("cliffs.csv", request),
            "cliffs.csv: feature 2 has the name \"Müller\" (it is not valid UTF-8). Convert the file, "
            "for example with iconv -f LATIN1 -t UTF-8, or declare its encoding");
}

TEST_F(RefusedVectors, ContoursInFeetWithPointsInMetres) {
  write("points.csv", "x,y,z\n500000,4000000,100\n500100,4000000,110\n500000,4000100,120\n");
  layer("contours.gpkg", "EPSG:32610+6360", {{"LINESTRING Z (500010 4000010 350, 500050 4000010 350)", "a"}});
  SurveySources sources;
  sources.points = path("points.csv");
  sources.lines = path("contours.gpkg");
  EXPECT_EQ(survey_refusal(sources),
            "contours.gpkg: has heights in US survey foot (that is the unit of WGS 84 / UTM zone 10N + NAVD88 height "
            "(ftUS), 0.3048006096 m; Talus needs metres). Transform it to one with heights in metres: ogr2ogr "
            "-t_srs EPSG:XXXX+XXXX contours_metres.gpkg contours.gpkg");
}

TEST_F(RefusedVectors, AnAttributeInFeet) {
  layer("contours.gpkg", "EPSG:32610", {{"LINESTRING (500010 4000010, 500050 4000010)", "350"}});
  SurveySources sources;
  sources.lines = path("contours.gpkg");
  for (const char* name : {"elev_ft", "Z (feet)", "ELEV.FTUS"}) {
    sources.elevation_attribute = name;
    EXPECT_EQ(
        survey_refusal(sources),
        "contours.gpkg: attribute \"" + std::string(name) +
            "\" is in feet (Talus needs heights in metres). Convert it to metres: a foot is 0.3048 m, a US survey "
            "foot 1200/3937 m");
  }
  sources.elevation_attribute = "shift";  // ends in ft, but not as a word
  EXPECT_EQ(survey_refusal(sources), "contours.gpkg: layer \"layer\" has no attribute \"shift\" (it has \"name\")");
}

}  // namespace
}  // namespace talus

#endif
