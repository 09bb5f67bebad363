#include "talus/results/summary.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "support/dice.hpp"

namespace talus::summary_test {
namespace {

using testing_tools::Dice;

struct Seen {
  RockRecord record;
  RockLog log{false};
};

Seen ended_at(const Vec3& start, const Vec3& end, EndReason reason = EndReason::at_rest) {
  Seen seen;
  seen.record.body = sphere_of_mass(1000, 2700);
  seen.record.outcome.start.position = start;
  seen.record.outcome.end.position = end;
  seen.record.outcome.reason = reason;
  return seen;
}

Summary summary_of(const std::vector<Seen>& rocks, std::size_t barriers = 0, const LocalFrame& frame = {}) {
  SummaryObserver observer(rocks.size(), barriers, frame);
  const auto part = observer.new_part();
  for (const Seen& seen : rocks) part->see(seen.record, seen.log);
  observer.commit(*part);
  return observer.summary();
}

std::string bytes_of(const auto& sums) {
  ByteWriter out;
  sums.save(out);
  return out.take();
}

TEST(Runout, IsTheDistanceFromReleaseToEnd) {
  const Runout way = runout(ended_at({1, 1, 50}, {4, 5, 38}).record.outcome);
  EXPECT_DOUBLE_EQ(way.plan, 5);
  EXPECT_DOUBLE_EQ(way.drop, 12);
  EXPECT_DOUBLE_EQ(way.total, 13);
}

TEST(Summary, CountsReasonsEventsAndLiftedRocks) {
  std::vector<Seen> rocks{ended_at({0, 0, 1}, {2, 0, 0}), ended_at({0, 0, 1}, {4, 0, 0}, EndReason::left_model),
                          ended_at({0, 0, 1}, {6, 0, 0})};
  rocks[0].record.outcome.events = 7;
  rocks[2].record.outcome.events = 5;
  rocks[1].record.was_lifted = true;
  const Summary summary = summary_of(rocks);
  EXPECT_EQ(summary.done, 3U);
  EXPECT_EQ(summary.ends[static_cast<std::size_t>(EndReason::at_rest)], 2U);
  EXPECT_EQ(summary.ends[static_cast<std::size_t>(EndReason::left_model)], 1U);
  EXPECT_EQ(std::accumulate(summary.ends.begin(), summary.ends.end(), std::uint64_t{0}), 3U);
  EXPECT_EQ(summary.events, 12);
  EXPECT_EQ(summary.lifted, 1U);
  EXPECT_FALSE(summary.first_lost);
  EXPECT_DOUBLE_EQ(summary.end_x.describe().mean.value(), 4);
}

TEST(Summary, KeepsTheLowestNumberOfALostRockInAnyOrder) {
  SummaryObserver observer(3, 0, {});
  for (const std::uint64_t rock : {9, 4, 6}) {
    Seen seen = ended_at(Vec3{}, Vec3{}, rock == 9 ? EndReason::at_rest : EndReason::lost);
    seen.record.rock = rock;
    const auto part = observer.new_part();
    part->see(seen.record, seen.log);
    observer.commit(*part);
  }
  EXPECT_EQ(observer.summary().first_lost, 4U);
}

TEST(Summary, HasPositionsInUserCoordinates) {
  LocalFrame frame;
  frame.origin = {2'600'000, 1'100'000, 500};
  EXPECT_DOUBLE_EQ(summary_of({ended_at({0, 0, 0}, {12.5, 0, 0})}, 0, frame).end_x.describe().mean.value(),
                   2'600'012.5);
}

// Enough rocks to be counted in bins.
TEST(Summary, HasAccurateQuantilesOfPositionsInMapCoordinates) {
  constexpr std::uint64_t rocks = QuantileSketch::most_exact + 1;
  SummaryObserver observer(rocks, 0, {Vec3(2'600'960, 1'199'104, 0)});
  const auto part = observer.new_part();
  for (std::uint64_t k = 0; k < rocks; ++k) {
    const Seen seen = ended_at({0, 0, 0}, {200.0 * static_cast<double>(k) / (rocks - 1), 0, 0});
    part->see(seen.record, seen.log);
  }
  observer.commit(*part);
  const Tally& end_x = observer.summary().end_x;
  for (const double p : {0.25, 0.5, 0.75, 0.95}) {
    EXPECT_NEAR(*end_x.sketch().quantile(p), 2'600'960 + 200 * p, 0.0005 * 200 * p) << p;
  }
  EXPECT_EQ(*end_x.describe().median, *end_x.sketch().quantile(0.5));
  const auto histogram = end_x.histogram(40);
  ASSERT_EQ(histogram->counts().size(), 40U);
  for (const std::uint64_t count : histogram->counts()) EXPECT_NEAR(static_cast<double>(count), 2500, 250);
}

TEST(Summary, NotesThatManyRocksLeftTheModel) {
  std::vector<Seen> rocks(199, ended_at({0, 0, 0}, {1, 0, 0}));
  rocks[7] = rocks[9] = ended_at({0, 0, 0}, {1, 0, 0}, EndReason::left_model);
  EXPECT_EQ(
      notes_of(summary_of(rocks)),
      std::vector<std::string>{"2 of 199 rocks left the model: runout, reach and end points are cut at its edge"});
  rocks.push_back(rocks.front());
  EXPECT_TRUE(notes_of(summary_of(rocks)).empty()) << "one in a hundred";
  EXPECT_TRUE(notes_of(summary_of({})).empty());
}

TEST(Summary, CountsHitsOnABarrierAndTheirRocks) {
  Seen twice = ended_at(Vec3{}, Vec3{}), over = twice;
  const Rock& rock = twice.record.body;
  for (const double speed : {4.0, 10.0}) {
    Passage hit;
    hit.barrier = BarrierId{1};
    hit.motion.velocity = {0, speed, 0};
    hit.motion.spin = {3, 0, 0};
    hit.height = speed / 5;
    hit.outcome = speed > 5 ? BarrierOutcome::stopped : BarrierOutcome::passed;
    twice.log.hits.push_back(hit);
  }
  over.log.passed_above = {{{.barrier = BarrierId{1}, .clearance = 0.75}},
                           {{.barrier = BarrierId{1}, .clearance = 0.25}}};
  const Summary summary = summary_of({twice, over}, 2);
  const BarrierTally& untouched = summary.barriers[0];
  EXPECT_EQ(untouched.rocks_hit + untouched.rocks_passed_above + untouched.height.count(), 0U);
  const BarrierTally& tally = summary.barriers[1];
  EXPECT_EQ(tally.rocks_hit, 1U);
  EXPECT_EQ(tally.height.count(), 2U);
  EXPECT_EQ(tally.rocks_passed_above, 1U);
  EXPECT_EQ(tally.least_clearance, 0.25);
  EXPECT_EQ(tally.outcomes[static_cast<std::size_t>(BarrierOutcome::stopped)], 1U);
  EXPECT_EQ(tally.outcomes[static_cast<std::size_t>(BarrierOutcome::passed)], 1U);
  EXPECT_DOUBLE_EQ(tally.velocity.describe().mean.value(), 7);
  EXPECT_DOUBLE_EQ(tally.height.describe().mean.value(), 1.4);
  EXPECT_DOUBLE_EQ(tally.translational_energy.describe().mean.value(), 0.5 * 1000 * (16 + 100) / 2);
  EXPECT_NEAR(tally.total_energy.describe().mean.value(), 0.5 * 1000 * 58 + 0.5 * rock.inertia * 9, 1e-9);
}

TEST(Summary, TakesMemoryOnlyForCollectorsThatRocksReach) {
  constexpr std::uint32_t collectors = 100'000;
  static_assert(sizeof(BarrierTally) < 1000);
  Seen seen = ended_at({0, 0, 1}, {2, 0, 0});
  for (const std::uint32_t number : {77'777U, 3U, 77'777U}) {
    Passage hit;
    hit.barrier = BarrierId{number};
    hit.height = 2;
    seen.log.hits.push_back(hit);
  }
  seen.log.passed_above.push_back({{.barrier = BarrierId{5}, .clearance = 0.5}});
  seen.log.passed_above.push_back({{.barrier = BarrierId{5}, .clearance = 0.25}});
  const Summary summary = summary_of({seen, seen}, collectors);
  ASSERT_EQ(summary.barriers.size(), collectors);
  EXPECT_EQ(summary.barriers[77'777].height.count(), 4U);
  EXPECT_EQ(summary.barriers[77'777].rocks_hit, 2U);
  EXPECT_EQ(summary.barriers[3].rocks_hit, 2U);
  EXPECT_EQ(summary.barriers[5].rocks_passed_above, 2U);
  EXPECT_EQ(summary.barriers[5].least_clearance, 0.25);
  EXPECT_EQ(summary.barriers[5].rocks_hit, 0U);
  EXPECT_EQ(summary.barriers[4].height.count(), 0U);
  EXPECT_EQ(summary.barriers[4].height.describe().count, 0U);
}

// Any split of the rocks into parts, committed in any order, gives the same bits.
TEST(Summary, DoesNotDependOnHowTheRocksAreSplit) {
  Dice dice(71);
  std::vector<Seen> rocks;
  for (int k = 0; k < 500; ++k) {
    rocks.push_back(ended_at(dice.in_cube(1e6), dice.in_cube(1e-3)));
    rocks.back().record.outcome.max_kinetic_energy = dice.magnitude(1e-9, 1e9);
    rocks.back().record.outcome.max_bounce = dice.unit();
    rocks.back().log.ways = {dice.magnitude(1e-9, 1e5), dice.magnitude(1e-9, 1e5)};
  }
  const Summary whole = summary_of(rocks);
  for (int trial = 0; trial < 20; ++trial) {
    SummaryObserver observer(rocks.size(), 0, {});
    std::vector<std::unique_ptr<ObserverPart>> parts;
    for (int k = 0; k < 7; ++k) parts.push_back(observer.new_part());
    for (const Seen& seen : rocks) parts[dice.below(parts.size())]->see(seen.record, seen.log);
    while (!parts.empty()) {
      const std::size_t k = dice.below(parts.size());
      observer.commit(*parts[k]);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
    }
    const auto bits = [](const Tally& tally) {
      const Descriptive d = tally.describe();
      return std::array{std::bit_cast<std::uint64_t>(*d.mean), std::bit_cast<std::uint64_t>(*d.standard_deviation),
                        std::bit_cast<std::uint64_t>(*d.median), std::bit_cast<std::uint64_t>(*d.kurtosis)};
    };
    const Summary& split = observer.summary();
    EXPECT_EQ(bits(split.end_x), bits(whole.end_x));
    EXPECT_EQ(bits(split.runout_total), bits(whole.runout_total));
    EXPECT_EQ(bits(split.max_kinetic_energy), bits(whole.max_kinetic_energy));
    EXPECT_EQ(bits(split.max_bounce), bits(whole.max_bounce));
    EXPECT_EQ(split.flown, whole.flown);
    EXPECT_EQ(split.on_ground, whole.on_ground);
  }
}

// A few values are kept, and their moments made on demand: for any number of them the bits are the same.
TEST(Tally, OfFewValuesEqualsMoments) {
  Dice dice(27);
  for (const std::uint64_t count : {1U, 31U, 32U, 33U, 34U, 100U}) {
    std::vector<double> values;
    for (std::uint64_t k = 0; k < count; ++k) values.push_back(dice.between(-1, 1) * 1e6);
    Moments moments;
    for (const double x : values) moments.add(x);
    for (std::uint64_t split = 0; split <= count; ++split) {
      Tally first(count), second(count);
      for (std::uint64_t k = 0; k < count; ++k) (k < split ? first : second).add(values[k]);
      first.merge(second);
      EXPECT_EQ(first.count(), count);
      EXPECT_EQ(bytes_of(first).substr(0, bytes_of(moments).size()), bytes_of(moments)) << count << ' ' << split;
      Tally restored(count);
      const std::string bytes = bytes_of(first);
      ByteReader in(bytes);
      restored.merge_saved(in);
      EXPECT_EQ(bytes_of(restored), bytes);
    }
  }
}

TEST(Tally, HasAHistogramOfEveryValue) {
  Tally tally(4);
  EXPECT_FALSE(tally.histogram(10));
  for (const double x : {1.0, 2.5, 2.6, 9.0}) tally.add(x);
  const auto histogram = tally.histogram(10);
  ASSERT_TRUE(histogram);
  EXPECT_EQ(histogram->total(), 4U);
  EXPECT_EQ(histogram->underflow() + histogram->overflow(), 0U);
}

}  // namespace
}  // namespace talus::summary_test
