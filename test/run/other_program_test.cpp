// A run that another program began is not continued, even if its project is the same.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"
#include "talus/archive/run_state.hpp"
#include "talus/campaign/paths_revision.hpp"
#include "talus/core/problems.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/checkpoint.hpp"
#include "talus/run/finished_run.hpp"
#include "talus/run/run.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {
namespace {

using test::Workplace;

class OtherProgram : public testing::Test {
 protected:
  OtherProgram() {
    Reading reading = read_project(test::tutorial("2d"), {{"output.report=false"}, {}, {}});
    project = std::move(reading.project);
    model = build_model(project, warnings);
    ours = describe_run(project, model, warnings, std::nullopt);
  }
  /// The message when a run of this description is continued from its state.
  [[nodiscard]] std::string message(const RunDescription& begun) const {
    RunStateHeader header;
    header.description = begun;
    header.range = {0, begun.rocks};
    write_run_state(work / run_state_name, header, {});
    return message();
  }
  [[nodiscard]] std::string message() const {
    try {
      static_cast<void>(find_checkpoint(work / "", ours, {0, ours.rocks}, std::nullopt));
    } catch (const BadInput& bad) {
      std::string text = bad.problems().text();
      return text.substr((work / "").string().size());
    }
    return "";
  }

  const Workplace work;
  Project project;
  Problems warnings;
  Model model;
  RunDescription ours;
};

const std::string way_on = "Use that program to resume, or run without --resume to start over";

TEST_F(OtherProgram, WithOtherLawsIsRefused) {
  EXPECT_EQ(ours.paths_revision, paths_revision);
  EXPECT_EQ(message(ours), "");
  RunDescription begun = ours;
  begun.paths_revision = 7;
  begun.fingerprint = std::string(32, 'a');
  EXPECT_EQ(message(begun),
            "run.state: this run was begun by another talus (rocks may take other paths: the revision of "
            "its laws was 7 and is " +
                std::to_string(paths_revision) + "). " + way_on);
  begun.paths_revision = 0;
  EXPECT_EQ(message(begun),
            "run.state: this run was begun by another talus (rocks may take other paths: the revision of "
            "its laws was not stated and is " +
                std::to_string(paths_revision) + "). " + way_on);
  begun.project["sampling"]["seed"] = 5;  // what the user changed comes first
  EXPECT_EQ(message(begun),
            "run.state: the project is not the one that this run began with (sampling.seed was 5 and is "
            "1). Undo the change to resume, or run without --resume to start over");
}

TEST_F(OtherProgram, WithOtherPathsIsRefused) {
  RunDescription begun = ours;
  begun.sample = std::string(32, 'b');
  EXPECT_EQ(message(begun),
            "run.state: this run was begun by another talus (the same rocks take other paths: another "
            "build of talus, another processor or other libraries). " +
                way_on);
}

TEST_F(OtherProgram, ThatFinishedIsRefused) {
  static_cast<void>(run_into(work / "", project, model, warnings, {}));
  EXPECT_EQ(message(), "");
  auto summary = nlohmann::ordered_json::parse(work.read("summary.json"));
  EXPECT_EQ(summary["talus"]["paths_revision"], paths_revision);
  summary["talus"].erase("paths_revision");
  summary["fingerprint"] = std::string(32, 'a');
  work.write("summary.json", summary.dump());
  EXPECT_EQ(message(),
            "summary.json: this run was begun by another talus (rocks may take other paths: the revision of "
            "its laws was not stated and is " +
                std::to_string(paths_revision) + "). " + way_on);
}

}  // namespace
}  // namespace talus::project
