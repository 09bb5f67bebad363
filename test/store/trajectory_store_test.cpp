// The store of a campaign: the rocks that fit, the same bytes from any division of the rocks, the index, damage.

#include "talus/store/trajectory_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "store/stored_models.hpp"
#include "support/dice.hpp"
#include "support/saved.hpp"
#include "talus/campaign/campaign.hpp"
#include "talus/core/problems.hpp"
#include "talus/store/rock_choice.hpp"
#include "talus/store/store_observer.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using testing_tools::Dice;
using testing_tools::saved;
using testing_tools::takes;

constexpr std::uint64_t rocks = 400;

Model tutorial(const char* dimensions) {
  return store_test::model_of(
      {"", std::string("tutorial-1/tutorial-1-") + dimensions + ".toml", {"seeder.0.rocks=" + std::to_string(rocks)}});
}

std::unique_ptr<StoreObserver> store_of(const Model& model, const StoreBudget& budget, const RockRange& range,
                                        int threads = 2) {
  auto store = std::make_unique<StoreObserver>(budget, model);
  Observer* const observers[] = {store.get()};
  CampaignOptions options;
  options.threads = threads;
  options.rocks = range;
  run_campaign(model, observers, options);
  return store;
}

fs::path written(StoreObserver& store, const test::Workplace& work, const char* name = "t.bin") {
  store.write(work / name, rocks);
  return work / name;
}

TEST(TrajectoryStore, HasAllRocksIfTheyFit) {
  const test::Workplace work;
  const Model model = tutorial("3d");
  const auto observer = store_of(model, {}, {0, rocks});
  const StoreExtent extent = observer->write(work / "t.bin", rocks);
  EXPECT_EQ(extent.rocks, rocks);
  EXPECT_EQ(extent.bytes, fs::file_size(work / "t.bin"));
  const TrajectoryStore store(work / "t.bin");
  EXPECT_TRUE(store.has_all());
  EXPECT_EQ(store.row_count(), extent.rows);
  EXPECT_EQ(store.facts().seeders, std::vector<std::string>{model.seeders[0].name});
  EXPECT_EQ(store.facts().gravity, model.laws.gravity);
  EXPECT_EQ(store.facts().planned, rocks);
  double largest = 0;
  Simulator simulator(model);
  std::uint64_t rows = 0;
  for (std::size_t place = 0; place < rocks; ++place) {
    const StoredTrajectory trajectory = store.read(place);
    const RockRecord record = simulator.simulate(place, true, true);
    EXPECT_EQ(trajectory.record.rock, place);
    EXPECT_EQ(trajectory.record.outcome.end.position, record.outcome.end.position);
    EXPECT_EQ(trajectory.rows.size(), simulator.log().rows.size());
    rows += trajectory.rows.size();
    largest = std::max(largest, record.body.radius);
  }
  EXPECT_EQ(store.largest_radius(), largest);
  EXPECT_EQ(rows, store.row_count());
  EXPECT_LT(extent.bytes, 40 * rows);
}

TEST(TrajectoryStore, HasTheFirstRocksOfTheChoiceThatFit) {
  const test::Workplace work;
  const Model model = tutorial("2d");
  const auto all = store_of(model, {}, {0, rocks});
  const std::uint64_t bytes = all->write(work / "all.bin", rocks).bytes;
  const auto some = store_of(model, {bytes / 3}, {0, rocks});
  const StoreExtent extent = some->write(work / "some.bin", rocks);
  EXPECT_LT(extent.bytes, bytes / 3 + 4096);
  EXPECT_GT(extent.rocks, rocks / 4);
  EXPECT_LT(extent.rocks, rocks / 2);
  const TrajectoryStore store(work / "some.bin");
  EXPECT_FALSE(store.has_all());
  std::uint64_t last_in = 0, first_out = StoreObserver::no_limit;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) {
    const std::uint64_t place = place_in_choice(model.seed, rock);
    store.find(rock) ? last_in = std::max(last_in, place) : first_out = std::min(first_out, place);
  }
  EXPECT_LT(last_in, first_out);
}

TEST(TrajectoryStore, HasNoneIfNoneFits) {
  const test::Workplace work;
  const Model model = tutorial("2d");
  const TrajectoryStore store(written(*store_of(model, {10}, {0, rocks}), work));
  EXPECT_TRUE(store.rocks().empty());
  EXPECT_TRUE(store.rocks_near({{-100, -100}, {100, 100}}).empty());
}

TEST(TrajectoryStore, AnyDivisionOfTheRocksGivesTheSameBytes) {
  const test::Workplace work;
  const Model model = tutorial("3d");
  Dice dice(9);
  for (const StoreBudget& budget :
       {StoreBudget{}, StoreBudget{40'000}, StoreBudget{9'000}, StoreBudget{.rocks = 70}, StoreBudget{15'000, 70}}) {
    const auto whole = store_of(model, budget, {0, rocks}, 1);
    const std::string bytes = saved(*whole);
    const std::string file = test::bytes_of(written(*whole, work));
    for (int trial = 0; trial < 4; ++trial) {
      std::vector<std::string> parts;
      for (std::uint64_t first = 0; first < rocks;) {
        const std::uint64_t last = std::min<std::uint64_t>(rocks, first + 1 + dice.below(250));
        parts.push_back(saved(*store_of(model, budget, {first, last})));
        first = last;
      }
      StoreObserver merged(budget);
      while (!parts.empty()) {
        const std::size_t k = dice.below(parts.size());
        ASSERT_TRUE(takes(merged, parts[k]));
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
      }
      EXPECT_EQ(saved(merged), bytes);
      EXPECT_EQ(test::bytes_of(written(merged, work)), file);
    }
  }
}

TEST(TrajectoryStore, AResumedObserverGivesTheSameBytes) {
  const Model model = tutorial("2d");
  const auto first = store_of(model, {15'000}, {0, 150});
  StoreObserver resumed({15'000}, model);
  ASSERT_TRUE(takes(resumed, saved(*first)));
  Observer* const observers[] = {&resumed};
  CampaignOptions options;
  options.rocks = RockRange{150, rocks};
  run_campaign(model, observers, options);
  EXPECT_EQ(saved(resumed), saved(*store_of(model, {15'000}, {0, rocks})));
}

TEST(TrajectoryStore, DamagedStatesAreRefused) {
  const Model model = tutorial("2d");
  const std::string bytes = saved(*store_of(model, {4'000}, {0, 40}));
  struct Handle {
    std::unique_ptr<StoreObserver> observer = std::make_unique<StoreObserver>(StoreBudget{4'000});
    void merge_saved(ByteReader& in) { observer->merge_saved(in); }
  };
  Dice dice(2);
  testing_tools::expect_damage_is_survived<Handle>(
      dice, bytes, [] { return Handle(); }, [](Handle& handle) { (void)saved(*handle.observer); });
}

TEST(TrajectoryStore, TheIndexHasAllRocksNearAPlace) {
  const test::Workplace work;
  for (const char* dimensions : {"2d", "3d"}) {
    const Model model = tutorial(dimensions);
    const TrajectoryStore store(written(*store_of(model, {}, {0, rocks}), work));
    std::size_t read = 0, possible = 0;
    for (double x = 0.25; x < 26; x += 1.5) {
      const Vec2 at(x - store.facts().origin.x(), 0);
      const std::vector<Vec2> line{at + Vec2(0, -100), at + Vec2(0, 100)};
      const auto near = store.rocks_near(line, 0);
      EXPECT_EQ(store.rocks_near({line[0], line[1]}), near);
      EXPECT_TRUE(std::ranges::is_sorted(near));
      const std::set<std::size_t> places(near.begin(), near.end());
      for (std::size_t place = 0; place < rocks; ++place) {
        const StoredTrajectory rock = store.read(place);
        const bool crosses = std::ranges::any_of(rock.pieces, [&](const PathPiece& piece) {
          const double a = piece.path.p.x() - at.x(), b = piece.path.at(piece.duration).x() - at.x();
          return a * b <= 0;
        });
        EXPECT_TRUE(!crosses || places.contains(place));
      }
      read += near.size();
      possible += rocks;
    }
    EXPECT_LT(read, possible);
  }
}

/// Why a store is refused.
std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return "";
}

TEST(TrajectoryStore, DamageIsRefusedWithItsReason) {
  const test::Workplace work;
  const Model model = tutorial("2d");
  const std::string bytes = test::bytes_of(written(*store_of(model, {4'000}, {0, rocks}), work));
  const auto refusal_of = [&](const std::string& changed) {
    const std::string file = work.write("bad.bin", changed);
    const std::string text = refusal([&] {
      const TrajectoryStore store(file);
      for (std::size_t place = 0; place < store.rocks().size(); ++place) (void)store.read(place);
    });
    const std::string begin = file + ": cannot use this store of trajectories (";
    const std::string end = "). Run the project again to write it anew";
    EXPECT_TRUE(text.starts_with(begin) && text.ends_with(end)) << text;
    return text.substr(begin.size(), text.size() - begin.size() - end.size());
  };
  const auto with = [&](std::size_t at, char byte) {
    std::string changed = bytes;
    changed[at] = byte;
    return changed;
  };
  EXPECT_EQ(refusal_of(""), "it is empty");
  EXPECT_EQ(refusal_of("rock,event"), "it is not a store of trajectories");
  EXPECT_EQ(refusal_of(bytes.substr(0, 20)), "it was cut short");
  EXPECT_EQ(refusal_of(with(16, 9)), "another version of talus wrote it");
  EXPECT_EQ(refusal_of(with(60, '\x7f')), "its head was changed or damaged");
  EXPECT_EQ(refusal_of(bytes.substr(0, 200)), "it was cut short");
  EXPECT_EQ(refusal_of(bytes.substr(0, bytes.size() - 1)), "it was cut short");
  EXPECT_EQ(refusal_of(bytes + "x"), "there are unexpected data at the end");
  EXPECT_EQ(refusal_of(with(bytes.size() - 1, static_cast<char>(bytes.back() ^ 1))),
            "a trajectory was changed or damaged");
  EXPECT_EQ(refusal([&] { TrajectoryStore store(work / "."); }),
            (work / ".").string() +
                ": cannot use this store of trajectories (it is a folder). Run the project again to "
                "write it anew");
  EXPECT_EQ(refusal([&] { TrajectoryStore store(work / "none.bin"); }),
            (work / "none.bin").string() +
                ": cannot use this store of trajectories (No such file or directory). Run the project again to write "
                "it anew");
}

}  // namespace
}  // namespace talus
