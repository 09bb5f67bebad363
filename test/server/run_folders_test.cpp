// The folders of runs: found again by the next server, removed, damaged, or used by another program.

#include "server/served_runs.hpp"

#include <gmock/gmock.h>

#include "support/listener.hpp"
#include "support/places.hpp"
#include "talus/files/folder_lock.hpp"

namespace talus {
namespace {

using testing::HasSubstr;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

using RunFolders = ServedRuns;

TEST_F(RunFolders, AreRemovedUnlessTheirRunIsInProgress) {
  const std::string first = begin(section(), {{"rocks", 3'000'000}}), second = begin(section());
  (void)wait_for_rocks(first);
  const std::string folder = run(first)["folder"];
  const Reply refused = send("DELETE", "/api/runs/" + first);
  EXPECT_EQ(refused.status, 409);
  EXPECT_EQ(refused.problem(), first + ": cannot be removed (it is running). Stop it first");
  EXPECT_EQ(send("DELETE", "/api/runs/" + second).status, 200);  // it is waiting
  EXPECT_EQ(get("/api/runs/" + second).status, 404);
  (void)ask(first, "stop");
  (void)wait_for(first, "stopped");
  while (send("DELETE", "/api/runs/" + first).status == 409) std::this_thread::yield();
  EXPECT_FALSE(std::filesystem::exists(path(folder)));
  EXPECT_FALSE(std::filesystem::exists(path("runs"))) << "an empty folder is left";
  EXPECT_TRUE(list().empty());
}

TEST_F(RunFolders, ThatCannotBeRemovedAreUnchanged) {
  const std::string first = begin(section(), {{"rocks", 3'000'000}}), second = begin(section());
  (void)wait_for_rocks(first);
  const std::filesystem::path file = folder_of(second) / "run.json";
  std::filesystem::remove(file);
  std::filesystem::create_directories(file / "in the way");
  const Reply refused = send("DELETE", "/api/runs/" + second);
  EXPECT_EQ(refused.status, 422);
  EXPECT_EQ(refused.problem(), folder_of(second).string() + ": cannot remove this folder (Directory not empty)");
  EXPECT_EQ(run(second)["state"], "waiting");
  std::filesystem::remove_all(file);
  (void)ask(first, "stop");
  EXPECT_EQ(wait_for(second, "done")["done"], 50);
}

TEST_F(RunFolders, ThatAreOnlyPartlyRemovedAreNoLongerListed) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may remove everything";
  const std::string id = begin(section());
  (void)wait_for(id, "done");
  const std::filesystem::path folder = folder_of(id), kept = folder / "kept";
  std::filesystem::create_directories(kept / "below");
  std::filesystem::permissions(kept, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const Reply refused = send("DELETE", "/api/runs/" + id);
  EXPECT_EQ(refused.status, 422);
  EXPECT_EQ(refused.problem(), folder.string() + ": cannot remove all of this folder (Permission denied)");
  EXPECT_EQ(get("/api/runs/" + id).status, 404);
  stop();
  start();
  EXPECT_TRUE(list().empty());
  std::filesystem::permissions(kept, std::filesystem::perms::owner_all);
}

TEST_F(RunFolders, AreFoundWhereverFilesAreListed) {
  std::map<std::string, std::string> files;
  for (const char* file : {"a/b/c/d/slope.toml", "runs/slope.toml", "runs/west/slope.toml", "a/b/c/runs/slope.toml",
                           "runs.toml", "runs/runs.toml"}) {
    file_ = file;
    write(file_, section());
    const std::string id = begin(section());
    (void)wait_for(id, "done");
    files[id] = file;
  }
  stop();
  start();
  EXPECT_EQ(list().size(), files.size());
  const std::string listed = get("/api/files").body;
  for (const auto& [id, file] : files) {
    EXPECT_EQ(run(id)["file"], file);
    EXPECT_THAT(listed, HasSubstr("\"" + file + "\""));
  }
}

TEST_F(RunFolders, AreFoundByTheNextServer) {
  file_ = "valley/west/slope.toml";
  const std::string done = begin(section(), {{"name", "Done"}});
  (void)wait_for(done, "done");
  const std::string running = begin(section(), {{"rocks", 3'000'000}}), waiting = begin(section());
  (void)wait_for_rocks(running);
  const Json before = run(done);
  stop();  // also stops the run in progress
  start();
  EXPECT_EQ(run(done), before);
  EXPECT_EQ(run(running)["state"], "stopped");
  EXPECT_GT(run(running)["done"], 0);
  EXPECT_EQ(run(running)["file"], "valley/west/slope.toml");
  EXPECT_EQ(run(waiting)["state"], "stopped");
  EXPECT_EQ(ask(waiting, "resume").status, 202);
  EXPECT_EQ(wait_for(waiting, "done")["done"], 50);
}

TEST_F(RunFolders, ThatAreDamagedAreListedWithTheReasons) {
  const std::string good = begin(section());
  (void)wait_for(good, "done");
  const std::string whole = read("runs/slope/" + good + "/run.json");
  Json other = Json::parse(whole);
  other["state"] = "dancing";
  Json climbing = Json::parse(whole);
  climbing["file"] = "../../etc/passwd";
  stop();
  write("runs/slope/empty/run.json", "");
  write("runs/slope/list/run.json", "[1]");
  write("runs/slope/deep/run.json", std::string(5000, '[') + std::string(5000, ']'));
  write("runs/slope/half/run.json", whole.substr(0, whole.size() / 2));
  write("runs/slope/state/run.json", other.dump());
  write("runs/slope/climbing/run.json", climbing.dump());
  std::filesystem::create_directories(path("runs/slope/folder/run.json"));
  std::filesystem::create_directories(path("runs/slope/nothing"));
  start();
  ASSERT_EQ(list().size(), 8U);
  EXPECT_EQ(run(good)["state"], "done");
  for (const char* id : {"empty", "list", "deep", "half", "state", "climbing", "folder"}) {
    const Json damaged = run(id);
    EXPECT_EQ(damaged["state"], "failed") << id;
    ASSERT_EQ(damaged["problems"].size(), 1U) << id;
    EXPECT_EQ(ask(id, "resume").status, 409);
    EXPECT_EQ(with_json("PATCH", "/api/runs/" + std::string(id), {{"name", "x"}}).status, 409);
    EXPECT_EQ(get("/api/runs/" + std::string(id) + "/paths").status, 404);
  }
  EXPECT_THAT(run("state")["problems"][0]["what"].get<std::string>(), HasSubstr("\"dancing\" is not a state of a run"));
  EXPECT_EQ(send("DELETE", "/api/runs/empty").status, 200);
  EXPECT_FALSE(std::filesystem::exists(path("runs/slope/empty")));
  EXPECT_EQ(list().size(), 7U);
}

TEST_F(RunFolders, ReportDamagedResults) {
  const std::string id = begin(section());
  (void)wait_for(id, "done");
  const std::string folder = "runs/slope/" + id + "/";
  const std::string hits = read(folder + "barriers.csv"), paths = read(folder + "paths.csv");
  write(folder + "barriers.csv", std::string(hits).insert(hits.find('\n') + 1, "No "));
  for (const char* what : {"/paths", "/endpoints"})
    EXPECT_EQ(get("/api/runs/" + id + what).problem(),
              path(folder + "barriers.csv").string() +
                  ":2: barrier: is not a barrier of this run (summary.json names all of them)");
  write(folder + "barriers.csv", hits);
  const std::size_t last_row = paths.rfind('\n', paths.size() - 2);
  const std::string last_rock = paths.substr(last_row, paths.find(',', last_row) + 1 - last_row);
  write(folder + "paths.csv", paths.substr(0, paths.find(last_rock) + 1));
  EXPECT_EQ(
      get("/api/runs/" + id + "/paths").problem(),
      path(folder + "paths.csv").string() + ": does not match endpoints.csv (rocks are missing in one of the two)");
  write(folder + "endpoints.csv", read(folder + "endpoints.csv") + "50,cut");
  EXPECT_EQ(get("/api/runs/" + id + "/endpoints").status, 422);
  EXPECT_THAT(get("/api/runs/" + id + "/statistics?of=x_m").problem(), HasSubstr("the last line has no line end"));
  write(folder + "summary.json", "{\"rocks\": 3}");
  for (const char* what : {"/paths", "/endpoints", "/statistics?of=x_m", "/barriers"})
    EXPECT_EQ(get("/api/runs/" + id + what).status, 422) << what;
  std::filesystem::remove(path(folder + "summary.json"));
  EXPECT_EQ(get("/api/runs/" + id + "/paths").status, 404);
}

// A folder may come from an untrusted source: its runs must not open files or addresses without a request.
TEST_F(RunFolders, FromElsewhereAreNotOpenedWithoutARequest) {
  const std::string id = begin(section());
  (void)wait_for(id, "done");
  stop();
  const testing_tools::Listener listener;
  const std::string folder = "runs/slope/" + id + "/";
  Json file = Json::parse(read(folder + "run.json"));
  file["state"] = "running";
  write(folder + "run.json", file.dump());
  std::string project = test::bytes_of(talus::places::in_source("/examples/maungawhau/maungawhau.toml"));
  const std::string raster = "maungawhau.asc";
  write(folder + "project.toml",
        project.replace(project.rfind(raster), raster.size(), "/vsicurl/" + listener.address() + "/dem.asc"));
  const std::string summary = read(folder + "summary.json");
  start();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const Json found = run(id);
  EXPECT_EQ(found["state"], "interrupted");
  ASSERT_EQ(found["problems"].size(), file["problems"].size() + 1);
  EXPECT_EQ(
      found["problems"].back()["text"],
      "warning: the server ended while this run was in progress (it was killed, or this run made it fail). Resume "
      "the run. If the server ends again, please report it with the run's folder");
  EXPECT_EQ(read(folder + "summary.json"), summary);
  EXPECT_EQ(ask(id, "write").status, 202);
  (void)wait(id, [&](const Json& now) { return now["problems"].size() > found["problems"].size(); });
  EXPECT_FALSE(listener.was_contacted());
}

// Two servers in one folder: the second does not touch a run of the first.
TEST_F(RunFolders, OfARunningServerAreNotTouchedByAnother) {
  const std::string id = begin(section());
  (void)wait_for(id, "done");
  const std::filesystem::path folder = folder_of(id);
  stop();
  Json file = Json::parse(read("runs/slope/" + id + "/run.json"));
  file["state"] = "running";
  write("runs/slope/" + id + "/run.json", file.dump());
  {
    const auto lock = FolderLock::take(folder);
    ASSERT_TRUE(lock);
    start();
    EXPECT_EQ(run(id)["state"], "running");
    for (const char* what : {"stop", "resume"}) EXPECT_EQ(ask(id, what).status, 409);
    EXPECT_EQ(send("DELETE", "/api/runs/" + id).status, 409);
  }
  EXPECT_EQ(run(id)["state"], "interrupted") << "the other server has ended";
  EXPECT_EQ(ask(id, "resume").status, 202);
  EXPECT_EQ(wait_for(id, "done")["done"], 50);
}

}  // namespace
}  // namespace talus
