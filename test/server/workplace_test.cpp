// Names in requests stay in the folder; uploads are complete; drafts and saved texts do not overwrite each other.

#include "workplace.hpp"

#include <map>

#include "server/served.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::Served;

class Place : public Served {
 protected:
  Place() : Served({.upload_bytes = 65536}) {
    std::ofstream(base_ / "secret.toml") << "secret";
    fs::create_directories(base_ / "outside");
    std::ofstream(base_ / "outside" / "secret.toml") << "secret";
  }

  /// The reason why a name is refused, or "is fine".
  [[nodiscard]] std::string refusal(const std::string& name) const {
    try {
      static_cast<void>(server::Workplace(path("")).at(name));
    } catch (const server::Refusal& refused) {
      EXPECT_EQ(refused.status(), 403);
      return refused.problem().why;
    }
    return "is fine";
  }
};

TEST_F(Place, AcceptsNamesBelowIt) {
  for (const std::string name : {"a.toml", "a/b.toml", "a b/ü.tif", "a..b", "a../b~"})
    EXPECT_EQ(refusal(name), "is fine") << name;
}

TEST_F(Place, RefusesNamesThatLeadOut) {
  EXPECT_EQ(refusal(""), "it is empty");
  EXPECT_EQ(refusal("../secret.toml"), "it leads out of the folder");
  EXPECT_EQ(refusal("a/../../secret.toml"), "it leads out of the folder");
  EXPECT_EQ(refusal("a/.."), "it leads out of the folder");
  EXPECT_EQ(refusal("/etc/passwd"), "it is absolute");
  EXPECT_EQ(refusal(".a.toml.draft"), "it begins with a dot");
  EXPECT_EQ(refusal("a/.git/config"), "it begins with a dot");
  EXPECT_EQ(refusal("./a.toml"), "it begins with a dot");
  EXPECT_EQ(refusal("a\nb"), "it has control characters");
  EXPECT_EQ(refusal(std::string("a\0b", 3)), "it has control characters");
  EXPECT_EQ(refusal(std::string(2000, 'a')), "it is too long");
  EXPECT_EQ(refusal(std::string(300, 'a') + ".toml"), "it is too long");
}

TEST_F(Place, RefusesLinksThatLeadOut) {
  fs::create_directory_symlink(base_ / "outside", path("linked"));
  fs::create_symlink(base_ / "secret.toml", path("link.toml"));
  write("inside.toml", "name = \"in\"");
  fs::create_symlink(path("inside.toml"), path("good.toml"));
  EXPECT_EQ(refusal("linked/secret.toml"), "it leads out of the folder");
  EXPECT_EQ(refusal("linked/new.toml"), "it leads out of the folder");
  EXPECT_EQ(refusal("link.toml"), "it leads out of the folder");
  EXPECT_EQ(refusal("good.toml"), "is fine");
}

TEST_F(Place, IsNotLeftByRequests) {
  fs::create_directory_symlink(base_ / "outside", path("linked"));
  for (const std::string name : {"../secret.toml", "%2e%2e%2fsecret.toml", "%2e%2e/secret.toml",
                                 "a/%2e%2e/%2e%2e/secret.toml", "linked/secret.toml", "%2fetc%2fpasswd.toml"}) {
    EXPECT_EQ(get("/api/project?file=" + name).status, 403) << name;
    EXPECT_EQ(upload(name + "?replace=1", "overwritten").status, 403) << name;
  }
  for (const std::string name : {"../secret.toml", "a/../../secret.toml", "linked/secret.toml", "/etc/x.toml"}) {
    EXPECT_EQ(put("/api/project", {{"file", name}, {"text", "overwritten"}, {"saved", nullptr}}).status, 403) << name;
    EXPECT_EQ(put("/api/draft", {{"file", name}, {"text", "overwritten"}}).status, 403) << name;
    EXPECT_EQ(post("/api/model", {{"file", name}, {"text", ""}}).status, 403) << name;
  }
  std::ifstream secret(base_ / "secret.toml"), outside(base_ / "outside" / "secret.toml");
  std::string text;
  secret >> text;
  EXPECT_EQ(text, "secret");
  outside >> text;
  EXPECT_EQ(text, "secret");
}

TEST_F(Place, SavesUploads) {
  const std::string bytes("\0\1\2\xff", 4);
  const Reply kept = upload("data/dem.tif", bytes);
  EXPECT_EQ(kept.status, 201);
  EXPECT_EQ(read("data/dem.tif"), bytes);
  EXPECT_EQ(upload("data/dem.tif", "other").status, 409);
  EXPECT_EQ(read("data/dem.tif"), bytes);
  EXPECT_EQ(upload("data/dem.tif?replace=1", "other").status, 201);
  EXPECT_EQ(read("data/dem.tif"), "other");
  const Json files = get("/api/files").json()["files"];
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0]["name"], "data/dem.tif");
  EXPECT_EQ(files[0]["bytes"], 5);
  EXPECT_EQ(files[0]["kind"], "raster");
}

TEST_F(Place, ListsTheKindOfEachFile) {
  const std::map<std::string, std::string> kinds{{"a.flt", "raster"},  {"b.ply", "mesh"},   {"c.DAT", "points"},
                                                 {"d.las", "points"},  {"e.dxf", "vector"}, {"f.dem", "other"},
                                                 {"g.toml", "project"}};
  for (const auto& [name, kind] : kinds) upload(name, "x");
  std::map<std::string, std::string> listed;
  const Json files = get("/api/files").json()["files"];
  for (const Json& file : files) listed[file["name"].get<std::string>()] = file["kind"].get<std::string>();
  EXPECT_EQ(listed, kinds);
}

TEST_F(Place, DoesNotMixUploadsOfTheSameName) {
  constexpr std::size_t half = 20'000;
  const auto begin = [&](char letter) {
    auto upload = std::make_unique<testing_tools::RawConnection>(port_);
    upload->send("PUT /api/files/x.csv?replace=1 HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) +
                 "\r\nCookie: " + cookie_ + "\r\nContent-Type: application/octet-stream\r\nContent-Length: " +
                 std::to_string(2 * half) + "\r\n\r\n" + std::string(half, letter));
    return upload;
  };
  const auto first = begin('A');
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const auto second = begin('B');
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  first->send(std::string(half, 'A'));
  EXPECT_EQ(first->status(), 201);
  EXPECT_EQ(read("x.csv"), std::string(2 * half, 'A'));
  second->send(std::string(half, 'B'));
  EXPECT_EQ(second->status(), 201);
  EXPECT_EQ(read("x.csv"), std::string(2 * half, 'B'));
  EXPECT_EQ(std::distance(fs::directory_iterator(path("")), fs::directory_iterator()), 1);
}

TEST_F(Place, RefusesFilesThatAreTooLarge) {
  EXPECT_EQ(upload("all.csv", std::string(65536, '1')).status, 201);
  EXPECT_EQ(upload("more.csv", std::string(65537, '1')).status, 413);
  EXPECT_FALSE(fs::exists(path("more.csv")));
  EXPECT_EQ(get("/api/files").json()["files"].size(), 1U);  // no partial file either
}

TEST_F(Place, WritesAProjectOnlyIfItIsUnchanged) {
  const auto saved = [&](const std::string& text, const Json& hash) {
    return put("/api/project", {{"file", "a.toml"}, {"text", text}, {"saved", hash}});
  };
  const Reply first = saved("one", nullptr);
  EXPECT_EQ(first.status, 200);
  EXPECT_EQ(read("a.toml"), "one");
  EXPECT_EQ(saved("two", nullptr).status, 409);
  EXPECT_EQ(saved("two", "0123").status, 409);
  EXPECT_EQ(saved("two", first.json()["saved"]).status, 200);
  write("a.toml", "by another program");
  EXPECT_EQ(saved("three", first.json()["saved"]).problem(),
            "a.toml: was changed by another program meanwhile. Read it again, or save under another name");
  EXPECT_EQ(read("a.toml"), "by another program");
  EXPECT_EQ(get("/api/project?file=a.toml").json()["text"], "by another program");
  EXPECT_EQ(get("/api/project?file=b.toml").status, 404);
  EXPECT_EQ(get("/api/project?file=a.csv").status, 400);
}

TEST_F(Place, SavesADraftNextToTheProject) {
  write("a.toml", "saved");
  EXPECT_EQ(put("/api/draft", {{"file", "a.toml"}, {"text", "drafted"}}).status, 200);
  Json project = get("/api/project?file=a.toml").json();
  EXPECT_EQ(project["text"], "saved");
  EXPECT_EQ(project["draft"]["text"], "drafted");
  EXPECT_EQ(get("/api/files").json()["files"].size(), 1U);
  EXPECT_EQ(put("/api/project", {{"file", "a.toml"}, {"text", "drafted"}, {"saved", project["saved"]}}).status, 200);
  project = get("/api/project?file=a.toml").json();
  EXPECT_EQ(project["text"], "drafted");
  EXPECT_TRUE(project["draft"].is_null());
  EXPECT_EQ(put("/api/draft", {{"file", "a.toml"}, {"text", "again"}}).status, 200);
  EXPECT_EQ(put("/api/draft", {{"file", "a.toml"}, {"text", nullptr}}).status, 200);
  EXPECT_TRUE(get("/api/project?file=a.toml").json()["draft"].is_null());
  EXPECT_EQ(put("/api/draft", {{"file", "a.toml"}, {"text", "drafted"}}).status, 200);
  EXPECT_FALSE(fs::exists(path(".a.toml.draft"))) << "a draft equal to the file is not saved";
}

TEST_F(Place, StoresTheChecksumOfADraftsFile) {
  write("a.toml", "one");
  const Json one = get("/api/project?file=a.toml").json()["saved"];
  const auto draft = [&] { return get("/api/project?file=a.toml").json()["draft"]; };
  put("/api/draft", {{"file", "a.toml"}, {"text", "\xef\xbb\xbfname = \"ü\"\r\n\n"}, {"saved", one}});
  write("a.toml", "two");
  EXPECT_EQ(draft(), Json({{"text", "\xef\xbb\xbfname = \"ü\"\r\n\n"}, {"saved", one}, {"revisions", Json::array()}}));
  EXPECT_EQ(read(".a.toml.draft"),
            "# A draft of the file with the checksum " + one.get<std::string>() + "\n\xef\xbb\xbfname = \"ü\"\r\n\n");
  EXPECT_EQ(put("/api/project", {{"file", "a.toml"}, {"text", "three"}, {"saved", draft()["saved"]}}).status, 409);
  EXPECT_EQ(read("a.toml"), "two");
  put("/api/draft", {{"file", "a.toml"}, {"text", "new"}, {"saved", nullptr}});
  EXPECT_EQ(draft(), Json({{"text", "new"}, {"saved", nullptr}, {"revisions", Json::array()}}));
}

class Drafts : public Place {
 protected:
  Drafts() { write("a.toml", "saved"); }

  /// Sends a draft as `revision`, made from revision `after`.
  Reply save(const Json& text, const std::string& revision, const Json& after) const {
    return put("/api/draft", {{"file", "a.toml"}, {"text", text}, {"revision", revision}, {"after", after}});
  }
  [[nodiscard]] Json saved() const { return get("/api/project?file=a.toml").json()["draft"]; }
};

TEST_F(Drafts, AreReplacedOnlyByTheirContinuations) {
  EXPECT_EQ(save("one", "a.1", nullptr).status, 200);
  EXPECT_EQ(save("two", "a.2", "a.1").status, 200);
  EXPECT_EQ(save("three", "b.1", "a.2").status, 200) << "another tab continues the draft";
  const Reply refused = save("four", "a.3", "a.2");
  EXPECT_EQ(refused.status, 409);
  EXPECT_EQ(refused.problem(), "a.toml: has another draft (it was changed in another tab or browser meanwhile)");
  EXPECT_EQ(save("five", "c.1", nullptr).status, 409) << "this tab never read the draft";
  EXPECT_EQ(save(nullptr, "a.3", "a.2").status, 409) << "an older revision cannot remove it";
  EXPECT_EQ(saved(), Json({{"text", "three"}, {"saved", nullptr}, {"revisions", {"a.2", "b.1"}}}));
  EXPECT_EQ(save("six", "b.3", "b.2").status, 200) << "b.2 has not arrived";
  EXPECT_EQ(save("late", "b.2", "b.1").status, 409) << "b.2 arrives after b.3";
  EXPECT_EQ(save(nullptr, "b.4", "b.3").status, 200);
  EXPECT_TRUE(saved().is_null());
}

TEST_F(Drafts, OfOtherTabsSurviveSavingTheProject) {
  const Json hash = get("/api/project?file=a.toml").json()["saved"];
  (void)save("one", "a.1", nullptr);
  (void)save("two", "b.1", "a.1");
  const auto save_project = [&](const char* text, const Json& saved, const char* revision, const char* after) {
    return put("/api/project",
               {{"file", "a.toml"}, {"text", text}, {"saved", saved}, {"revision", revision}, {"after", after}});
  };
  const Reply older = save_project("one", hash, "a.2", "a.1");
  EXPECT_EQ(older.status, 200);
  EXPECT_EQ(saved()["text"], "two");
  EXPECT_EQ(save_project("two and more", older.json()["saved"], "b.2", "b.1").status, 200);
  EXPECT_TRUE(saved().is_null());
}

TEST_F(Drafts, RequireValidRevisions) {
  for (const char* wrong : {"a", "a.", ".1", "a b.1", "a.1x", "a.-1"}) {
    const Reply refused = save("one", wrong, nullptr);
    EXPECT_EQ(refused.status, 400) << wrong;
    EXPECT_EQ(refused.problem(), "revision: is not a revision of a draft (expected for example 3f9a.12)");
  }
}

TEST_F(Place, RefusesAProjectThatIsNotUtf8) {
  const std::string latin = "# Talus\nname = \"Gel\xe4nde\"\n";
  write("a.toml", latin);
  const std::string why =
      "a.toml:2: cannot be shown as text (it has bytes that are not UTF-8, which saving it here would lose). Save it "
      "as UTF-8";
  const Reply asked = get("/api/project?file=a.toml");
  EXPECT_EQ(asked.status, 422);
  EXPECT_EQ(asked.problem(), why);
  for (const Json& saved : {Json(), Json("0123")}) {
    const Reply refused = put("/api/project", {{"file", "a.toml"}, {"text", "name = \"\""}, {"saved", saved}});
    EXPECT_EQ(refused.status, 422);
    EXPECT_EQ(refused.problem(), why);
  }
  EXPECT_EQ(read("a.toml"), latin);
  write("a.toml", "name = \"Gelände\"\n");
  EXPECT_EQ(get("/api/project?file=a.toml").json()["text"], "name = \"Gelände\"\n");
}

TEST_F(Place, RefusesPagesOfOtherFolders) {
  const auto identity = [&] { return get("/api/about").json()["workplace"].get<std::string>(); };
  const std::string here = identity();
  EXPECT_EQ(here, identity());
  const auto put_from = [&](const char* what, const std::string& workplace) {
    return put(what, {{"file", "a.toml"}, {"text", "mine"}, {"saved", nullptr}, {"workplace", workplace}});
  };
  for (const char* what : {"/api/draft", "/api/project"}) {
    const Reply refused = put_from(what, "another");
    EXPECT_EQ(refused.status, 410);
    EXPECT_EQ(refused.problem(), "a.toml: belongs to another folder (the server now works in " +
                                     fs::canonical(path("")).string() +
                                     "). To continue on this page, serve the project's folder on this port again");
    EXPECT_TRUE(fs::is_empty(path("")));
  }
  EXPECT_EQ(put_from("/api/draft", here).status, 200);
  EXPECT_EQ(put_from("/api/project", here).status, 200);

  stop();
  fs::rename(path(""), base_ / "moved");  // not removed, so that its inode number is not used again
  fs::create_directory(path(""));
  start();
  EXPECT_NE(identity(), here);
}

TEST_F(Place, ReportsProblemsWithoutCommandLineOptions) {
  fs::create_directories(path("a.toml.part"));
  const Reply refused = put("/api/project", {{"file", "a.toml"}, {"text", "one"}, {"saved", nullptr}});
  EXPECT_EQ(refused.status, 422);
  const Json problem = refused.json()["problems"][0];
  EXPECT_EQ(problem["hint"], "Choose another folder");
  EXPECT_EQ(problem["text"].get<std::string>().find("-o"), std::string::npos);
}

TEST_F(Place, WritesThroughALinkAndKeepsTheMode) {
  write("sub/real.toml", "one");
  constexpr auto mode = static_cast<fs::perms>(0664);
  fs::permissions(path("sub/real.toml"), mode);
  fs::create_symlink("sub/real.toml", path("a.toml"));
  const Json saved = get("/api/project?file=a.toml").json()["saved"];
  EXPECT_EQ(put("/api/project", {{"file", "a.toml"}, {"text", "two"}, {"saved", saved}}).status, 200);
  EXPECT_TRUE(fs::is_symlink(path("a.toml")));
  EXPECT_EQ(read("sub/real.toml"), "two");
  EXPECT_EQ(fs::status(path("sub/real.toml")).permissions(), mode);
}

TEST_F(Place, WritesNothingThroughALinkThatLeadsOut) {
  fs::create_symlink(base_ / "outside" / "new.toml", path("a.toml"));  // the target does not exist yet
  fs::create_symlink("../outside/new.toml", path("b.toml"));
  fs::create_symlink("a.toml", path("c.toml"));
  for (const std::string name : {"a.toml", "b.toml", "c.toml"}) {
    const Reply refused = put("/api/project", {{"file", name}, {"text", "mine"}, {"saved", nullptr}});
    EXPECT_EQ(refused.status, 403);
    EXPECT_EQ(refused.problem(), name + ": cannot be written (it leads out of the folder)");
    EXPECT_TRUE(fs::is_symlink(path(name)));
  }
  EXPECT_FALSE(fs::exists(base_ / "outside" / "new.toml"));
}

TEST_F(Place, CopiesExamplesWithoutReplacingFiles) {
  const Json examples = get("/api/examples").json()["examples"];
  ASSERT_FALSE(examples.empty());
  for (const Json& example : examples) {
    const Reply copied = post("/api/examples/" + example["id"].get<std::string>(), Json::object());
    EXPECT_EQ(copied.status, 200);
    EXPECT_EQ(copied.json()["project"], example["file"]);
    const std::string name = example["file"];
    ASSERT_TRUE(fs::exists(path(name))) << name;
    const Reply model = post("/api/model", {{"file", name}, {"text", read(name)}});
    EXPECT_FALSE(model.json()["model"].is_null()) << model.body;
  }
  const std::string name = examples[0]["file"];
  write(name, "mine");
  EXPECT_EQ(post("/api/examples/" + examples[0]["id"].get<std::string>(), Json::object()).status, 200);
  EXPECT_EQ(read(name), "mine");
  EXPECT_EQ(post("/api/examples/none", Json::object()).status, 404);
}

}  // namespace
}  // namespace talus
