#pragma once
// A server with models of posted texts.

#include "server/served.hpp"

#include <string>
#include <vector>

#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::testing_tools {

inline const std::string section_text = R"(
[terrain]
section = [[0, 20], [10, 10], [30, 5]]
[[material]]
name = "Rock"
[[material]]
name = "Soil"
[ground]
segments = ["Rock", "Soil"]
[[seeder]]
name = "Edge"
position = [1, 25]
rocks = 1
mass_kg = 1000
[[barrier]]
name = "Net"
line = 20
height_m = 4
inclination_deg = 30
capacity_kJ = 500
)";

inline const std::string mesh_text = R"(
[terrain]
section = [[1000, 20], [1010, 10], [1030, 5]]
width_m = 40
[[material]]
name = "Rock"
[[material]]
name = "Soil"
[ground]
segments = ["Rock", "Soil"]
[[seeder]]
name = "Edge"
type = "line"
points = [[1001, 5, "surface"], [1001, 35, "surface"]]
rocks = 10
mass_kg = 1000
[[seeder]]
name = "Area"
type = "polygon"
polygon = [[1002, 2], [1008, 2], [1008, 30], [1002, 30]]
cell_m = 1
rocks = 5000
mass_kg = 1000
[[barrier]]
name = "Net"
line = [[1020, 2], [1020, 20], [1025, 38]]
height_m = 4
inclination_deg = -20
[[collector]]
name = "Road"
line = [[1028, 2], [1028, 38]]
height_m = 3
)";

class ServedModels : public Served {
 protected:
  /// The answer to the posted text of a project.
  [[nodiscard]] Json posted(const std::string& text) const {
    const Reply reply = post("/api/model", {{"file", "slope.toml"}, {"text", text}});
    EXPECT_EQ(reply.status, 200) << reply.body;
    return reply.json();
  }
  /// The model of a text without errors.
  [[nodiscard]] Json model_of(const std::string& text) const {
    const Json answer = posted(text);
    EXPECT_FALSE(answer["model"].is_null()) << answer.dump(1);
    return answer["model"];
  }
  /// The URL of a part of a model.
  [[nodiscard]] static std::string at(const Json& model, const std::string& what) {
    return "/api/models/" + model["id"].get<std::string>() + "/" + what;
  }
  /// The engine's model of the same text.
  [[nodiscard]] Model built(const std::string& text) const {
    project::Reading reading = project::read_project_text(text, path("slope.toml"));
    return project::build_model(reading.project, reading.warnings);
  }
  /// "path: text" of each problem.
  [[nodiscard]] std::vector<std::string> problems_of(const std::string& text) const {
    const Json answer = posted(text);
    std::vector<std::string> list;
    for (const Json& problem : answer["problems"])
      list.push_back(problem["path"].get<std::string>() + ": " + problem["text"].get<std::string>());
    return list;
  }
  [[nodiscard]] std::vector<std::string> paths_of(const std::string& text) const {
    const Json answer = posted(text);
    std::vector<std::string> list;
    for (const Json& problem : answer["problems"]) list.push_back(problem["path"].get<std::string>());
    return list;
  }
  /// The text with one replacement.
  static std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
    const std::size_t begin = text.find(old_part);
    EXPECT_NE(begin, std::string::npos) << old_part;
    return text.replace(begin, old_part.size(), new_part);
  }
};

}  // namespace talus::testing_tools
