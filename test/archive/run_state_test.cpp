// run.state as a file: it is restored as written, and any change is refused.

#include "talus/archive/run_state.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "cli/program.hpp"
#include "support/dice.hpp"
#include "support/saved.hpp"
#include "talus/core/problems.hpp"
#include "talus/results/summary.hpp"

namespace talus {
namespace {

using testing_tools::Dice;
using testing_tools::saved;

constexpr std::uint64_t rocks = 500;

/// A header with all fields set.
RunStateHeader full_header() {
  RunStateHeader header;
  RunDescription& description = header.description;
  description.name = "Côte \"nord\"";
  description.fingerprint = std::string(32, 'a');
  description.sample = std::string(32, 'b');
  description.rocks = rocks;
  description.barriers = 1;
  description.project = {{"sampling", {{"seed", 18446744073709551615U}}}, {"x", 0.1}};
  description.model = nlohmann::ordered_json::parse(
      R"({"seed": 1, "energy_datum_m": -25.0, "origin_m": [0, 0, 0], "terrain": {"kind": "section"}, "sources": [],
          "releases": [],          "barriers": [{"name": "Fence", "kind": "barrier"}]})");
  description.warnings = {{"one", "two"}, {{.warning = 1, .kind = "mostly_on_ground", .where = "rocks"}}};
  description.crs_wkt = "PROJCS[...]";
  description.sources = {"north", "south"};
  description.maps = {Vec2(2.6e6 + 0.1, 1e-300),
                      Vec2(0.5, 0.25),
                      true,
                      5,
                      {MapSubjects{0b10010001}, {50, 97.5}, MapSubjects{0b10010000}}};
  description.design.emplace().lines = {{"Fence", 0, 12.5, 5, 3}};
  description.design->heights = {2, 3};
  description.wants_maps = true;
  description.wants_report = false;
  header.range = {100, 300};
  header.shard = Shard{2, 4};
  header.done = 250;
  header.seconds = 12.25;
  header.threads = 7;
  header.tables = {{"endpoints.csv", 12345, {1, 2}}, {"paths.csv", 0, {3, ~0ULL}}};
  return header;
}

SummaryObserver observer_of(std::uint64_t seen) {
  SummaryObserver observer(rocks, 1, {});
  Dice dice(41);
  const auto part = observer.new_part();
  for (std::uint64_t k = 0; k < seen; ++k) {
    RockRecord record;
    record.body = sphere_of_mass(1000, 2700);
    record.outcome.end.position = dice.in_cube(100);
    record.outcome.max_kinetic_energy = dice.magnitude(1, 1e6);
    part->see(record, RockLog(false));
  }
  observer.commit(*part);
  return observer;
}

class RunStateFile : public testing::Test {
 protected:
  void write(const RunStateHeader& header, SummaryObserver& observer) const {
    SummingObserver* const observers[] = {&observer};
    write_run_state(file, header, observers);
  }
  /// The message when the file is read; empty if there is none.
  [[nodiscard]] std::string message() const {
    try {
      (void)read_run_state_header(file);
      SummaryObserver observer(rocks, 1, {});
      SummingObserver* const observers[] = {&observer};
      merge_run_state(file, observers);
    } catch (const BadInput& bad) {
      return bad.problems().text();
    }
    return "";
  }
  [[nodiscard]] std::string refused(const std::string& why) const {
    return file.string() + ": cannot use this state of a run (" + why +
           "). Remove it, and run these rocks again without --resume";
  }
  const test::Workplace work;
  const std::filesystem::path file = work / "run.state";
};

TEST_F(RunStateFile, IsRestoredAsWritten) {
  const RunStateHeader header = full_header();
  SummaryObserver observer = observer_of(150);
  write(header, observer);
  EXPECT_FALSE(std::filesystem::exists(work / "run.state.part"));
  EXPECT_EQ(message(), "");

  const RunStateHeader read = read_run_state_header(file);
  EXPECT_EQ(json_text(read.description), json_text(header.description));
  EXPECT_EQ(read.description.maps->origin, header.description.maps->origin);
  EXPECT_EQ(read.description.maps->selection.subjects, header.description.maps->selection.subjects);
  EXPECT_EQ(read.description.maps->selection.bands, header.description.maps->selection.bands);
  EXPECT_EQ(read.description.maps->ensembles, 5U);
  EXPECT_EQ(read.description.design, header.description.design);
  EXPECT_EQ(read.range, header.range);
  EXPECT_EQ(read.shard, header.shard);
  EXPECT_EQ(read.done, header.done);
  EXPECT_EQ(read.seconds, header.seconds);
  EXPECT_EQ(read.threads, header.threads);
  EXPECT_EQ(read.tables, header.tables);
  EXPECT_FALSE(read.is_complete());
  EXPECT_EQ(read.rocks(), (RockRange{100, 250}));

  SummaryObserver restored(rocks, 1, {});
  SummingObserver* const observers[] = {&restored};
  merge_run_state(file, observers);
  EXPECT_EQ(saved(restored), saved(observer));
}

TEST_F(RunStateFile, OfTheWholeCampaignHasNoShard) {
  RunStateHeader header = full_header();
  header.shard.reset();
  header.description.maps.reset();
  SummaryObserver observer = observer_of(0);
  write(header, observer);
  EXPECT_FALSE(read_run_state_header(file).shard);
  EXPECT_FALSE(read_run_state_header(file).description.maps);
}

TEST_F(RunStateFile, ReplacesThePreviousOneOrLeavesItUnchanged) {
  SummaryObserver few = observer_of(10), many = observer_of(20);
  write(full_header(), few);
  const std::string before = work.read("run.state");
  write(full_header(), many);
  EXPECT_NE(work.read("run.state"), before);
  EXPECT_EQ(message(), "");
}

TEST_F(RunStateFile, IsRefusedWithAReason) {
  SummaryObserver observer = observer_of(150);
  write(full_header(), observer);
  const std::string state = work.read("run.state");
  const auto of = [&](const std::string& bytes) {
    work.write("run.state", bytes);
    return message();
  };
  EXPECT_EQ(of(""), refused("it is empty"));
  EXPECT_EQ(of("rock,seeder,x_m\n0,Crest,1.5\n"), refused("it is not the state of a run"));
  EXPECT_EQ(of("talus ru"), refused("it was cut short"));
  EXPECT_EQ(of(state.substr(0, 24)), refused("it was cut short"));
  EXPECT_EQ(of(state.substr(0, 300)), refused("it was cut short"));
  EXPECT_EQ(of(state.substr(0, state.size() - 1)), refused("it was cut short, changed or damaged"));
  EXPECT_EQ(of(state + "x"), refused("it was cut short, changed or damaged"));
  std::string other = state;
  ++other[16];
  EXPECT_EQ(of(other), refused("another version of talus wrote it"));
  other = state;
  other[60] ^= 4;
  EXPECT_EQ(of(other), refused("it was changed or damaged"));
  other = state;
  other[other.size() - 400] ^= 4;
  EXPECT_EQ(of(other), refused("it was cut short, changed or damaged"));
  std::filesystem::remove(file);
  EXPECT_EQ(message(), refused("No such file or directory"));
  std::filesystem::create_directory(file);
  EXPECT_NE(message(), "");
}

// No bit can be flipped and no byte removed without detection.
TEST_F(RunStateFile, DetectsAllDamage) {
  SummaryObserver observer = observer_of(150);
  write(full_header(), observer);
  const std::string state = work.read("run.state");
  const auto is_taken = [&](std::string_view bytes) {
    try {
      (void)read_header(bytes);
      SummaryObserver into(rocks, 1, {});
      SummingObserver* const observers[] = {&into};
      merge_state(bytes, observers);
      return true;
    } catch (const BadBytes&) {
      return false;
    }
  };
  ASSERT_TRUE(is_taken(state));
  for (std::size_t size = 0; size < state.size(); size += size < 3000 ? 1 : 37) {
    ASSERT_FALSE(is_taken(std::string_view(state).substr(0, size))) << size;
  }
  Dice dice(43);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string changed = state;
    const std::size_t place = trial % 2 == 0 ? dice.below(state.size()) : dice.below(2500);
    changed[place] = static_cast<char>(changed[place] ^ (1 << dice.below(8)));
    ASSERT_FALSE(is_taken(changed)) << place;
  }
}

TEST_F(RunStateFile, IsRefusedForOtherObservers) {
  SummaryObserver observer = observer_of(150);
  write(full_header(), observer);
  SummaryObserver more_barriers(rocks, 2, {});
  SummingObserver* const observers[] = {&more_barriers};
  EXPECT_THROW(merge_run_state(file, observers), BadInput);
  EXPECT_THROW(merge_run_state(file, {}), BadInput);
}

TEST(RunDescription, IsRefusedIfInvalid) {
  const std::string good = json_text(full_header().description);
  EXPECT_EQ(json_text(description_from(good)), good);
  const auto refused = [&](const char* key, nlohmann::ordered_json value) {
    auto json = nlohmann::ordered_json::parse(good);
    json[key] = std::move(value);
    try {
      (void)description_from(json.dump());
    } catch (const BadBytes&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused("name", "another name"));
  EXPECT_TRUE(refused("name", 5));
  EXPECT_TRUE(refused("rocks", "many"));
  EXPECT_TRUE(refused("barriers", 2));  // the model has one
  EXPECT_TRUE(refused(
      "maps",
      {{"origin", {0, 0}}, {"cell", {0, 1}}, {"by_source", true}, {"subjects", {"velocity"}}, {"percentiles", {50}}}));
  EXPECT_TRUE(refused(
      "maps",
      {{"origin", {0}}, {"cell", {1, 1}}, {"by_source", true}, {"subjects", {"velocity"}}, {"percentiles", {50}}}));
  EXPECT_TRUE(refused("project", nlohmann::ordered_json::array()));
  EXPECT_TRUE(refused("model", nlohmann::ordered_json::object()));
  auto model = full_header().description.model;
  EXPECT_FALSE(refused("model", model));
  model["origin_m"] = {0, 0};
  EXPECT_TRUE(refused("model", model));
  model["origin_m"] = {0, "0", 0};
  EXPECT_TRUE(refused("model", model));
  model.erase("origin_m");
  EXPECT_TRUE(refused("model", model));
  EXPECT_THROW((void)description_from(good.substr(0, good.size() - 1)), BadBytes);
  EXPECT_THROW((void)description_from("[]"), BadBytes);
}

}  // namespace
}  // namespace talus
