// Projects are renamed, deleted and restored with what belongs to them, or not at all.

#include "server/served_runs.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

class ProjectFiles : public ServedRuns {
 protected:
  ProjectFiles() { write(file_, section()); }

  [[nodiscard]] Reply rename(const std::string& file, const std::string& name) const {
    return with_json("PATCH", "/api/projects/" + file, {{"name", name}});
  }
  [[nodiscard]] Reply remove(const std::string& file) const { return send("DELETE", "/api/projects/" + file); }
  [[nodiscard]] Reply save_picture(const std::string& file, const std::string& bytes) const {
    return send("PUT", "/api/pictures/" + file, bytes, {{"Content-Type", "application/octet-stream"}});
  }
  [[nodiscard]] std::string done_run() const {
    const std::string id = begin(section());
    (void)wait_for(id, "done");
    return id;
  }
  /// All files of the folder with their texts.
  [[nodiscard]] std::map<std::string, std::string> everything() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(path("")))
      if (entry.is_regular_file()) {
        const std::string name = entry.path().lexically_relative(path("")).generic_string();
        all[name] = read(name);
      }
    return all;
  }

  const std::string png_ = "\x89PNG\r\n\x1a\n the rest";
};

TEST_F(ProjectFiles, AreRenamedWithRunsDraftPictureAndStudies) {
  const std::string id = done_run();
  put("/api/draft", {{"file", file_}, {"text", "name = \"changed\""}});
  EXPECT_EQ(save_picture(file_, png_).status, 200);
  const std::string study =
      "name = \"s\" # project = \"slope.toml\"\n[[site]]\n  project = 'slope.toml' # ours\n[[site]]\nproject = "
      "\"other.toml\"\n[[site]]\nproject = \"slope.toml\"\n";
  write("a.study.toml", study);
  write("b.study.toml", "[[site]]\nproject = \"slope2.toml\"\n");
  write("c.study.toml", "not toml [");

  const Reply reply = rename("slope.toml", "B\xC3\xB6schung.toml");
  ASSERT_EQ(reply.status, 200) << reply.body;
  EXPECT_EQ(reply.json()["file"], "B\xC3\xB6schung.toml");
  EXPECT_FALSE(fs::exists(path("slope.toml")));
  EXPECT_FALSE(fs::exists(path("runs/slope")));
  EXPECT_EQ(read("B\xC3\xB6schung.toml"), section());
  EXPECT_EQ(run(id)["file"], "B\xC3\xB6schung.toml");
  EXPECT_EQ(run(id)["folder"], "runs/B\xC3\xB6schung/" + id);
  EXPECT_EQ(get("/api/runs/" + id + "/summary").status, 200);
  EXPECT_EQ(get("/api/project?file=B%C3%B6schung.toml").json()["draft"]["text"], "name = \"changed\"");
  EXPECT_EQ(get("/api/pictures/B%C3%B6schung.toml").body, png_);
  EXPECT_EQ(read("a.study.toml"),
            "name = \"s\" # project = \"slope.toml\"\n[[site]]\n  project = \"B\xC3\xB6schung.toml\" # ours\n"
            "[[site]]\nproject = \"other.toml\"\n[[site]]\nproject = \"B\xC3\xB6schung.toml\"\n");
  EXPECT_EQ(read("b.study.toml"), "[[site]]\nproject = \"slope2.toml\"\n");
  EXPECT_EQ(read("c.study.toml"), "not toml [");

  stop();
  start();
  EXPECT_EQ(run(id)["file"], "B\xC3\xB6schung.toml") << "the next server finds its runs";
}

TEST_F(ProjectFiles, ARenamedProjectRunsAndResumes) {
  const std::string id = begin(section(), {{"rocks", 3'000'000}});
  (void)wait_for_rocks(id);
  (void)ask(id, "stop");
  (void)wait(id, [](const Json& now) { return now["state"] == "stopped" && now["has_results"] == true; });
  ASSERT_EQ(rename("slope.toml", "west.toml").status, 200);
  EXPECT_EQ(ask(id, "resume").status, 202);
  (void)wait(id, [](const Json& now) { return now["state"] == "running"; });
  EXPECT_EQ(rename("west.toml", "east.toml").problem(),
            "west.toml: cannot be renamed (its run \"Tutorial 1, section\" is running). Stop it first");
  EXPECT_EQ(remove("west.toml").problem(),
            "west.toml: cannot be deleted (its run \"Tutorial 1, section\" is running). Stop it first");
  (void)ask(id, "stop");
  (void)wait_for(id, "stopped");
  EXPECT_TRUE(fs::exists(path("west.toml")));
}

TEST_F(ProjectFiles, AreNotRenamedIfTheNameIsTakenOrWrong) {
  write("taken.toml", "name = \"t\"");
  write("runs/earlier/x.txt", "x");
  write("site.study.toml", "");
  const auto before = everything();
  const auto refused = [&](const std::string& name, int status) {
    const Reply reply = rename("slope.toml", name);
    EXPECT_EQ(reply.status, status) << name;
    return reply.problem();
  };
  EXPECT_EQ(refused("taken.toml", 409), "taken.toml: already exists. Choose another name");
  EXPECT_EQ(refused("slope.toml", 409), "slope.toml: already exists. Choose another name");
  EXPECT_EQ(
      refused("earlier.toml", 409),
      "earlier.toml: cannot have this name (there are runs of an earlier project of that name). Choose another name");
  EXPECT_EQ(refused("a/b.toml", 400),
            "a/b.toml: is not the name of a file (a project keeps its folder, which its files are relative to)");
  for (const char* name : {"slope.txt", "slope.study.toml"})
    EXPECT_EQ(refused(name, 400),
              std::string(name) + ": is not the name of a project (it must end in .toml, and not in .study.toml)");
  EXPECT_EQ(refused(".hidden.toml", 403), ".hidden.toml: is not a name in this folder (it begins with a dot)");
  EXPECT_EQ(rename("gone.toml", "b.toml").problem(), "gone.toml: there is no such file");
  EXPECT_EQ(rename("site.study.toml", "b.toml").problem(),
            "site.study.toml: is a study, not a project (its name ends in .study.toml)");
  EXPECT_EQ(rename("../secret.toml", "b.toml").status, 403);
  EXPECT_EQ(everything(), before);
}

TEST_F(ProjectFiles, AreNotRenamedIfAStudyCannotFollow) {
  const std::string id = done_run();
  write("a.study.toml", "[[site]]\nproject = \"slope.toml\"\n");
  write("b.study.toml", "[[site]]\nproject = \"sl\\u006Fpe.toml\"\n");
  const auto before = everything();
  const Reply reply = rename("slope.toml", "west.toml");
  EXPECT_EQ(reply.status, 422);
  EXPECT_EQ(reply.problem(), path("b.study.toml").string() +
                                 ":2: names slope.toml in a way that cannot be replaced. Write project = "
                                 "\"slope.toml\" there, then rename the project");
  EXPECT_EQ(everything(), before);
  EXPECT_EQ(run(id)["file"], "slope.toml");
}

TEST_F(ProjectFiles, AreDeletedAndRestored) {
  const std::string id = done_run();
  EXPECT_EQ(save_picture(file_, png_).status, 200);
  put("/api/draft", {{"file", file_}, {"text", "name = \"changed\""}});
  const auto before = everything();

  const Reply reply = remove("slope.toml");
  ASSERT_EQ(reply.status, 200) << reply.body;
  const Json gone = reply.json();
  EXPECT_EQ(gone["file"], "slope.toml");
  EXPECT_EQ(gone["runs"], 1);
  EXPECT_EQ(get("/api/runs/" + id).status, 404);
  EXPECT_TRUE(get("/api/files").json()["files"].empty());
  EXPECT_TRUE(get("/api/files").json()["drafts"].empty());
  EXPECT_EQ(get("/api/deleted").json()["deleted"], Json::array({gone}));
  stop();
  start();
  EXPECT_TRUE(list().empty()) << "its runs stay deleted";

  write("slope.toml", "another");
  const std::string place = "/api/deleted/" + gone["id"].get<std::string>();
  EXPECT_EQ(post(place + "/restore", Json::object()).problem(), "slope.toml: already exists. Choose another name");
  fs::remove(path("slope.toml"));
  EXPECT_EQ(post(place + "/restore", Json::object()).json()["file"], "slope.toml");
  EXPECT_EQ(everything(), before);
  EXPECT_EQ(run(id)["state"], "done");
  EXPECT_TRUE(get("/api/deleted").json()["deleted"].empty());
  EXPECT_EQ(post(place + "/restore", Json::object()).status, 404);
}

TEST_F(ProjectFiles, AreErasedForGood) {
  const std::string id = remove("slope.toml").json()["id"];
  write("folder.txt", "stays");
  for (const char* other : {"..", ".", "20200101-000000-000"})
    EXPECT_EQ(send("DELETE", "/api/deleted/" + std::string(other)).status, 404) << other;
  EXPECT_EQ(send("DELETE", "/api/deleted/" + id).status, 200);
  EXPECT_EQ(everything(), (std::map<std::string, std::string>{{"folder.txt", "stays"}}));
  EXPECT_EQ(remove("slope.toml").problem(), "slope.toml: there is no such file");
}

TEST_F(ProjectFiles, ADraftAloneIsAProject) {
  put("/api/draft", {{"file", "new.toml"}, {"text", "name = \"new\""}});
  EXPECT_EQ(rename("new.toml", "newer.toml").status, 200);
  EXPECT_EQ(get("/api/project?file=newer.toml").json()["draft"]["text"], "name = \"new\"");
  EXPECT_EQ(remove("newer.toml").status, 200);
  EXPECT_TRUE(get("/api/files").json()["drafts"].empty());
}

TEST_F(ProjectFiles, HavePictures) {
  const auto listed = [&] { return get("/api/files").json()["files"][0]["picture"]; };
  EXPECT_TRUE(listed().is_null());
  EXPECT_EQ(get("/api/pictures/slope.toml").problem(), "slope.toml: has no picture");
  EXPECT_EQ(save_picture(file_, "<svg onload=alert(1)>").problem(),
            "slope.toml: has no picture (expected a PNG or WebP file)");
  EXPECT_EQ(save_picture("gone.toml", png_).problem(), "gone.toml: there is no such file");
  EXPECT_EQ(save_picture(file_, png_ + std::string(300'000, 'x')).status, 413);
  EXPECT_TRUE(listed().is_null());
  EXPECT_EQ(save_picture(file_, png_).status, 200);
  EXPECT_GT(listed(), 1'500'000'000'000);
  const Reply png = get("/api/pictures/slope.toml");
  EXPECT_EQ(png.body, png_);
  EXPECT_EQ(png.headers.find("Content-Type")->second, "image/png");
  const std::string webp = "RIFF1234WEBPVP8 ...";
  EXPECT_EQ(save_picture(file_, webp).status, 200);
  EXPECT_EQ(get("/api/pictures/slope.toml").headers.find("Content-Type")->second, "image/webp");
  EXPECT_EQ(get("/api/files").json()["files"].size(), 1U) << "a picture is not a file of the folder";
}

}  // namespace
}  // namespace talus
