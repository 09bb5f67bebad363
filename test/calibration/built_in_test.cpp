// The experiments that are built into the program: complete, with their licences, and with the results that the
// documentation gives.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "support/input_folder.hpp"
#include "support/places.hpp"
#include "talus/calibration/experiments.hpp"
#include "talus/calibration/observation_table.hpp"
#include "talus/calibration/prediction.hpp"
#include "talus/calibration/validation_results.hpp"

namespace talus::validation {
namespace {

using testing::HasSubstr;

const std::filesystem::path experiments_folder = std::filesystem::path(talus::places::in_source("/validation"));

std::string file_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

class BuiltInExperiments : public testing_tools::InputFolder {};

TEST_F(BuiltInExperiments, HaveAllFilesWithTheLicence) {
  for (const std::string& name : experiment_names()) {
    unpack(name, path(name));
    for (const auto& entry : std::filesystem::directory_iterator(experiments_folder / name)) {
      EXPECT_EQ(file_text(path(name) / entry.path().filename()), file_text(entry.path())) << entry.path();
    }
    EXPECT_TRUE(std::filesystem::exists(path(name) / "LICENSE")) << name;
    Problems doubts;
    EXPECT_FALSE(read_experiment(path(name), doubts).studies.empty());
  }
  EXPECT_EQ(chosen_experiments({"tscha"}), std::vector<std::string>{"tschamut2014"});
  EXPECT_EQ(refusal_of([] { (void)chosen_experiments({"tschamut2015"}); }),
            "validate: there is no experiment \"tschamut2015\" (built in: tschamut2014). Did you mean "
            "\"tschamut2014\"?");
}

TEST_F(BuiltInExperiments, HalvesOfTschamutHaveEveryRunOnce) {
  std::set<std::string> names;
  std::size_t rows = 0;
  for (const char half : {'a', 'b'}) {
    const std::string ending = std::string(1, half) + ".csv";
    const calibration::ObservationTable releases(experiments_folder / "tschamut2014" / ("releases-" + ending));
    const calibration::ObservationTable stops(experiments_folder / "tschamut2014" / ("stops-" + ending));
    ASSERT_EQ(releases.rows(), stops.rows());
    rows += stops.rows();
    for (std::size_t row = 0; row < stops.rows(); ++row) {
      EXPECT_EQ(releases.text(row, 0), stops.text(row, 0));
      names.insert(stops.text(row, 0));
    }
  }
  EXPECT_EQ(rows, 79U);
  EXPECT_EQ(names.size(), 79U);
  EXPECT_FALSE(names.contains("v034"));
}

TEST_F(BuiltInExperiments, ResultsInTheDocumentationIsNotStale) {
  const std::string file = talus::places::in_source("/docs/validation.md");
  std::string page = file_text(file);
  for (const std::string& name : experiment_names()) {
    Problems doubts;
    const Experiment experiment = read_experiment(experiments_folder / name, doubts);
    std::vector<ResultRow> rows;
    TableReader<ResultRow> reader(experiments_folder / name / ResultRow::file_name);
    while (reader.next()) rows.push_back(reader.whole());
    std::vector<GroupRow> groups;
    TableReader<GroupRow> group(experiments_folder / name / GroupRow::file_name);
    while (group.next()) groups.push_back(group.whole());
    const std::string mark = "<!-- results of " + name + " -->\n", end = "<!-- end of results -->";
    const std::size_t begin = page.find(mark);
    ASSERT_NE(begin, std::string::npos) << mark;
    const std::size_t last = page.find(end, begin);
    ASSERT_NE(last, std::string::npos);
    page = page.substr(0, begin + mark.size()) + "\n" + markdown(experiment, rows, groups) + "\n" + page.substr(last);
    for (const std::string& limit : experiment.limits) EXPECT_THAT(page, HasSubstr(limit));
  }
  if (std::getenv("TALUS_RENEW_REFERENCE") != nullptr) std::ofstream(file) << page;
  EXPECT_EQ(page, file_text(file)) << "run this test with TALUS_RENEW_REFERENCE=1";
}

/// What does not follow from a calibration is computed again: another law, terrain or release shows here within
/// seconds.
TEST_F(BuiltInExperiments, ResultsAreThoseOfThisProgram) {
  for (const std::string& name : experiment_names()) {
    Problems doubts;
    const Experiment experiment = read_experiment(experiments_folder / name, doubts);
    TableReader<ResultRow> reader(experiments_folder / name / ResultRow::file_name);
    for (const calibration::Study& study : experiment.studies) {
      for (const Scores& prior : prior_scores(study)) {
        ASSERT_TRUE(reader.next());
        const ResultRow recorded = reader.whole();
        constexpr const char* stale = "run make validate, and renew the results as CONTRIBUTING says";
        EXPECT_NEAR(prior.runout, recorded.crps_prior, 1e-9) << recorded.model << ": " << stale;
        EXPECT_NEAR(prior.place, recorded.place_prior, 1e-9) << recorded.model << ": " << stale;
      }
    }
    EXPECT_FALSE(reader.next());
  }
}

}  // namespace
}  // namespace talus::validation
