#include "talus/store/path_code.hpp"

#include <algorithm>
#include <cstring>

#include "talus/store/attitude_choice.hpp"
#include "talus/store/ground_parts.hpp"

namespace talus {

namespace {

// Motions of the run that are the same but for rounding.
constexpr double same_place = 1e-5;  // [m]
constexpr double same_time = 1e-9;   // [s]
constexpr double same_digits = 2e-7;

bool are_same_bits(const Vec3& a, const Vec3& b) { return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0; }
bool are_same_bits(const Motion& a, const Motion& b) {
  return a.time == b.time && are_same_bits(a.position, b.position) && are_same_bits(a.velocity, b.velocity) &&
         are_same_bits(a.spin, b.spin);
}
bool are_near(const Vec3& a, const Vec3& b) {
  return (a - b).squared_norm() <= same_digits * same_digits * std::max(a.squared_norm(), b.squared_norm());
}
bool are_near_places(const Vec3& a, const Vec3& b) { return (a - b).squared_norm() <= same_place * same_place; }
bool are_near(const Motion& a, const Motion& b) {
  return std::abs(a.time - b.time) <= same_time && are_near_places(a.position, b.position) &&
         are_near(a.velocity, b.velocity) && are_near(a.spin, b.spin);
}

Motion start_of_piece(const PathPiece& piece) {
  return {piece.path.p, piece.on_ground ? piece.ends.start_velocity : piece.path.v, piece.spin, piece.start_time};
}

bool is_planar(const Motion& motion) {
  return motion.position.y() == 0 && motion.velocity.y() == 0 && motion.spin.x() == 0 && motion.spin.z() == 0;
}
bool is_planar(const RockRecord& record, const RockLog& log) {
  const auto moves_in_plane = [](const PathPiece& piece) {
    return is_planar(start_of_piece(piece)) && piece.path.v.y() == 0 && piece.path.a.y() == 0 &&
           piece.ends.end_velocity.y() == 0 && piece.ends.end_spin.x() == 0 && piece.ends.end_spin.z() == 0;
  };
  return is_planar(record.outcome.start) && is_planar(record.outcome.end) &&
         std::ranges::all_of(log.pieces, moves_in_plane) &&
         std::ranges::all_of(log.rows, [](const PathRow& row) { return is_planar(row.motion); });
}

}  // namespace

void PathEncoder::encode(const RockRecord& record, const RockLog& log, std::string& out) {
  cells_.clear();
  items_.clear();
  is_planar_ = is_planar(record, log);
  spin_step_ = spin_step(record.body.radius);
  const Vec2 start = record.outcome.start.position.xy();
  grid_.add_box({start, start}, cells_);
  put_path(record, log);
  put_facts(record);
  out += facts_.view();
  if (record.block) {
    put_attitudes(*record.block, log);
    out += attitudes_.view();
  }
  out += items_.view();
}

void PathEncoder::put_facts(const RockRecord& record) {
  facts_.clear();
  facts_.make_room();
  const auto& [start, end, reason, events, max_kinetic_energy, max_bounce, ground] = record.outcome;
  const Rock& body = record.body;
  std::uint32_t flags = 0;
  const auto set = [&](RockFlag flag, bool is_set) { flags |= is_set ? flag : 0U; };
  set(rock_is_planar, is_planar_);
  set(rock_was_lifted, record.was_lifted);
  set(rock_has_ground, ground.has_value());
  set(rock_is_no_sphere, body.inertia != inertia_of_sphere(body.mass, body.radius));
  set(start_has_no_velocity, are_same_bits(start.velocity, Vec3{}));
  set(start_has_no_spin, are_same_bits(start.spin, Vec3{}));
  set(end_has_place, !are_same_bits(end.position, now_.position));
  set(end_has_time, end.time != now_.time);
  set(end_has_no_velocity, are_same_bits(end.velocity, Vec3{}));
  set(end_has_velocity, (flags & end_has_no_velocity) == 0 && !are_same_bits(end.velocity, now_.velocity));
  set(end_has_no_spin, are_same_bits(end.spin, Vec3{}));
  set(rock_is_block, record.block.has_value());
  set(end_has_spin, (flags & end_has_no_spin) == 0 && !are_same_bits(end.spin, now_.spin));

  facts_.put_varint(flags);
  facts_.put_varint(record.seeder.index);
  facts_.put_varint(record.source.index);
  facts_.put_varint(static_cast<std::uint64_t>(reason));
  facts_.put_varint(static_cast<std::uint64_t>(events));
  if (ground) facts_.put_varint(ground->index);
  for (const double x : {body.mass, body.radius}) facts_.put(x);
  if ((flags & rock_is_no_sphere) != 0) facts_.put(body.inertia);
  for (const double x : {max_kinetic_energy, max_bounce}) facts_.put(x);
  facts_.put_vector<double>(start.position, is_planar_);
  if ((flags & start_has_no_velocity) == 0) facts_.put_vector<double>(start.velocity, is_planar_);
  if ((flags & start_has_no_spin) == 0) facts_.put_spin<double>(start.spin, is_planar_);
  if ((flags & end_has_place) != 0) facts_.put_vector<double>(end.position, is_planar_);
  if ((flags & end_has_time) != 0) facts_.put(end.time);
  if ((flags & end_has_velocity) != 0) facts_.put_vector<double>(end.velocity, is_planar_);
  if ((flags & end_has_spin) != 0) facts_.put_spin<double>(end.spin, is_planar_);
}

void PathEncoder::put_attitudes(const BlockRecord& block, const RockLog& log) {
  attitudes_.clear();
  attitudes_.make_room();
  for (const Vec3& v : {block.axes, block.inertia}) attitudes_.put_vector<double>(v, false);
  attitudes_.put(block.short_axis_share);
  divide_into_turns(log.attitudes, block.inertia, max_turn_left_out, kept_);
  attitudes_.put_varint(kept_.size());
  for (const std::size_t k : kept_) {
    const auto& [time, orientation, spin] = log.attitudes[k];
    attitudes_.make_room();
    attitudes_.put(time);
    attitudes_.put(orientation.w());
    attitudes_.put_vector<double>(orientation.xyz(), false);
    attitudes_.put_vector<double>(spin, false);
  }
}

void PathEncoder::put_path(const RockRecord& record, const RockLog& log) {
  const Motion& end = record.outcome.end;
  now_ = record.outcome.start;
  rate_ = 0;
  ground_.clear();
  Motion here = now_;  // in the run, between two pieces
  bool is_exact = true;
  std::size_t next = 0;
  const auto end_time = [&](std::size_t k) {
    return k + 1 < log.pieces.size() ? log.pieces[k + 1].start_time : end.time;
  };
  const auto take_piece = [&] {
    const PathPiece& piece = log.pieces[next];
    if (piece.on_ground) {
      add_ground(log, piece, end_time(next));
      here = ground_.back();
    } else {
      put_ground();
      put_flight(piece);
      here = now_;
    }
    is_exact = !piece.on_ground;
    ++next;
  };
  for (const PathRow& row : log.rows) {
    while (true) {
      const bool has_next = next < log.pieces.size();
      int where = row_is_given;
      if (row.state == PathState::ended && are_same_bits(row.motion, end)) {
        while (next < log.pieces.size()) take_piece();
        where = at_path_end;
      } else if (!has_next && are_same_bits(row.motion, end)) {
        where = at_path_end;
      } else if (is_exact && are_same_bits(row.motion, here)) {
        where = at_arrival;
      } else if (has_next && are_same_bits(row.motion, start_of_piece(log.pieces[next]))) {
        where = at_departure;
      } else if (!is_exact && are_near(row.motion, here)) {
        where = at_arrival;
      } else if (has_next && end_time(next) <= row.motion.time) {
        take_piece();
        continue;
      }
      put_ground();
      put_row(row, where);
      break;
    }
  }
  while (next < log.pieces.size()) take_piece();
  put_ground();
}

void PathEncoder::put_row(const PathRow& row, int where) {
  items_.make_room();
  items_.put_tag(static_cast<int>(row.state) | (where << row_where_shift));
  if (where != row_is_given) return;
  items_.put(row.motion.time);
  items_.put_vector<double>(row.motion.position, is_planar_);
  items_.put_vector<double>(row.motion.velocity, is_planar_);
  items_.put_spin<double>(row.motion.spin, is_planar_);
}

void PathEncoder::put_flight(const PathPiece& flight) {
  const auto& [path, duration, start_time, spin, on_ground, facet, drag, steps, ends] = flight;
  int tag = is_piece;
  if (!are_same_bits(path.p, now_.position)) tag |= piece_has_place;
  if (start_time != now_.time) tag |= piece_has_time;
  if (!are_same_bits(path.v, now_.velocity)) tag |= piece_has_velocity;
  if (!are_same_bits(spin, now_.spin)) tag |= piece_has_spin;
  if (drag.rate != 0 || !are_same_bits(path.a, gravity_)) tag |= flight_has_path;
  if ((tag & flight_has_path) != 0 && drag.rate != rate_) tag |= flight_has_drag;
  items_.make_room();
  items_.put_tag(tag);
  if ((tag & piece_has_place) != 0) items_.put_vector<double>(path.p, is_planar_);
  if ((tag & piece_has_time) != 0) items_.put(start_time);
  if ((tag & piece_has_velocity) != 0) items_.put_vector<double>(path.v, is_planar_);
  if ((tag & piece_has_spin) != 0) items_.put_spin<double>(spin, is_planar_);
  if ((tag & flight_has_drag) != 0) items_.put(rate_ = drag.rate);
  if ((tag & flight_has_path) != 0) items_.put(path.a.z());
  items_.put(duration);
  now_ = end_of_flight(flight);
  grid_.add_piece(flight, cells_);
}

void PathEncoder::add_ground(const RockLog& log, const PathPiece& piece, double end_time) {
  const Motion start = start_of_piece(piece);
  if (ground_.empty() || !are_near(ground_.back(), start)) {
    put_ground();
    ground_.push_back(start);
  }
  const auto& [first, count, timestep, down, aside] = piece.steps;
  if (count == 0) {
    ground_.push_back({piece.path.at(piece.duration), piece.ends.end_velocity, piece.ends.end_spin, end_time});
    return;
  }
  // A glide straight down has constant acceleration: some of its steps tell as much as all.
  const auto is_straight = [](const GlideStep& step) { return std::abs(step.vy) <= 1e-6 * std::abs(step.vx); };
  const bool is_even = is_straight(log.glide_steps[first]) && is_straight(log.glide_steps[first + count - 1]);
  const std::size_t stride = is_even ? (count + 3) / 4 : 1;
  for (std::size_t k = std::min(stride, count);; k = std::min(k + stride, count)) {
    const GlideStep& step = log.glide_steps[first + k - 1];
    ground_.push_back({start.position + step.x * down + step.y * aside, step.vx * down + step.vy * aside, start.spin,
                       k == count ? end_time : start.time + static_cast<double>(k) * timestep});
    if (k == count) return;
  }
}

void PathEncoder::put_ground() {
  if (ground_.empty()) return;
  ends_.clear();
  divide_into_parts(ground_, ends_);
  std::size_t from = 0;
  for (const std::size_t to : ends_) put_part(ground_[std::exchange(from, to)], ground_[to]);
  ground_.clear();
}

void PathEncoder::put_part(const Motion& from, const Motion& to) {
  // What is less than a step away from the present motion is not said: a part leads from there.
  int tag = is_piece | piece_on_ground;
  Motion start = now_;
  Steps velocity_change{}, spin_change{};
  if ((from.position - now_.position).norm() > StoreStep::place) {
    tag |= piece_has_place;
    start.position = from.position;
  }
  if (std::abs(from.time - now_.time) > StoreStep::time) {
    tag |= piece_has_time;
    start.time = from.time;
  }
  if ((from.velocity - now_.velocity).norm() > StoreStep::velocity) {
    tag |= piece_has_velocity;
    velocity_change = steps_of(from.velocity - now_.velocity, StoreStep::velocity);
    start.velocity = now_.velocity + vector_of(velocity_change, StoreStep::velocity);
  }
  if ((from.spin - now_.spin).norm() > spin_step_) {
    tag |= piece_has_spin;
    spin_change = steps_of(from.spin - now_.spin, spin_step_);
    start.spin = now_.spin + vector_of(spin_change, spin_step_);
  }
  Motion end = start;
  const auto ticks = std::max<std::int64_t>(0, std::llround((to.time - start.time) / StoreStep::time));
  const Steps way = steps_of(to.position - start.position, StoreStep::place);
  Steps end_velocity{}, end_spin{};
  if (ticks == 0 && are_near(from, to)) {
    tag |= part_is_moment;
  } else {
    const double duration = static_cast<double>(ticks) * StoreStep::time;
    const Vec3 moved = vector_of(way, StoreStep::place);
    const Vec3 velocity = expected_velocity(start, moved, duration);
    end_velocity = steps_of(to.velocity - velocity, StoreStep::velocity);
    end = {start.position + moved, velocity + vector_of(end_velocity, StoreStep::velocity), start.spin,
           start.time + duration};
    if ((to.spin - start.spin).norm() > spin_step_) {
      tag |= part_has_end_spin;
      const Vec3 spin = expected_spin(start, end.velocity);
      end_spin = steps_of(to.spin - spin, spin_step_);
      end.spin = spin + vector_of(end_spin, spin_step_);
    }
  }
  items_.make_room();
  items_.put_tag(tag);
  if ((tag & piece_has_place) != 0) items_.put_vector<double>(start.position, is_planar_);
  if ((tag & piece_has_time) != 0) items_.put(start.time);
  if ((tag & piece_has_velocity) != 0) items_.put_steps(velocity_change, is_planar_);
  if ((tag & piece_has_spin) != 0) items_.put_spin_steps(spin_change, is_planar_);
  if ((tag & part_is_moment) == 0) {
    items_.put_varint(static_cast<std::uint64_t>(ticks));
    items_.put_steps(way, is_planar_);
    items_.put_steps(end_velocity, is_planar_);
    if ((tag & part_has_end_spin) != 0) items_.put_spin_steps(end_spin, is_planar_);
  }
  now_ = end;
  grid_.add_piece(ground_part(start, end), cells_);
}

}  // namespace talus
