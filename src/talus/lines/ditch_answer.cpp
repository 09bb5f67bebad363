#include "talus/lines/ditch_answer.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "talus/lines/asked_line.hpp"
#include "talus/model/build_barrier.hpp"

namespace talus {

namespace {

/// The largest distance from the toe on a piece.
double farthest_on(const Ditch& ditch, const PathPiece& piece) {
  const Parabola& path = piece.path;
  double most = std::max(ditch.distance(path.p.x()), ditch.distance(path.at(piece.duration).x()));
  if (path.a.x() != 0) {
    const double turn = -path.v.x() / path.a.x();
    if (turn > 0 && turn < piece.duration) most = std::max(most, ditch.distance(path.at(turn).x()));
  }
  return most;
}

constexpr double by_rounding = 1e-6;  // of the far edge, which may be a barrier or the end of the section [m]

/// The rock's arrival at the first barrier of the ditch; null: it meets none.
const PathRow* first_barrier(const Ditch& ditch, const RockPath& path) {
  const auto found = std::ranges::find_if(path.rows, [&](const PathRow& row) {
    const double distance = ditch.distance(row.motion.position.x());
    return row.state == PathState::barrier && distance >= 0 && distance <= ditch.width() + by_rounding;
  });
  return found == path.rows.end() ? nullptr : &*found;
}

/// Where the rock first touches the ground past the toe before `end` [s]: at an impact, or while it slides or rolls.
std::optional<double> first_impact(const Ditch& ditch, const RockPath& path, double end) {
  const auto is_impact_past = [&](const PathRow& row) {
    return row.state == PathState::impact && row.motion.time < end && ditch.distance(row.motion.position.x()) >= 0;
  };
  const auto is_ground_past = [&](const PathPiece& piece) {
    return piece.on_ground && piece.start_time < end && farthest_on(ditch, piece) > 0;
  };
  const auto impact = std::ranges::find_if(path.rows, is_impact_past);
  const auto ground = std::ranges::find_if(path.pieces, is_ground_past);
  const bool has_impact = impact != path.rows.end(), has_ground = ground != path.pieces.end();
  if (has_impact && (!has_ground || impact->motion.time <= ground->start_time))
    return ditch.distance(impact->motion.position.x());
  if (has_ground) return std::max(0.0, ditch.distance(ground->path.p.x()));
  return std::nullopt;
}

std::optional<RockInDitch> rock_in(const Ditch& ditch, const RockPath& path) {
  const RockOutcome& outcome = path.record.outcome;
  double farthest = ditch.distance(outcome.end.position.x());
  for (const PathPiece& piece : path.pieces) farthest = std::max(farthest, farthest_on(ditch, piece));
  if (farthest < 0) return std::nullopt;
  const PathRow* barrier = first_barrier(ditch, path);
  const double until = barrier ? barrier->motion.time : std::numeric_limits<double>::infinity();
  const double end = ditch.distance(outcome.end.position.x());
  const bool stays = outcome.reason != EndReason::left_model && outcome.reason != EndReason::lost &&
                     outcome.reason != EndReason::no_data;
  return RockInDitch{.rock = path.record.rock,
                     .first_impact = first_impact(ditch, path, until),
                     .at_barrier = barrier ? std::optional(ditch.distance(barrier->motion.position.x())) : std::nullopt,
                     .farthest = farthest,
                     .gets_beyond = farthest > ditch.width() - by_rounding,
                     .ends_inside = stays && end >= 0 && end <= ditch.width()};
}

struct Block {
  std::vector<RockInDitch> arriving;
  std::uint64_t rocks = 0, released_beyond = 0;
  std::optional<Vec3> highest;  // release before the toe
};

void add(const Ditch& ditch, const RockPath& path, Block& block) {
  const Vec3& release = path.record.outcome.start.position;
  if (ditch.distance(release.x()) >= 0) {
    ++block.released_beyond;
    return;
  }
  ++block.rocks;
  if (!block.highest || release.z() > block.highest->z()) block.highest = release;
  if (const auto rock = rock_in(ditch, path)) block.arriving.push_back(*rock);
}

}  // namespace

double Ditch::width() const { return std::abs(far_edge - toe); }

Ditch ditch_between(const Model& model, double toe, double far_edge, std::string_view where) {
  const auto problem = [&](std::string what, std::string why, std::string hint = {}) {
    return Problem{
        .where = std::string(where), .what = std::move(what), .why = std::move(why), .hint = std::move(hint)};
  };
  if (!std::holds_alternative<Profile>(*model.surface))
    throw BadInput(problem("is a stretch of a section", "this run is 3D", "Ask for a line or a polygon"));
  const PlanPlace places[]{{toe, 0}, {far_edge, 0}};
  Problems problems;
  check_places(places, where, problems);
  if (!problems.has_errors()) {
    constexpr double least_width = 1e-3;  // [m]
    if (std::abs(far_edge - toe) < least_width)
      problems.add(problem(fmt::format("is {:.3g} m wide", std::abs(far_edge - toe)), "expected at least 1 mm",
                           "Give the toe, at the foot of the slope, and the far edge"));
    for (const auto& [x, name] : {std::pair(toe, "toe"), std::pair(far_edge, "far edge")}) {
      if (!project::has_ground_at(model, Vec2(x - model.frame.origin.x(), 0)))
        problems.add(
            problem(fmt::format("its {} at x = {:g} is off the section", name, x), "rocks are only known on it"));
    }
  }
  if (problems.has_errors()) throw BadInput(problems);
  return {toe - model.frame.origin.x(), far_edge - model.frame.origin.x()};
}

DitchAnswer ask_ditch(const Model& model, const RockPaths& paths, const Ditch& ditch) {
  constexpr std::size_t in_block = 64;
  const std::size_t count = paths.rocks().size();
  std::vector<Block> blocks((count + in_block - 1) / in_block);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t k) {
    RockPath path;
    for (std::size_t place = k * in_block; place < std::min(count, (k + 1) * in_block); ++place) {
      paths.read(place, path);
      add(ditch, path, blocks[k]);
    }
  });
  DitchAnswer answer;
  std::optional<Vec3> highest;
  for (const Block& block : blocks) {
    answer.rocks += block.rocks;
    answer.released_beyond += block.released_beyond;
    answer.arriving.insert(answer.arriving.end(), block.arriving.begin(), block.arriving.end());
    if (block.highest && (!highest || block.highest->z() > highest->z())) highest = block.highest;
  }
  // At the foot of a vertical face, that of the ground past it.
  const double past = std::copysign(1e-6, ditch.far_edge - ditch.toe);
  const auto toe = std::get<Profile>(*model.surface).elevation(ditch.toe + past);
  if (highest && toe && highest->z() > *toe) {
    const double height = highest->z() - *toe;
    answer.slope = SlopeAbove{height, std::atan2(height, -ditch.distance(highest->x()))};
  }
  return answer;
}

}  // namespace talus
