// Reference layers over a model, and contours of its terrain.

#ifdef TALUS_HAS_GDAL

#include "server/served_models.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;

class ServedLayers : public testing_tools::ServedModels {
 protected:
  static std::string with_layer(const std::string& file) {
    return testing_tools::mesh_text + "[[layer]]\nfile = \"" + file + "\"\n";
  }
};

TEST_F(ServedLayers, OfLinesAreDraped) {
  write("road.geojson",
        R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:2056"}}, "features": [
           {"type": "Feature", "properties": {"name": "Road"}, "geometry":
            {"type": "LineString", "coordinates": [[990, 10], [1020, 10]]}}]})");
  const Json model = model_of(with_layer("road.geojson"));
  const Json layer = get(at(model, "layers/0")).json();
  EXPECT_EQ(layer["kind"], "vector");
  EXPECT_EQ(layer["shapes"], 1);
  const ArraysOf arrays(get(at(model, "layers/0/lines")));
  const auto positions = arrays.get<float>("positions", "f32");
  const auto starts = arrays.get<std::uint32_t>("starts", "u32");
  ASSERT_EQ(starts.size(), 1U) << "the part beside the terrain is left out";
  EXPECT_EQ(arrays.header["names"], Json::parse(R"(["", "Road"])"));
  const double x0 = arrays.header["origin"][0], z0 = arrays.header["origin"][2];
  for (std::size_t k = 0; k < positions.size(); k += 3) {
    const double x = positions[k] + x0, z = positions[k + 2] + z0;
    EXPECT_NEAR(z, x < 1010 ? 20 - (x - 1000) : 10 - (x - 1010) / 4, 0.01);
  }
  const Reply near = post("/api/models/" + model["id"].get<std::string>() + "/layers/0/nearest",
                          {{"place", {1005, 12}}, {"reach_m", 5}});
  EXPECT_EQ(near.json()["shape"]["name"], "Road");
  EXPECT_EQ(near.json()["shape"]["points"], Json::parse("[[990.0, 10.0], [1020.0, 10.0]]"));
  EXPECT_EQ(get(at(model, "layers/0/picture")).status, 404);
}

TEST_F(ServedLayers, OfRastersArePictures) {
  write("snow.asc", "ncols 2\nnrows 2\nxllcorner 1000\nyllcorner 0\ncellsize 10\n1.5 2\n3 4.5\n");
  const Json model = model_of(with_layer("snow.asc"));
  const Json layer = get(at(model, "layers/0")).json();
  EXPECT_EQ(layer["kind"], "raster") << layer;
  EXPECT_EQ(layer["area"], Json::parse("[[1000.0, 0.0], [1020.0, 20.0]]"));
  EXPECT_EQ(layer["ramp"]["least"], 1.5);
  const Reply picture = get(at(model, "layers/0/picture"));
  EXPECT_EQ(picture.status, 200);
  EXPECT_THAT(picture.body, ::testing::StartsWith("\xff\xd8")) << "a JPEG";
}

TEST_F(ServedLayers, ThatCannotBeDrawnAreRefused) {
  const Json model = model_of(with_layer("missing.tif"));
  const Reply reply = get(at(model, "layers/0"));
  EXPECT_EQ(reply.status, 422);
  EXPECT_THAT(reply.problem(), ::testing::HasSubstr("missing.tif: cannot be read (there is no such file)"));
  EXPECT_EQ(reply.json()["problems"][0]["path"], "layer.0.file");
  EXPECT_EQ(get(at(model, "layers/1")).status, 404);
}

TEST_F(ServedLayers, AndContoursOfTheTerrain) {
  const Json model = model_of(testing_tools::mesh_text);
  const std::string address = "/api/models/" + model["id"].get<std::string>() + "/contour";
  const Json found = post(address, {{"place", {1005, 20}}}).json();
  EXPECT_NEAR(found["elevation_m"].get<double>(), 15, 1e-9);
  for (const Json& point : found["points"]) EXPECT_NEAR(point[0].get<double>(), 1005, 1e-9);
  EXPECT_EQ(post(address, {{"place", {900, 20}}}).status, 422);
  EXPECT_EQ(post(address, {{"place", 3}}).status, 400);
}

}  // namespace
}  // namespace talus

#endif
