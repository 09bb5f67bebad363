// Runs of the server: begun, stopped, resumed, compared; they give the same bytes as `talus run`.

#include "server/served_runs.hpp"

#include <gmock/gmock.h>

#include "support/endless_slope.hpp"

namespace talus {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

using Runs = ServedRuns;

TEST_F(Runs, WriteTheSameBytesAsTheProgram) {
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

TEST_F(Runs, CanOverrideRocksAndSeed) {
  const std::string id = begin(section(), {{"rocks", 30}, {"seed", 9223372036854775807U}});
  EXPECT_EQ(wait_for(id, "done")["done"], 30);
  EXPECT_EQ(test::differences(files_of(id), files_of_program(section(), " --rocks 30 --seed 9223372036854775807")), "");
}

TEST_F(Runs, OfAProjectWithErrorsAreRefused) {
  const Reply reply = post("/api/runs", {{"file", "slope.toml"}, {"text", section() + "nonsense = 1\n"}});
  EXPECT_EQ(reply.status, 422);
  const Json problem = reply.json()["problems"][0];
  EXPECT_EQ(problem["file"], "slope.toml");
  EXPECT_EQ(problem["line"], 53);
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

TEST_F(Runs, ThatAreStoppedKeepTheirResultsAndResumeToTheSameBytes) {
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

TEST_F(Runs, RunOneAfterTheOther) {
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

TEST_F(Runs, CanBeStoppedDuringALongRock) {
  const std::string id = begin(testing_tools::endless_slope(17'000, 5));
  (void)wait(id, [](const Json& now) { return now["done"] > 16'700; });  // the last block contains long rocks
  const auto asked = std::chrono::steady_clock::now();
  EXPECT_EQ(ask(id, "stop").status, 200);
  // Some of the short rocks of that block may be under way.
  const std::uint64_t done = wait_for(id, "stopped")["done"];
  EXPECT_TRUE(done > 16'700 && done <= 17'000) << done;
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::minutes(1));
  (void)wait(id, [](const Json& now) { return now["has_results"] == true; });
  EXPECT_EQ(get("/api/runs/" + id + "/summary").json()["rocks"]["done"], done);
}

TEST_F(Runs, KeepTheirResultsIfTheyCannotBeResumed) {
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
  EXPECT_THAT(done["problems"].dump(), Not(HasSubstr("error"))) << "errors of the refused attempts are dropped";
}

TEST_F(Runs, KeepTheirNamesVerbatim) {
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

TEST_F(Runs, WithUnknownIdsAreNotFound) {
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

TEST_F(Runs, ReportTheirDifferences) {
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
