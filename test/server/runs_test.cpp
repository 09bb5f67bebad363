// Runs of the server: thrown, stopped, gone on with, found again, and the same bytes as those of `talus run`.

#include "server/served_runs.hpp"

#include <gmock/gmock.h>

#include <array>

#include "cli/child.hpp"
#include "cli/run_files.hpp"
#include "run_store.hpp"
#include "support/endless_slope.hpp"
#include "support/listener.hpp"
#include "talus/files/folder_lock.hpp"

namespace talus {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

class Runs : public ServedRuns {
 protected:
  /// What `talus run` writes of the same project.
  [[nodiscard]] std::map<std::string, std::string> files_of_program(const std::string& text,
                                                                    const std::string& more = "") const {
    write("slope.toml", text);
    const test::Said said =
        test::talus_says("run " + path("slope.toml").string() + " --quiet -o " + (base_ / "expected").string() + more);
    EXPECT_EQ(said.exit_code, 0) << said.text;
    return test::files_of(base_ / "expected");
  }
  /// What lies in a run's folder, less what the server adds.
  [[nodiscard]] std::map<std::string, std::string> files_of(const std::string& id) const {
    auto files = test::files_of(folder_of(id));
    EXPECT_EQ(files.erase("run.json") + files.erase("project.toml"), 2U);
    return files;
  }
};

TEST_F(Runs, WriteTheBytesOfTheProgram) {
  const test::Workplace work;
  const std::string text = text_of(test::write_slope_with_barrier(work));
  const std::string id = begin(text, {{"name", "First try"}});
  const Json run = wait_for(id, "done");
  EXPECT_EQ(run["name"], "First try");
  EXPECT_EQ(run["file"], "slope.toml");
  EXPECT_EQ(run["dimension"], 3);
  EXPECT_EQ(run["rocks"], 75);
  EXPECT_EQ(run["done"], 75);
  EXPECT_GT(run["rate"], 0);
  EXPECT_TRUE(run["seconds_left"].is_null());
  EXPECT_EQ(run["folder"], "runs/slope/" + id);
  EXPECT_EQ(read("runs/slope/" + id + "/project.toml"), text);
  EXPECT_EQ(test::differences(files_of(id), files_of_program(text)), "");
  EXPECT_EQ(test::bytes_of(folder_of(id) / "summary.json"), get("/api/runs/" + id + "/summary").body);
}

TEST_F(Runs, TakeRocksAndSeedOfTheirOwn) {
  const std::string id = begin(section(), {{"rocks", 30}, {"seed", 9223372036854775807U}});
  EXPECT_EQ(wait_for(id, "done")["done"], 30);
  EXPECT_EQ(test::differences(files_of(id), files_of_program(section(), " --rocks 30 --seed 9223372036854775807")), "");
}

TEST_F(Runs, OfAProjectWithErrorsAreRefused) {
  const Reply reply = post("/api/runs", {{"file", "slope.toml"}, {"text", section() + "nonsense = 1\n"}});
  EXPECT_EQ(reply.status, 422);
  const Json problem = reply.json()["problems"][0];
  EXPECT_EQ(problem["file"], "slope.toml");
  EXPECT_EQ(problem["line"], 52);
  EXPECT_THAT(problem["what"].get<std::string>(), HasSubstr("nonsense"));
  EXPECT_TRUE(list().empty());
  EXPECT_FALSE(std::filesystem::exists(path("runs")));
  const Json text = section();
  for (const Json& body :
       {Json{{"text", text}}, Json{{"file", "slope.toml"}}, Json{{"file", "slope.toml"}, {"text", text}, {"rocks", -1}},
        Json{{"file", "slope.toml"}, {"text", text}, {"rocks", 1.5}},
        Json{{"file", "slope.toml"}, {"text", text}, {"seed", "1"}},
        Json{{"file", "slope.toml"}, {"text", text}, {"name", "a\nb"}},
        Json{{"file", "slope.toml"}, {"text", text}, {"name", std::string(300, 'x')}},
        Json{{"file", "slope.csv"}, {"text", text}}, Json{{"filee", "x"}}})
    EXPECT_EQ(post("/api/runs", body).status, 400) << body.dump();
  EXPECT_EQ(post("/api/runs", {{"file", "../slope.toml"}, {"text", text}}).status, 403);
  EXPECT_TRUE(list().empty());
}

TEST_F(Runs, ThatAreStoppedKeepWhatIsDoneAndGoOnToTheSameBytes) {
  const std::string id = begin(section(), {{"rocks", 60'000}});
  (void)wait_for_rocks(id);
  EXPECT_EQ(ask(id, "stop").status, 200);
  const Json stopped = wait_for(id, "stopped");
  ASSERT_EQ(stopped["state"], "stopped") << stopped.dump();
  const std::uint64_t done = stopped["done"];
  ASSERT_TRUE(done > 0 && done < 60'000) << done;
  const Json summary = get("/api/runs/" + id + "/summary").json();
  EXPECT_EQ(summary["rocks"]["done"], done);
  EXPECT_EQ(summary["interrupted"], true);
  EXPECT_EQ(get("/api/runs/" + id + "/statistics?of=x_m").json()["count"], done);
  EXPECT_EQ(ask(id, "stop").status, 409);

  EXPECT_EQ(ask(id, "resume").status, 202);
  EXPECT_EQ(wait_for(id, "done")["done"], 60'000);
  EXPECT_EQ(test::differences(files_of(id), files_of_program(section(), " --rocks 60000")), "");
  EXPECT_EQ(ask(id, "resume").status, 409);
}

TEST_F(Runs, WaitForEachOther) {
  const std::string first = begin(section(), {{"rocks", 3'000'000}}), second = begin(section()),
                    third = begin(section());
  (void)wait_for_rocks(first);
  EXPECT_EQ(run(first)["has_results"], false);
  EXPECT_EQ(run(second)["state"], "waiting");
  EXPECT_EQ(run(second)["has_results"], false);
  EXPECT_EQ(get("/api/runs/" + second + "/summary").status, 404);
  EXPECT_EQ(get("/api/runs/" + first + "/paths").status, 404);
  EXPECT_EQ(ask(third, "stop").json()["state"], "stopped");
  // Newest first.
  const Json all = list();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0]["id"], third);
  EXPECT_EQ(all[2]["id"], first);
  (void)ask(first, "stop");
  EXPECT_EQ(wait_for(second, "done")["done"], 50);
  EXPECT_EQ(run(second)["has_results"], true);
  EXPECT_EQ(run(third)["done"], 0);
  EXPECT_EQ(run(third)["has_results"], false);
  EXPECT_EQ(get("/api/runs/" + third + "/summary").status, 404);
  EXPECT_EQ(ask(third, "resume").status, 202);
  EXPECT_EQ(wait_for(third, "done")["done"], 50);
  EXPECT_EQ(test::differences(files_of(third), files_of(second)), "");
}

TEST_F(Runs, AreRemovedWithTheirFolderButNotUnderWay) {
  const std::string first = begin(section(), {{"rocks", 3'000'000}}), second = begin(section());
  (void)wait_for_rocks(first);
  const std::string folder = run(first)["folder"];
  const Reply refused = send("DELETE", "/api/runs/" + first);
  EXPECT_EQ(refused.status, 409);
  EXPECT_EQ(refused.problem(), first + ": cannot be removed (it is under way). Stop it first");
  EXPECT_EQ(send("DELETE", "/api/runs/" + second).status, 200);  // it waits
  EXPECT_EQ(get("/api/runs/" + second).status, 404);
  (void)ask(first, "stop");
  (void)wait_for(first, "stopped");
  while (send("DELETE", "/api/runs/" + first).status == 409) std::this_thread::yield();
  EXPECT_FALSE(std::filesystem::exists(path(folder)));
  EXPECT_FALSE(std::filesystem::exists(path("runs"))) << "an empty folder is left";
  EXPECT_TRUE(list().empty());
}

TEST_F(Runs, ThatCannotBeRemovedStayAsTheyAre) {
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

TEST_F(Runs, OfWhichAPartCannotBeRemovedAreGone) {
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

/// A store of the served folder, beside that of the server.
struct Store {
  explicit Store(const std::filesystem::path& folder) : workplace(folder) {}

  server::Workplace workplace;
  server::EventHub events;
  server::ModelReading reading{std::chrono::minutes(1)};
  server::RunStore runs{workplace, events, reading};
};

TEST_F(Runs, BeginAndGoOnOnlyUntilTheServerEnds) {
  const std::string id = begin(section(), {{"rocks", 3'000'000}});
  (void)wait_for_rocks(id);
  (void)ask(id, "stop");
  (void)wait_for(id, "stopped");
  Store store(path(""));
  store.runs.close();
  const auto refusal = [&](const std::function<void()>& ask) -> std::string {
    try {
      ask();
    } catch (const server::Refusal& refused) {
      EXPECT_EQ(refused.status(), 503);
      return refused.what();
    }
    return "is taken";
  };
  EXPECT_EQ(refusal([&] { store.runs.begin({.file = file_, .text = section()}); }),
            "slope.toml: cannot be run (the server is ending)");
  EXPECT_EQ(refusal([&] { store.runs.resume(id); }), id + ": cannot go on (the server is ending)");
  EXPECT_EQ(store.runs.list().size(), 1U);
  stop();
  start();
  EXPECT_EQ(list().size(), 1U);
  EXPECT_EQ(run(id)["state"], "stopped");
}

TEST_F(Runs, AreStoppedInTheMiddleOfALongRock) {
  const std::string id = begin(testing_tools::endless_slope(17'000, 5));
  (void)wait(id, [](const Json& now) { return now["done"] > 16'700; });  // the last block has some of the long ones
  const auto asked = std::chrono::steady_clock::now();
  EXPECT_EQ(ask(id, "stop").status, 200);
  EXPECT_EQ(wait_for(id, "stopped")["done"], 17'000);
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::minutes(1));
  (void)wait(id, [](const Json& now) { return now["has_results"] == true; });
  EXPECT_EQ(get("/api/runs/" + id + "/summary").json()["rocks"]["done"], 17'000);
}

TEST_F(Runs, AreFoundAgainWhereverFilesAreListed) {
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

TEST_F(Runs, AreFoundAgainByTheNextServer) {
  file_ = "valley/west/slope.toml";
  const std::string done = begin(section(), {{"name", "Done"}});
  (void)wait_for(done, "done");
  const std::string under_way = begin(section(), {{"rocks", 3'000'000}}), waiting = begin(section());
  (void)wait_for_rocks(under_way);
  const Json before = run(done);
  stop();  // stops what is under way, too
  start();
  EXPECT_EQ(run(done), before);
  EXPECT_EQ(run(under_way)["state"], "stopped");
  EXPECT_GT(run(under_way)["done"], 0);
  EXPECT_EQ(run(under_way)["file"], "valley/west/slope.toml");
  EXPECT_EQ(run(waiting)["state"], "stopped");
  EXPECT_EQ(ask(waiting, "resume").status, 202);
  EXPECT_EQ(wait_for(waiting, "done")["done"], 50);
}

/// The address that a server in another process prints.
std::string address_in(const std::filesystem::path& said) {
  for (int k = 0; k < 2000; ++k, std::this_thread::sleep_for(std::chrono::milliseconds(5))) {
    std::ifstream in(said);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t begin = text.find("http://"), end = text.find('\n', begin);
    if (begin != std::string::npos && end != std::string::npos) return text.substr(begin, end - begin);
  }
  ADD_FAILURE() << "no address";
  return "";
}

TEST_F(Runs, OfAServerThatWasKilledGoOnToTheSameBytes) {
  stop();  // another server does the work
  const std::filesystem::path said = base_ / "said.txt";
  test::Child other({"serve", path("").string(), "--port", "0"}, said);
  const std::string address = address_in(said);
  const std::size_t slash = address.find("/?");
  port_ = std::stoi(address.substr(address.rfind(':') + 1));
  httplib::Client first("127.0.0.1", port_);
  const auto answer = first.Get(address.substr(slash));
  ASSERT_TRUE(answer);
  cookie_ = answer->get_header_value("Set-Cookie");
  cookie_ = cookie_.substr(0, cookie_.find(';'));

  const std::string id = begin(section(), {{"rocks", 60'000}}), waiting = begin(section());
  (void)wait_for_rocks(id);
  (void)ask(id, "stop");  // so that there is a state to go on from
  const std::uint64_t at_stop = wait_for(id, "stopped")["done"];
  (void)wait_for(waiting, "done");
  (void)ask(id, "resume");
  (void)wait(id, [&](const Json& now) { return now["done"] > at_stop; });
  other.signal(SIGKILL);
  (void)other.wait();

  start();
  const Json killed = run(id);
  EXPECT_EQ(killed["state"], "interrupted");
  EXPECT_GE(killed["done"], at_stop);
  // Nothing is done with it until somebody asks.
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(run(id)["has_results"], false);
  EXPECT_EQ(get("/api/runs/" + id + "/summary").status, 404);
  EXPECT_EQ(ask(id, "write").status, 202);
  Reply summary;
  for (int k = 0; k < 2000 && summary.status != 200; ++k) {
    summary = get("/api/runs/" + id + "/summary");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_EQ(summary.status, 200) << summary.body;
  EXPECT_EQ(summary.json()["rocks"]["done"], killed["done"]);
  EXPECT_EQ(get("/api/runs/" + id + "/statistics?of=x_m").json()["count"], killed["done"]);
  EXPECT_EQ(run(id)["state"], "interrupted");
  EXPECT_EQ(run(id)["has_results"], true);
  EXPECT_EQ(ask(id, "resume").status, 202);
  EXPECT_EQ(wait_for(id, "done")["done"], 60'000);
  EXPECT_EQ(test::differences(files_of(id), files_of_program(section(), " --rocks 60000")), "");
}

TEST_F(Runs, KeepTheirResultsWhereTheyCannotGoOn) {
  const std::string id = begin(section(), {{"rocks", 60'000}});
  (void)wait_for_rocks(id);
  (void)ask(id, "stop");
  const Json stopped = wait_for(id, "stopped");
  const std::string project = stopped["folder"].get<std::string>() + "/project.toml", text = read(project);
  for (const std::string& other : {text + "[[broken\n", text + "[sampling]\nseed = 99\n"}) {
    write(project, other);
    EXPECT_EQ(ask(id, "resume").status, 202);
    const Json refused = wait(id, [](const Json& now) { return !now["problems"].empty(); });
    EXPECT_EQ(refused["state"], "stopped");
    EXPECT_EQ(refused["done"], stopped["done"]);
    EXPECT_EQ(get("/api/runs/" + id + "/summary").json()["rocks"]["done"], stopped["done"]);
  }
  write(project, text);
  EXPECT_EQ(ask(id, "resume").status, 202);
  const Json done = wait_for(id, "done");
  EXPECT_THAT(done["problems"].dump(), Not(HasSubstr("error"))) << "of the times that it was refused";
}

TEST_F(Runs, HaveNamesThatAreShownAsTheyAre) {
  const std::string name = "<img src=x onerror=alert(1)> & \"Hühner\"";
  const std::string id = begin(section(), {{"name", name}});
  (void)wait_for(id, "done");
  EXPECT_EQ(run(id)["name"], name);
  const std::string other = "</script>'; DROP TABLE";
  EXPECT_EQ(with_json("PATCH", "/api/runs/" + id, {{"name", other}}).json()["name"], other);
  for (const char* bad : {"", "a\x01", "\x7f"})
    EXPECT_EQ(with_json("PATCH", "/api/runs/" + id, {{"name", bad}}).status, 400);
  stop();
  start();
  EXPECT_EQ(run(id)["name"], other);
}

TEST_F(Runs, OfForeignNamesThereAreNone) {
  const std::string id = begin(section());
  (void)wait_for(id, "done");
  for (const std::string& other : {std::string("nothing"), id + "x", std::string(".."), std::string("%2e%2e"),
                                   std::string("..%2fslope"), std::string("slope%2f") + id, std::string("%00")}) {
    for (const char* what : {"", "/summary", "/files", "/paths", "/endpoints", "/rocks/0", "/statistics?of=x_m",
                             "/barriers", "/barriers/0/statistics?of=time_s", "/maps", "/maps/passages"})
      EXPECT_EQ(get("/api/runs/" + other + what).status, 404) << other << what;
    EXPECT_EQ(ask(other, "stop").status, 404);
    EXPECT_EQ(ask(other, "resume").status, 404);
    EXPECT_EQ(send("DELETE", "/api/runs/" + other).status, 404);
    EXPECT_EQ(get("/api/runs/" + id + "/differences/" + other).status, 404);
  }
}

TEST_F(Runs, WhoseFolderIsDamagedAreListedWithTheReasons) {
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

TEST_F(Runs, WhoseResultsAreDamagedSayWhatIsWrong) {
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
  EXPECT_EQ(get("/api/runs/" + id + "/paths").problem(),
            path(folder + "paths.csv").string() +
                ": has other rocks than endpoints.csv (rocks are missing in one of the two)");
  write(folder + "endpoints.csv", read(folder + "endpoints.csv") + "50,cut");
  EXPECT_EQ(get("/api/runs/" + id + "/endpoints").status, 422);
  EXPECT_THAT(get("/api/runs/" + id + "/statistics?of=x_m").problem(), HasSubstr("the last line has no line end"));
  write(folder + "summary.json", "{\"rocks\": 3}");
  for (const char* what : {"/paths", "/endpoints", "/statistics?of=x_m", "/barriers"})
    EXPECT_EQ(get("/api/runs/" + id + what).status, 422) << what;
  std::filesystem::remove(path(folder + "summary.json"));
  EXPECT_EQ(get("/api/runs/" + id + "/paths").status, 404);
}

// A folder may come from anybody: a run in it that says that it is under way is no reason to open what it names.
TEST_F(Runs, OfAFolderThatCameFromElsewhereAreLeftAloneUntilSomebodyAsks) {
  const std::string id = begin(section());
  (void)wait_for(id, "done");
  stop();
  const testing_tools::Listener listener;
  const std::string folder = "runs/slope/" + id + "/";
  Json file = Json::parse(read(folder + "run.json"));
  file["state"] = "running";
  write(folder + "run.json", file.dump());
  std::string project = test::bytes_of(TALUS_SOURCE_DIR "/examples/maungawhau/maungawhau.toml");
  const std::string raster = "maungawhau.asc";
  write(folder + "project.toml",
        project.replace(project.rfind(raster), raster.size(), "/vsicurl/" + listener.address() + "/dem.asc"));
  const std::string summary = read(folder + "summary.json");
  start();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const Json waits = run(id);
  EXPECT_EQ(waits["state"], "interrupted");
  EXPECT_EQ(waits["problems"], file["problems"]);
  EXPECT_EQ(read(folder + "summary.json"), summary);
  EXPECT_EQ(ask(id, "write").status, 202);
  (void)wait(id, [&](const Json& now) { return now["problems"].size() > waits["problems"].size(); });
  EXPECT_FALSE(listener.has_heard());
}

// Two servers in one folder: the second leaves alone what the first throws.
TEST_F(Runs, OfAnotherServerAreLeftAlone) {
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
  EXPECT_EQ(run(id)["state"], "interrupted") << "it is gone";
  EXPECT_EQ(ask(id, "resume").status, 202);
  EXPECT_EQ(wait_for(id, "done")["done"], 50);
}

TEST_F(Runs, SayInWhatTheyDiffer) {
  const std::string text = section();
  const std::string changed = std::string(text).replace(text.find("mean = 0.5"), 10, "mean = 0.6");
  const std::string here = begin(text), there = begin(changed, {{"seed", 7}});
  const Json differences = get("/api/runs/" + here + "/differences/" + there).json()["differences"];
  ASSERT_EQ(differences.size(), 2U) << differences.dump();
  EXPECT_EQ(differences[0].dump(), R"({"key":"sampling.seed","here":1,"there":7})");
  EXPECT_EQ(differences[1].dump(), R"({"key":"material.Type One.normal_restitution.mean","here":0.5,"there":0.6})");
  EXPECT_TRUE(get("/api/runs/" + here + "/differences/" + here).json()["differences"].empty());
}

}  // namespace
}  // namespace talus
