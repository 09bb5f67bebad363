// The pieces of a path make up the whole path: they join end to end in position and time.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/meshes.hpp"
#include "support/scenes.hpp"

namespace talus::pieces_test {
namespace {

using namespace testing_tools;

RockLog log_of_pieces(const TriangleMesh& surface, const Soil& soil, const Laws& laws, const Release& release,
                      std::span<const Barrier> barriers, RockOutcome& outcome, bool keep_pieces = true) {
  RockLog log(true, keep_pieces);
  const Ground ground = ground_of(soil);
  const Draws draws(SamplingPlan{}, 0);
  outcome = follow_rock(Scene<TriangleMesh>{surface, ground, barriers, laws}, release, draws, log);
  return log;
}

Release random_release(Dice& dice, const TriangleMesh& surface, const Laws& laws) {
  Release release;
  release.rock = sphere_of_diameter(dice.between(0.2, 1.5), 2700);
  const double x = dice.between(5, 25), y = dice.between(10, 50);
  const double reach = laws.model == RockModel::rigid_sphere ? release.rock.radius : 0;
  release.motion.position = {x, y, *surface.elevation(x, y) + 4 * reach + dice.between(0, 3)};
  release.motion.velocity = dice.direction() * dice.between(0, 8);
  release.motion.spin = dice.direction() * dice.between(0, 10);
  return release;
}

// A barrier across the slope at x = 40: rocks break through it, bounce off it or pass above.
Barrier fence(const TriangleMesh& surface) {
  Barrier barrier;
  barrier.name = "Fence";
  barrier.capacity = 50e3;
  barrier.restitution = Restitution{0.4, 0.8};
  barrier.set_panels(panels_over(surface.draped({40, 0}, {40, 60}), 1.5, 0));
  return barrier;
}

// A description of the first gap between pieces, if any.
std::string what_is_wrong(const RockLog& log, const RockOutcome& outcome) {
  // A sphere that has sunk in by more than rounding is lifted, at most by this (correct_position() in ground_leg.hpp).
  constexpr double near = 1e-9 * 60;  // relative to the model's size
  const std::vector<PathPiece> pieces = every_piece(log);
  if (pieces.empty()) return "there are none";
  if (pieces.front().path.p != outcome.start.position || pieces.front().path.v != outcome.start.velocity ||
      pieces.front().start_time != 0 || pieces.front().on_ground) {
    return "the first does not begin at the release";
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const PathPiece& piece = pieces[k];
    const bool is_last = k + 1 == pieces.size();
    const std::string which = "piece " + std::to_string(k) + " of " + std::to_string(pieces.size()) + ": ";
    if (!(piece.duration >= 0) || !std::isfinite(piece.duration))
      return which + "lasts " + text(Vec3(piece.duration, 0, 0));
    const double end_time = is_last ? outcome.end.time : pieces[k + 1].start_time;
    if (piece.start_time + piece.duration != end_time) return which + "the next one does not begin when it ends";
    const Vec3 end = piece.path.at(piece.duration), next = is_last ? outcome.end.position : pieces[k + 1].path.p;
    if ((next - end).norm() > near) {
      return which + "ends at " + text(end) + ", the next one begins at " + text(next) +
             (piece.on_ground ? " on the ground" : " in the air");
    }
  }
  return "";
}

TEST(PathPieces, JoinFromTheReleaseToTheEnd) {
  Dice dice(11);
  std::size_t flights = 0, legs = 0, hits = 0;
  std::ptrdiff_t glides = 0;
  for (int slope = 0; slope < 12; ++slope) {
    const TriangleMesh surface = random_slope(dice, 20, 60, dice.between(0.1, 1), dice.magnitude(0.01, 2)).mesh();
    const Barrier barriers[] = {fence(surface)};
    for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
      for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
        for (int k = 0; k < 20; ++k) {
          Laws laws;
          set_model(laws, model);
          laws.sliding = sliding;
          const Soil soil{.rn = dice.between(0, 0.8), .rt = dice.between(0.3, 1), .phi = dice.between(0.1, 0.8)};
          const Release release = random_release(dice, surface, laws);
          RockOutcome outcome;
          const RockLog log = log_of_pieces(surface, soil, laws, release, barriers, outcome);
          ASSERT_EQ(what_is_wrong(log, outcome), "")
              << "slope " << slope << " rock " << k << ' ' << name(outcome.reason);
          for (const PathPiece& piece : every_piece(log)) ++(piece.on_ground ? legs : flights);
          glides += std::ranges::count_if(log.pieces, [](const PathPiece& piece) { return piece.steps.count > 1; });
          hits += log.hits.size();
        }
      }
    }
  }
  EXPECT_GT(flights, 5000U);
  EXPECT_GT(legs, 5000U);
  EXPECT_GT(hits, 100U);
  EXPECT_GT(glides, 500);
}

// No event is inside a flight: the rows of a path are at the ends of pieces.
TEST(PathPieces, EveryFlightEndsAtARow) {
  Dice dice(12);
  const TriangleMesh surface = random_slope(dice, 20, 60, 0.6, 0.5).mesh();
  for (int k = 0; k < 50; ++k) {
    RockOutcome outcome;
    const RockLog log = log_of_pieces(surface, {}, {}, random_release(dice, surface, {}), {}, outcome);
    std::size_t row = 0;
    for (const PathPiece& piece : log.pieces) {
      if (piece.on_ground) continue;
      while (row < log.rows.size() && log.rows[row].motion.time < piece.start_time + piece.duration) ++row;
      ASSERT_LT(row, log.rows.size());
      EXPECT_EQ(log.rows[row].motion.position, piece.path.at(piece.duration));
      EXPECT_EQ(log.rows[row].motion.spin, piece.spin);
    }
  }
}

// Sliding off an edge is no impact, although the path has a row for it.
TEST(PathPieces, ImpactsAreWhereTheRockStrikesTheGround) {
  Dice dice(13);
  // A plateau that ends at x = 10, 8 m above a plain.
  const Vec2 section[] = {{0, 8}, {10, 8}, {10.5, 0}, {60, 0}};
  const TriangleMesh surface = extruded(section, 20, 1, dice).mesh();
  Release release;
  release.rock = sphere_of_mass(1000, 2700);
  release.motion.position = {2, 10, 10};
  release.motion.velocity = {8, 0, 0};
  RockOutcome outcome;
  Laws laws;
  laws.impact = PlainImpact{};
  const RockLog log = log_of_pieces(surface, {.rn = 0, .rt = 1, .phi = 0.1}, laws, release, {}, outcome);
  ASSERT_EQ(log.impact_places.size(), 2U);  // on the plateau, over whose edge it slides, and on the plain
  EXPECT_NEAR(log.impact_places[0].z(), 8, 1e-9);
  EXPECT_LT(log.impact_places[0].x(), 10);
  EXPECT_NEAR(log.impact_places[1].z(), 0, 1e-9);
  EXPECT_EQ(outcome.events, 3);
}

TEST(PathPieces, AreKeptOnlyOnRequest) {
  Dice dice(14);
  const TriangleMesh surface = random_slope(dice, 20, 60, 0.6, 0.5).mesh();
  const Release release = random_release(dice, surface, {});
  RockOutcome with, without;
  const RockLog log = log_of_pieces(surface, {}, {}, release, {}, without, false);
  EXPECT_TRUE(log.pieces.empty());
  EXPECT_TRUE(log.impact_places.empty());
  EXPECT_FALSE(log_of_pieces(surface, {}, {}, release, {}, with).pieces.empty());
  EXPECT_EQ(with.end.position, without.end.position);
}

}  // namespace
}  // namespace talus::pieces_test
