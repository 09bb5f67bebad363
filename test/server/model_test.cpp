// Models of posted texts: problems name their setting, and models are cached.

#include "server/served_models.hpp"

#include <atomic>
#include <thread>

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;

using testing_tools::mesh_text;
using testing_tools::section_text;

using ModelOf = testing_tools::ServedModels;

TEST_F(ModelOf, NamesTheSettingOfEachProblem) {
  EXPECT_EQ(problems_of(with(section_text, "mass_kg = 1000", "mass_kg = { mean = -1 }")),
            (std::vector<std::string>{"seeder.0.mass_kg.mean: slope.toml:14: seeder \"Edge\": mass_kg mean is -1 (a "
                                      "rock has mass; expected 1e-9 to 1e12)"}));
  EXPECT_EQ(paths_of(with(section_text, "[30, 5]", "[30, \"five\"]")), std::vector<std::string>{"terrain.section.2.1"});
  EXPECT_EQ(paths_of(with(section_text, "name = \"Soil\"", "nam = \"Soil\"")),
            std::vector<std::string>{"material.1.nam"});
  EXPECT_EQ(paths_of(with(section_text, "\"Soil\"]", "\"Sol\"]")), std::vector<std::string>{"ground.segments.1"});
  EXPECT_EQ(paths_of(with(section_text, "[[seeder]]", "[[seder]]")), (std::vector<std::string>{"seeder", "seder"}));
  EXPECT_EQ(paths_of(section_text + "[analysis]\nrn_mass_scale_kg = 10\n"),
            std::vector<std::string>{"analysis.rn_mass_scale_kg"});
  EXPECT_EQ(paths_of(with(section_text, "mass_kg = 1000", "\"a.b\" = 1\nmass_kg = 1000")),
            std::vector<std::string>{"seeder.0.\"a.b\""});
}

TEST_F(ModelOf, ListsTheFirstOfVeryManyProblems) {
  std::string text = section_text;
  for (int k = 0; k < 1500; ++k) text += "[[collector]]\nline = 5\nheight_m = 1\nbad = 1\n";
  const std::vector<std::string> problems = problems_of(text);
  ASSERT_EQ(problems.size(), 1001U);
  EXPECT_TRUE(problems[999].starts_with("collector.999.bad: ")) << problems[999];
  EXPECT_EQ(problems[1000], ": there are 500 more problems (only 1000 are listed)");
}

TEST_F(ModelOf, NamesTheMissingKey) {
  EXPECT_EQ(paths_of(with(section_text, "position = [1, 25]\n", "")), std::vector<std::string>{"seeder.0.position"});
  EXPECT_EQ(paths_of(with(section_text, "height_m = 4\n", "")), std::vector<std::string>{"barrier.0.height_m"});
  EXPECT_EQ(paths_of(with(mesh_text, "cell_m = 1\n", "")), std::vector<std::string>{"seeder.1.cell_m"});
}

TEST_F(ModelOf, NamesTheSettingOfProblemsWithTheTerrain) {
  EXPECT_EQ(problems_of(with(section_text, "position = [1, 25]", "position = [100, 25]")),
            (std::vector<std::string>{"seeder.0: slope.toml:10: seeder \"Edge\": x = 100 is off the terrain (the "
                                      "section extends from x = 0 to 30)"}));
  EXPECT_EQ(paths_of(with(mesh_text, "line = [[1028, 2], [1028, 38]]", "line = [[28, 2], [28, 38]]")),
            std::vector<std::string>{"collector.0"});
  EXPECT_EQ(paths_of(with(mesh_text, "polygon = [[1002, 2], [1008, 2], [1008, 30], [1002, 30]]",
                          "polygon = [[2, 2], [8, 2], [8, 30], [2, 30]]")),
            std::vector<std::string>{"seeder.1"});
}

TEST_F(ModelOf, NamesTheSettingOfAnInvalidFile) {
  write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  const std::string text =
      "[terrain]\nmesh = \"bad.obj\"\n[[material]]\nname = \"A\"\n[[seeder]]\nposition = [0, 0, 1]\nmass_kg = 1\n";
  const Json answer = posted(text);
  EXPECT_TRUE(answer["model"].is_null());
  ASSERT_FALSE(answer["problems"].empty());
  EXPECT_EQ(answer["problems"][0]["file"], "slope.toml");
  EXPECT_EQ(answer["problems"][0]["line"], 2);
  EXPECT_EQ(answer["problems"][0]["path"], "terrain.mesh");
}

TEST_F(ModelOf, ReportsTheLineOfInvalidToml) {
  const Json answer = posted("[terrain\n");
  ASSERT_EQ(answer["problems"].size(), 1U);
  EXPECT_EQ(answer["problems"][0]["line"], 1);
  EXPECT_EQ(answer["problems"][0]["path"], "");
  EXPECT_TRUE(answer["model"].is_null());
}

TEST_F(ModelOf, IsTheSameForTheSameText) {
  const std::string id = model_of(section_text)["id"];
  EXPECT_EQ(model_of(section_text)["id"], id);
  const Json other = model_of(section_text + "# changed\n");
  EXPECT_NE(other["id"], id);
  EXPECT_EQ(other["files"], model_of(section_text)["files"]);
}

TEST_F(ModelOf, IsDroppedAfterAFewOthers) {
  const Json first = model_of(section_text);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(get(at(first, "profile")).status, 200);
    static_cast<void>(model_of(section_text + fmt::format("# {}\n", k)));
  }
  const Reply gone = get(at(first, "profile"));
  EXPECT_EQ(gone.status, 404);
  EXPECT_EQ(gone.problem(), first["id"].get<std::string>() +
                                ": there is no such model (only the last few are kept). Post the project again");
  for (const std::string what : {"mesh", "profile", "tiles", "tiles/0/0/0"})
    EXPECT_EQ(get("/api/models/0123456789abcdef/" + what).status, 404) << what;
  EXPECT_EQ(post("/api/models/0123456789abcdef/elevations", {{"points", Json::array()}}).status, 404);
}

TEST_F(ModelOf, IsRebuiltWhenItsFilesChange) {
  const auto mesh = [&](double top) {
    write("slope.obj", fmt::format("v 0 0 {0}\nv 10 0 0\nv 10 10 0\nv 0 10 {0}\nf 1 2 3\nf 1 3 4\n", top));
  };
  const std::string text =
      "[terrain]\nmesh = \"slope.obj\"\n[[material]]\nname = \"A\"\n[[seeder]]\n"
      "position = [1, 1, \"surface\"]\nmass_kg = 1\n";
  mesh(5);
  const Json before = model_of(text);
  mesh(6.5);
  const Json after = model_of(text);
  EXPECT_NE(before["id"], after["id"]);
  EXPECT_NE(before["files"], after["files"]);
  EXPECT_EQ(before["bounds"]["max"][2], 5.0);
  EXPECT_EQ(after["bounds"]["max"][2], 6.5);
}

TEST_F(ModelOf, CanBeUsedWhileOthersAreBuilt) {
  std::vector<std::thread> pages;
  std::atomic<int> wrong{0};
  for (int page = 0; page < 6; ++page) {
    pages.emplace_back([&, page] {
      for (int k = 0; k < 8; ++k) {
        const std::string text = mesh_text + fmt::format("# {} {}\n", page % 3, k % 5);
        const Reply reply = post("/api/model", {{"file", "slope.toml"}, {"text", text}});
        const Json model = reply.json()["model"];
        const int status = model.is_null() ? 0 : get(at(model, "mesh")).status;
        wrong += status == 200 || status == 404 ? 0 : 1;  // 404: dropped meanwhile
      }
    });
  }
  for (std::thread& page : pages) page.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace talus
