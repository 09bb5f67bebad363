// Calibrations of the server, and observed rocks beside a model and a run.

#include "server/served_runs.hpp"
#include "support/places.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using testing::HasSubstr;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

class ServedCalibrations : public ServedRuns {
 protected:
  ServedCalibrations() {
    project_ = text_of(example("slope.toml"));
    write("slope.toml", project_);
    write("stops.csv", text_of(example("stops.csv")));
  }
  static std::string example(const std::string& file) {
    return talus::places::in_source("/examples/calibration/") + file;
  }
  static std::string study(const std::string& parameters = "") {
    return "rocks = 40\ndraws = 60\nrounds = 2\n[[site]]\nproject = \"slope.toml\"\n"
           "[[observations]]\nstops = \"stops.csv\"\n"
           "[[parameter]]\npath = \"material.Scree.tangential_restitution\"\nrange = [0.6, 0.95]\n" +
           parameters;
  }
  [[nodiscard]] Reply calibrate(const std::string& text, const Json& more = Json::object()) const {
    Json body{{"file", "slope.study.toml"}, {"text", text}};
    body.update(more);
    return post("/api/calibrations", body);
  }
  std::string project_;
};

TEST_F(ServedCalibrations, AreRunsWithTheResultsOfTheProgram) {
  const Reply reply = calibrate(study());
  ASSERT_EQ(reply.status, 202) << reply.body;
  EXPECT_EQ(reply.json()["kind"], "calibration");
  EXPECT_EQ(reply.json()["study"], "slope.study.toml");
  EXPECT_EQ(reply.json()["rocks"], 60);
  const std::string id = reply.json()["id"];
  const Json run = wait_for(id, "done");
  EXPECT_EQ(run["state"], "done") << run;
  EXPECT_EQ(run["done"], 180) << "further rounds, since the posterior of 60 sets is coarse";
  EXPECT_EQ(run["rocks"], 180);
  EXPECT_EQ(run["file"], "slope.toml");
  EXPECT_TRUE(run["has_results"]);
  EXPECT_EQ(read("slope.study.toml"), study());
  EXPECT_EQ(read("runs/slope/" + id + "/study.toml"), study());

  const test::Said said = test::talus_says("calibrate " + path("slope.study.toml").string() + " --quiet");
  ASSERT_EQ(said.exit_code, 0) << said.text;
  for (const char* file : {"posterior.csv", "sets.csv", "summary.json"})
    EXPECT_EQ(test::bytes_of(folder_of(id) / file), test::bytes_of(path("slope.study") / file)) << file;
}

TEST_F(ServedCalibrations, ShowTheirFigures) {
  const std::string id = calibrate(study()).json()["id"];
  EXPECT_EQ(wait_for(id, "done")["state"], "done");
  const Json summary = get("/api/runs/" + id + "/summary").json();
  const Json& parameter = summary["parameters"][0];
  double prior = 0, posterior = 0;
  for (const double share : parameter["histogram"]["prior"]) prior += share;
  for (const double share : parameter["histogram"]["posterior"]) posterior += share;
  EXPECT_NEAR(prior, 0.998, 1e-9);  // between the prior's 0.1 and 99.9 %
  EXPECT_NEAR(posterior, 1, 1e-9);
  EXPECT_EQ(parameter["histogram"]["edges"].size(), 21U);
  const std::string best = summary["best"]["settings"]["site 1"][0];
  EXPECT_THAT(best, HasSubstr("material.0.tangential_restitution={"));
  const Json& distribution = summary["observations"][0]["features"][0]["distribution"];
  EXPECT_EQ(distribution["observed"].size(), 30U);
  EXPECT_EQ(distribution["posterior"]["low"].back(), 1);
}

TEST_F(ServedCalibrations, CanBeStoppedAndResumed) {
  write("slope.study.toml", "");
  std::string text = study();
  text.replace(text.find("draws = 60"), 10, "draws = 90000");
  const std::string id = calibrate(text, {{"replace", true}}).json()["id"];
  static_cast<void>(wait_for_rocks(id));
  EXPECT_EQ(ask(id, "stop").status, 200);
  const Json stopped = wait_for(id, "stopped");
  EXPECT_FALSE(stopped["has_results"]);
  EXPECT_EQ(ask(id, "resume").status, 202);
  static_cast<void>(wait(id, [](const Json& now) { return now["state"] == "running"; }));
  EXPECT_EQ(ask(id, "stop").status, 200);
  static_cast<void>(wait_for(id, "stopped"));
}

TEST_F(ServedCalibrations, AreRefusedWithTheSettingsAtFault) {
  const auto path_and_text = [](const Reply& reply) {
    EXPECT_EQ(reply.status, 422) << reply.body;
    const Json problem = reply.json()["problems"][0];
    return problem["path"].get<std::string>() + ": " + problem["text"].get<std::string>();
  };
  EXPECT_THAT(path_and_text(calibrate(study("[[parameter]]\npath = \"material.Scree.density\"\nrange = [0, 1]\n"))),
              testing::StartsWith("parameter.1"));
  EXPECT_THAT(
      path_and_text(calibrate(study("[[parameter]]\npath = \"material.Scree.roughness_deg\"\nrange = [3, 1]\n"))),
      testing::StartsWith("parameter.1.range"));
  write("stops.csv", "x_m\n80\nfar\n");
  EXPECT_THAT(path_and_text(calibrate(study())),
              testing::AllOf(testing::StartsWith("observations.0"), HasSubstr("far")));
  EXPECT_TRUE(list().empty());
  EXPECT_FALSE(std::filesystem::exists(path("slope.study.toml")));

  EXPECT_EQ(calibrate(study(), {{"file", "slope.toml"}}).status, 400);
  EXPECT_EQ(calibrate(study(), {{"file", "../slope.study.toml"}}).status, 403);
  EXPECT_EQ(calibrate(study(), {{"replace", 1}}).status, 400);
  std::string elsewhere = study();
  elsewhere.replace(elsewhere.find("slope.toml"), 10, "../x.toml");
  EXPECT_EQ(calibrate(elsewhere).status, 403);
}

TEST_F(ServedCalibrations, DoNotReplaceAStudyUnasked) {
  write("slope.study.toml", "# mine\n");
  EXPECT_EQ(calibrate(study()).status, 409);
  EXPECT_EQ(read("slope.study.toml"), "# mine\n");
  EXPECT_EQ(get("/api/files").json()["files"][0]["kind"], "study") << get("/api/files").body;
}

TEST_F(ServedCalibrations, ObservedStopsAreShownOnTheModel) {
  const Json model = post("/api/model", {{"file", "slope.toml"}, {"text", project_}}).json();
  const std::string of = "/api/models/" + model["model"]["id"].get<std::string>() + "/observed?file=";
  const Json places = get(of + "stops.csv").json()["places"];
  ASSERT_EQ(places.size(), 30U);
  EXPECT_EQ(places[0][0], 70.6);
  EXPECT_NEAR(places[0][2].get<double>(), -55 - 7 * 0.6 / 40, 1e-9);
  write("far.csv", "x_m\n80\n900\n");
  const Reply far = get(of + "far.csv");
  EXPECT_EQ(far.status, 422);
  EXPECT_THAT(far.problem(), testing::AllOf(HasSubstr("far.csv:3"), HasSubstr("900")));
  EXPECT_EQ(get(of + "none.csv").status, 404);
  EXPECT_EQ(get(of + "../stops.csv").status, 403);
}

TEST_F(ServedCalibrations, ObservedStopsAreComparedWithARun) {
  const std::string id = begin(project_);
  EXPECT_EQ(wait_for(id, "done")["state"], "done");
  const Json compared = get("/api/runs/" + id + "/observed?file=stops.csv").json();
  EXPECT_EQ(compared["rocks"], 200);
  const Json& x = compared["quantities"][0];
  EXPECT_EQ(x["key"], "x");
  const test::Said said = test::talus_says("report " + folder_of(id).string() + " --observed " +
                                           path("stops.csv").string() + " -o " + path("report.html").string());
  EXPECT_THAT(said.text,
              HasSubstr(fmt::format("energy distance {:.3g} m", x["energy_distance"]["value"].get<double>())));
  EXPECT_EQ(get("/api/runs/" + id + "/uncertainty").json()["ensembles"], 0);
}

TEST_F(ServedCalibrations, APosteriorGivesPredictionsWithTheirUncertainty) {
  const std::string id = calibrate(study()).json()["id"];
  EXPECT_EQ(wait_for(id, "done")["state"], "done");
  const std::string text = project_ + "\n[sampling]\nparameters = \"runs/slope/" + id +
                           "/posterior.csv\"\nensembles = 10\n[output]\nreport = false\n";
  const std::string run = begin(text);
  EXPECT_EQ(wait_for(run, "done")["state"], "done");
  const Json uncertainty = get("/api/runs/" + run + "/uncertainty").json();
  EXPECT_EQ(uncertainty["ensembles"], 10);
  ASSERT_FALSE(uncertainty["figures"].empty());
  EXPECT_LT(uncertainty["figures"][0]["total"][1], uncertainty["figures"][0]["total"][2]);
}

}  // namespace
}  // namespace talus
