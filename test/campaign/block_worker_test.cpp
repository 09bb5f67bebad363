#include "talus/campaign/block_worker.hpp"
#include "support/places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "support/endless_slope.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::block_worker_test {
namespace {

using namespace std::chrono_literals;

Model tutorial_model() {
  Problems warnings;
  const std::filesystem::path file = talus::places::in_source("/examples/tutorial-1/tutorial-1-2d.toml");
  return project::build_model(project::read_project(file, {{}, 2000, {}}).project, warnings);
}

/// Writes the numbers of the rocks that it sees; throws at one of them.
struct Numbers : Observer {
  struct Part : ObserverPart {
    explicit Part(std::uint64_t bad) : bad_rock(bad) {}
    void see(const RockRecord& record, const RockLog&) override {
      if (record.rock == bad_rock) throw std::runtime_error("no room for this rock");
      text += std::to_string(record.rock) + " ";
    }
    std::uint64_t bad_rock;
    std::string text;
  };
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override { return std::make_unique<Part>(bad_rock); }
  void commit(ObserverPart& part) override { text += static_cast<Part&>(part).text; }
  std::uint64_t bad_rock = 1'000'000;
  std::string text;
};

std::string numbers_of(const RockRange& rocks) {
  std::string text;
  for (std::uint64_t rock = rocks.first; rock < rocks.last; ++rock) text += std::to_string(rock) + " ";
  return text;
}

TEST(BlockWorker, ReturnsTheRowsOfEachBlockSeparately) {
  const Model model = tutorial_model();
  for (const int threads : {1, 2, 8}) {
    Numbers numbers;
    BlockWorker worker(model, {&numbers}, {}, threads,
                       [&] { return std::vector<std::string>{std::exchange(numbers.text, {})}; });
    std::vector<RockRange> given;
    std::vector<DoneBlock> done;
    for (int round = 0; round < 3; ++round) {  // work, wait, work again
      for (std::uint64_t k = 0; k < 6; ++k) {
        given.push_back({300 * k + 7 * static_cast<std::uint64_t>(round), 300 * k + 50});
        worker.give(given.back());
      }
      while (done.size() < given.size()) {
        for (DoneBlock& block : worker.take(1s)) done.push_back(std::move(block));
      }
    }
    ASSERT_EQ(done.size(), given.size());
    for (std::size_t k = 0; k < given.size(); ++k) {
      EXPECT_EQ(done[k].rocks, given[k]);
      EXPECT_EQ(done[k].texts, std::vector<std::string>{numbers_of(given[k])});
    }
  }
}

TEST(BlockWorker, RethrowsAnException) {
  const Model model = tutorial_model();
  for (const int threads : {1, 4}) {
    Numbers numbers;
    numbers.bad_rock = 250;
    BlockWorker worker(model, {&numbers}, {}, threads, [&] { return std::vector<std::string>(1); });
    for (std::uint64_t k = 0; k < 10; ++k) worker.give({100 * k, 100 * k + 100});
    std::string said;
    try {
      for (int k = 0; k < 1000; ++k) (void)worker.take(10ms);
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    EXPECT_EQ(said, "no room for this rock");
  }
}

TEST(BlockWorker, MayEndWithoutWork) {
  const Model model = tutorial_model();
  Numbers numbers;
  BlockWorker worker(model, {&numbers}, {}, 2, [] { return std::vector<std::string>(); });
  EXPECT_TRUE(worker.take(0us).empty());
  EXPECT_TRUE(worker.take(100us).empty());
}

/// Counts the rocks that were committed.
struct Count : SummingObserver {
  struct Part : ObserverPart {
    void see(const RockRecord&, const RockLog&) override { ++rocks; }
    std::uint64_t rocks = 0;
  };
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override { return std::make_unique<Part>(); }
  void commit(ObserverPart& part) override { rocks += static_cast<Part&>(part).rocks; }
  void save(ByteWriter&) override {}
  void merge_saved(ByteReader&) override {}
  std::uint64_t rocks = 0;
};

TEST(BlockWorker, DoesNotCommitSums) {
  const Model model = tutorial_model();
  Count count;
  SummingObserver* const sums[] = {&count};
  BlockWorker worker(model, {}, {&count}, 2, [] { return std::vector<std::string>(); });
  worker.give({0, 50});
  worker.give({50, 120});
  std::vector<DoneBlock> done;
  while (done.size() < 2) {
    for (DoneBlock& block : worker.take(1s)) done.push_back(std::move(block));
  }
  EXPECT_EQ(count.rocks, 0U);
  commit(done[0], sums);
  EXPECT_EQ(count.rocks, 50U);
  commit(done[1], sums);
  EXPECT_EQ(count.rocks, 120U);
}

TEST(BlockWorker, StopsInTheMiddleOfABlock) {
  Problems warnings;
  const std::string text = testing_tools::endless_slope(100, 3);
  const Model model = project::build_model(project::read_project_text(text, "endless.toml", {}).project, warnings);
  Count count;
  SummingObserver* const sums[] = {&count};
  // One thread waits for more blocks and one simulates the long rocks: others are needed to return finished blocks.
  BlockWorker worker(model, {}, {&count}, 4, [] { return std::vector<std::string>(); });
  for (std::uint64_t k = 0; k < 100; k += 20) worker.give({k, k + 20});
  worker.give({100, 103});
  while (count.rocks < 100) {
    for (DoneBlock& block : worker.take(1s)) commit(block, sums);
  }
  EXPECT_FALSE(worker.has_ended());
  const auto asked = std::chrono::steady_clock::now();
  worker.stop();
  while (!worker.has_ended()) EXPECT_TRUE(worker.take(1ms).empty());
  EXPECT_LT(std::chrono::steady_clock::now() - asked, 1min);  // each of these rocks takes minutes
}

}  // namespace
}  // namespace talus::block_worker_test
