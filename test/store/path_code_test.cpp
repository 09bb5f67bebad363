// Paths of simulated rocks as bytes, and back: what is promised exactly, and what within a tolerance.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "store/stored_models.hpp"
#include "talus/store/ground_parts.hpp"
#include "talus/store/path_code.hpp"
#include "talus/store/store_facts.hpp"

namespace talus {
namespace {

using store_test::model_of;
using store_test::models;
using store_test::NamedModel;

constexpr std::uint64_t most_rocks = 60;

bool are_same(const Vec3& a, const Vec3& b) { return a == b; }
bool are_same(const Motion& a, const Motion& b) {
  return a.position == b.position && a.velocity == b.velocity && a.spin == b.spin && a.time == b.time;
}

/// A rock, and what the store makes of it.
struct Both {
  RockRecord record;
  RockLog log{true, true};
  StoredTrajectory stored;
  std::string bytes;
};

std::vector<Both> rocks_of(const NamedModel& named) {
  const Model model = model_of(named);
  const StoreFacts facts = StoreFacts::of(model);
  PathEncoder encoder(facts.gravity, facts.grid);
  Simulator simulator(model);
  std::vector<Both> rocks;
  const std::uint64_t step = std::max<std::uint64_t>(1, model.rocks() / most_rocks);
  for (std::uint64_t rock = 0; rock < model.rocks(); rock += step) {
    Both& both = rocks.emplace_back();
    both.record = simulator.simulate(rock, true, true);
    both.log = simulator.log();
    encoder.encode(both.record, both.log, both.bytes);
    decode_path(both.bytes, facts.gravity, both.stored);
  }
  return rocks;
}

class StoredPaths : public ::testing::TestWithParam<NamedModel> {
 protected:
  std::vector<Both> rocks_ = rocks_of(GetParam());
};

TEST_P(StoredPaths, RecordsAreExact) {
  for (const Both& rock : rocks_) {
    const RockRecord &is = rock.stored.record, &was = rock.record;
    EXPECT_EQ(is.seeder, was.seeder);
    EXPECT_EQ(is.source, was.source);
    EXPECT_EQ(is.was_lifted, was.was_lifted);
    EXPECT_EQ(is.body.mass, was.body.mass);
    EXPECT_EQ(is.body.radius, was.body.radius);
    EXPECT_EQ(is.body.inertia, was.body.inertia);
    EXPECT_TRUE(are_same(is.outcome.start, was.outcome.start));
    EXPECT_TRUE(are_same(is.outcome.end, was.outcome.end));
    EXPECT_EQ(is.outcome.reason, was.outcome.reason);
    EXPECT_EQ(is.outcome.events, was.outcome.events);
    EXPECT_EQ(is.outcome.max_kinetic_energy, was.outcome.max_kinetic_energy);
    EXPECT_EQ(is.outcome.max_bounce, was.outcome.max_bounce);
    EXPECT_EQ(is.outcome.ground, was.outcome.ground);
  }
}

TEST_P(StoredPaths, FlightsAreExact) {
  for (const Both& rock : rocks_) {
    auto stored = rock.stored.pieces.begin();
    const auto end = rock.stored.pieces.end();
    for (const PathPiece& flight : rock.log.pieces) {
      if (flight.on_ground) continue;
      stored = std::find_if(stored, end, [](const PathPiece& piece) { return !piece.on_ground; });
      ASSERT_NE(stored, end);
      EXPECT_TRUE(are_same(stored->path.p, flight.path.p));
      EXPECT_TRUE(are_same(stored->path.v, flight.path.v));
      EXPECT_TRUE(are_same(stored->path.a, flight.path.a));
      EXPECT_TRUE(are_same(stored->spin, flight.spin));
      EXPECT_EQ(stored->duration, flight.duration);
      EXPECT_EQ(stored->start_time, flight.start_time);
      EXPECT_EQ(stored->drag.rate, flight.drag.rate);
      EXPECT_TRUE(are_same(stored->drag.gravity, flight.drag.gravity));
      ++stored;
    }
    EXPECT_TRUE(std::none_of(stored, end, [](const PathPiece& piece) { return !piece.on_ground; }));
  }
}

TEST_P(StoredPaths, RowsAreExactOrNearThem) {
  std::size_t all = 0, near = 0;
  for (const Both& rock : rocks_) {
    const auto &is = rock.stored.rows, &was = rock.log.rows;
    ASSERT_EQ(is.size(), was.size());
    for (std::size_t k = 0; k < is.size(); ++k) {
      EXPECT_EQ(is[k].state, was[k].state);
      ++all;
      if (are_same(is[k].motion, was[k].motion)) continue;
      ++near;
      EXPECT_NE(was[k].state, PathState::projectile);
      EXPECT_NE(was[k].state, PathState::ended);
      EXPECT_LE((is[k].motion.position - was[k].motion.position).norm(), StoreStep::place);
      EXPECT_LE((is[k].motion.velocity - was[k].motion.velocity).norm(), StoreStep::velocity);
      EXPECT_LE((is[k].motion.spin - was[k].motion.spin).norm(), StoreStep::velocity / rock.record.body.radius);
      EXPECT_NEAR(is[k].motion.time, was[k].motion.time, StoreStep::time);
    }
  }
  EXPECT_GT(all, 2 * near);
}

TEST_P(StoredPaths, MotionAlongTheGroundIsNear) {
  for (const Both& rock : rocks_) {
    std::size_t at = 0;
    const auto& stored = rock.stored.pieces;
    rock.log.for_each_piece([&](const PathPiece& leg) {
      if (!leg.on_ground || leg.duration < 1e-6) return;
      const double time = leg.start_time + leg.duration, middle = leg.start_time + 0.5 * leg.duration;
      while (at < stored.size() && stored[at].time(stored[at].duration) < middle) ++at;
      ASSERT_LT(at, stored.size());
      const PathPiece& part = stored[at];
      ASSERT_TRUE(part.on_ground);
      const double s = std::min(time - part.start_time, part.duration);
      const double largest = std::max(part.ends.start_velocity.norm(), part.ends.end_velocity.norm());
      const double largest_spin = std::max(part.spin.norm(), part.ends.end_spin.norm());
      // Its times are rounded, too.
      EXPECT_LT((part.path.at(s) - leg.path.at(leg.duration)).norm(),
                StoreTolerance::position + StoreStep::time * largest);
      EXPECT_LE((part.velocity(s) - leg.ends.end_velocity).norm(),
                StoreTolerance::velocity * largest + 2 * StoreStep::velocity);
      const double spin_change = (part.ends.end_spin - part.spin).norm() / part.duration;
      EXPECT_LE((part.spin_at(s) - leg.ends.end_spin).norm(), StoreTolerance::velocity * largest_spin +
                                                                  2 * StoreStep::velocity / rock.record.body.radius +
                                                                  StoreStep::time * spin_change);
    });
  }
}

TEST_P(StoredPaths, PiecesJoinAndAreCompact) {
  std::size_t bytes = 0, events = 0, parts = 0, attitudes = 0;
  for (const Both& rock : rocks_) {
    bytes += rock.bytes.size();
    events += rock.log.rows.size();
    attitudes += rock.stored.attitudes.size();
    parts += static_cast<std::size_t>(std::ranges::count_if(rock.stored.pieces, &PathPiece::on_ground));
    double time = 0;
    Vec3 place = rock.stored.record.outcome.start.position;
    for (const PathPiece& piece : rock.stored.pieces) {
      EXPECT_NEAR(piece.start_time, time, StoreStep::time);
      EXPECT_LE((piece.path.p - place).norm(), StoreStep::place);
      time = piece.time(piece.duration);
      place = piece.path.at(piece.duration);
    }
    EXPECT_NEAR(time, rock.record.outcome.end.time, StoreStep::time);
    EXPECT_LE((place - rock.record.outcome.end.position).norm(), StoreStep::place);
  }
  EXPECT_LT(static_cast<double>(bytes), GetParam().most_bytes * static_cast<double>(events));
  EXPECT_LT(static_cast<double>(bytes), 40 * static_cast<double>(events + parts) + 64 * static_cast<double>(attitudes));
}

TEST_P(StoredPaths, TurnsAreNear) {
  for (const Both& rock : rocks_) {
    const auto &stored = rock.stored.attitudes, &was = rock.log.attitudes;
    ASSERT_EQ(rock.stored.record.block.has_value(), rock.record.block.has_value());
    ASSERT_EQ(stored.empty(), was.empty());
    if (was.empty()) continue;
    const BlockRecord &is = *rock.stored.record.block, &block = *rock.record.block;
    EXPECT_EQ(is.axes, block.axes);
    EXPECT_EQ(is.inertia, block.inertia);
    EXPECT_EQ(is.short_axis_share, block.short_axis_share);
    for (const Attitude& attitude : was) {
      const Orientation turned = orientation_at(stored, is.inertia, attitude.time);
      EXPECT_LE(angle_between(turned, attitude.orientation), max_turn_left_out + 1e-7);
    }
    for (std::size_t k = 0; k < rock.log.rows.size(); ++k) {
      ASSERT_TRUE(rock.stored.rows[k].orientation && rock.log.rows[k].orientation);
      EXPECT_LE(angle_between(*rock.stored.rows[k].orientation, *rock.log.rows[k].orientation),
                max_turn_left_out + 1e-4);  // rows on the ground have rounded times
    }
    EXPECT_LT(stored.size(), was.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Store, StoredPaths, ::testing::ValuesIn(models),
                         [](const auto& about) { return about.param.name; });

TEST(PathCode, CutOrChangedBytesAreRefusedOrRead) {
  const std::vector<Both> rocks = rocks_of(models.front());
  const Vec3 gravity(0, 0, -9.80665);
  int refused = 0;
  StoredTrajectory into;
  for (const Both& rock : rocks) {
    for (std::size_t k = 0; k < rock.bytes.size(); ++k) {
      std::string changed = rock.bytes;
      changed[k] = static_cast<char>(changed[k] ^ 0x81);
      for (const std::string& bytes : {rock.bytes.substr(0, k), changed}) {
        try {
          decode_path(bytes, gravity, into);
        } catch (const BadBytes&) {
          ++refused;
        }
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

/// Their checksums may be right, but energies and distances would not be finite.
TEST(PathCode, OfNumbersBeyondAnyRunAreRefused) {
  const Vec3 gravity(0, 0, -9.80665);
  int tried = 0;
  StoredTrajectory into;
  for (const Both& rock : rocks_of(models.front())) {
    for (const double number : {rock.record.body.mass, rock.record.body.radius, rock.record.outcome.start.position.x(),
                                rock.record.outcome.start.velocity.x(), rock.record.outcome.max_kinetic_energy}) {
      const std::size_t place = rock.bytes.find(std::string(reinterpret_cast<const char*>(&number), sizeof number));
      if (number == 0 || place == std::string::npos) continue;
      ++tried;
      for (const double wrong :
           {1e300, 1e31, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        std::string bytes = rock.bytes;
        std::memcpy(bytes.data() + place, &wrong, sizeof wrong);
        EXPECT_THROW(decode_path(bytes, gravity, into), BadBytes) << number << " as " << wrong;
      }
    }
  }
  EXPECT_GT(tried, 50);
}

/// The steps of a spin are those of the surface: of a rock without extent they would have no end.
TEST(PathCode, OfARockThatSpinsWithoutEndIsRefused) {
  const auto all = rocks_of(models[1]);  // spheres
  const auto rolls = [](const Both& rock) {
    return std::ranges::any_of(rock.stored.pieces, [](const PathPiece& piece) {
      return piece.on_ground && piece.ends.end_spin != piece.spin;
    });
  };
  const auto rock = std::ranges::find_if(all, rolls);
  ASSERT_NE(rock, all.end());
  std::string bytes = rock->bytes;
  const std::size_t place = bytes.find(std::string(reinterpret_cast<const char*>(&rock->record.body.radius), 8));
  ASSERT_NE(place, std::string::npos);
  const double tiny = std::numeric_limits<double>::denorm_min();
  std::memcpy(bytes.data() + place, &tiny, sizeof tiny);
  StoredTrajectory into;
  EXPECT_THROW(decode_path(bytes, Vec3(0, 0, -9.80665), into), BadBytes);
}

}  // namespace
}  // namespace talus
