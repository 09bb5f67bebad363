// Lines and areas from vector files, for asking a run about them.

#include "server/served_models.hpp"

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;

class LineFiles : public testing_tools::ServedModels {
 protected:
  [[nodiscard]] Reply lines_of(const std::string& name, const std::string& content) const {
    write(name, content);
    return get(at(model_of(testing_tools::mesh_text), "lines?file=" + name));
  }
  static std::string collection(const std::string& geometries) {
    return R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:2056"}}, "features": [)" +
           geometries + "]}";
  }
  static std::string feature(const std::string& type, const std::string& coordinates) {
    return R"({"type": "Feature", "properties": {}, "geometry": {"type": ")" + type + R"(", "coordinates": )" +
           coordinates + "}}";
  }
};

TEST_F(LineFiles, HaveTheirLinesAndOuterRings) {
  const Reply reply = lines_of("road.geojson", collection(feature("LineString", "[[1002, 3], [1010, 9.5, 7]]") + "," +
                                                          feature("Polygon",
                                                                  "[[[1000, 0], [1020, 0], [1020, 30], [1000, 0]], "
                                                                  "[[1010, 2], [1015, 4], [1015, 2], [1010, 2]]]")));
  ASSERT_EQ(reply.status, 200) << reply.body;
  const Json json = reply.json();
  EXPECT_EQ(json["shapes"][0], Json::parse(R"({"kind": "line", "points": [[1002.0, 3.0], [1010.0, 9.5]]})"));
  EXPECT_EQ(json["shapes"][1]["kind"], "polygon");
  EXPECT_EQ(json["shapes"][1]["points"].size(), 3U);
  EXPECT_EQ(json["shapes"].size(), 2U);
}

TEST_F(LineFiles, WithoutLinesAreRefused) {
  const Reply points = lines_of("blocks.geojson", collection(feature("Point", "[1002, 3]")));
  EXPECT_EQ(points.status, 422) << points.body;
  EXPECT_EQ(lines_of("none.geojson", "{}").status, 422);
  EXPECT_EQ(get(at(model_of(testing_tools::mesh_text), "lines?file=missing.geojson")).status, 404);
}

}  // namespace
}  // namespace talus
