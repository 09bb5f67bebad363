#include "talus/store/path_code.hpp"

#include <algorithm>
#include <cstring>

#include "talus/rocks/rock.hpp"
#include "talus/store/ground_parts.hpp"
#include "talus/store/varint.hpp"

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
  return (a - b).squaredNorm() <= same_digits * same_digits * std::max(a.squaredNorm(), b.squaredNorm());
}
bool are_near_places(const Vec3& a, const Vec3& b) { return (a - b).squaredNorm() <= same_place * same_place; }
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

double inertia_of_sphere(const Rock& rock) { return 0.4 * rock.mass * rock.radius * rock.radius; }

}  // namespace

void PathEncoder::encode(const RockRecord& record, const RockLog& log, std::string& out) {
  cells_.clear();
  items_.clear();
  is_planar_ = is_planar(record, log);
  spin_step_ = spin_step(record.body.radius);
  const Vec2 start = record.outcome.start.position.head(2);
  grid_.add_box({start, start}, cells_);
  put_path(record, log);
  put_facts(record);
  out += facts_.view();
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
  set(rock_is_no_sphere, body.inertia != inertia_of_sphere(body));
  set(start_has_no_velocity, are_same_bits(start.velocity, Vec3::Zero()));
  set(start_has_no_spin, are_same_bits(start.spin, Vec3::Zero()));
  set(end_has_place, !are_same_bits(end.position, now_.position));
  set(end_has_time, end.time != now_.time);
  set(end_has_no_velocity, are_same_bits(end.velocity, Vec3::Zero()));
  set(end_has_velocity, (flags & end_has_no_velocity) == 0 && !are_same_bits(end.velocity, now_.velocity));
  set(end_has_no_spin, are_same_bits(end.spin, Vec3::Zero()));
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

namespace {

/// Reads the items of a path.
class Decoder {
 public:
  Decoder(ByteReader& in, const Vec3& gravity, bool planar, StoredTrajectory& rock)
      : in_(in),
        gravity_(gravity),
        planar_(planar),
        now_(rock.record.outcome.start),
        spin_step_(spin_step(rock.record.body.radius)),
        rock_(rock) {}

  /// Returns the motion at the end of the last piece.
  Motion read() {
    while (in_.left() > 0) {
      const auto tag = in_.get<std::uint8_t>();
      if ((tag & is_piece) == 0) {
        read_row(tag);
        continue;
      }
      read_start(tag);
      for (; departed_ < rock_.rows.size(); ++departed_) {
        if (where_[departed_] == at_departure) rock_.rows[departed_].motion = now_;
      }
      (tag & piece_on_ground) != 0 ? read_part(tag) : read_flight(tag);
      expect_bytes(now_.position.allFinite() && now_.velocity.allFinite() && now_.spin.allFinite() &&
                       std::isfinite(now_.time),
                   "a path is not finite");
    }
    return now_;
  }
  /// The rows at the end of the path.
  void finish(const Motion& end) {
    for (std::size_t k = 0; k < where_.size(); ++k) {
      if (where_[k] == at_path_end) rock_.rows[k].motion = end;
      expect_bytes(k < departed_ || where_[k] != at_departure, "a row has no motion");
    }
  }

 private:
  void read_row(std::uint8_t tag) {
    const int state = tag & row_state, where = (tag & row_where) >> row_where_shift;
    expect_bytes(state <= static_cast<int>(PathState::ended) && (tag & ~(row_state | row_where)) == 0,
                 "a row has no valid tag");
    Motion motion = now_;
    if (where == row_is_given) {
      motion.time = get_number<double>(in_);
      motion.position = get_vector<double>(in_, planar_);
      motion.velocity = get_vector<double>(in_, planar_);
      motion.spin = get_spin<double>(in_, planar_);
    }
    rock_.rows.push_back({static_cast<PathState>(state), motion});
    where_.push_back(where);
  }

  void read_start(std::uint8_t tag) {
    const bool on_ground = (tag & piece_on_ground) != 0;
    if ((tag & piece_has_place) != 0) now_.position = get_vector<double>(in_, planar_);
    if ((tag & piece_has_time) != 0) now_.time = get_number<double>(in_);
    if ((tag & piece_has_velocity) != 0) {
      now_.velocity = on_ground ? Vec3(now_.velocity + vector_of(get_steps(in_, planar_), StoreStep::velocity))
                                : get_vector<double>(in_, planar_);
    }
    if ((tag & piece_has_spin) != 0) {
      now_.spin = on_ground ? Vec3(now_.spin + vector_of(get_spin_steps(in_, planar_), spin_step_))
                            : get_spin<double>(in_, planar_);
    }
  }

  void read_flight(std::uint8_t tag) {
    PathPiece& flight = rock_.pieces.emplace_back();
    flight.path = {now_.position, now_.velocity, gravity_};
    flight.start_time = now_.time;
    flight.spin = now_.spin;
    if ((tag & flight_has_drag) != 0) rate_ = get_number<double>(in_);
    if ((tag & flight_has_path) != 0) {
      flight.drag.rate = rate_;
      if (rate_ != 0) flight.drag.gravity = gravity_;
      flight.path.a = {0, 0, get_number<double>(in_)};
    }
    flight.duration = get_number<double>(in_);
    expect_bytes(flight.duration >= 0, "a flight has a negative duration");
    expect_bytes(flight.drag.rate >= 0 && flight.drag.rate * flight.duration < 1, "a flight has no valid drag");
    now_ = end_of_flight(flight);
  }

  void read_part(std::uint8_t tag) {
    const Motion start = now_;
    if ((tag & part_is_moment) == 0) {
      const double duration = static_cast<double>(get_varint(in_)) * StoreStep::time;
      const Vec3 way = vector_of(get_steps(in_, planar_), StoreStep::place);
      now_.time += duration;
      now_.position += way;
      now_.velocity =
          expected_velocity(start, way, duration) + vector_of(get_steps(in_, planar_), StoreStep::velocity);
      if ((tag & part_has_end_spin) != 0)
        now_.spin = expected_spin(start, now_.velocity) + vector_of(get_spin_steps(in_, planar_), spin_step_);
    }
    rock_.pieces.push_back(ground_part(start, now_));
  }

  ByteReader& in_;
  Vec3 gravity_;
  bool planar_;
  Motion now_;
  double spin_step_;
  double rate_ = 0;  // of drag
  StoredTrajectory& rock_;
  std::vector<int> where_;    // the motions of the rows are
  std::size_t departed_ = 0;  // rows before the last piece
};

}  // namespace

double radius_in(std::string_view bytes) {
  ByteReader in(bytes);
  const std::uint64_t flags = get_varint(in);
  for (int k = (flags & rock_has_ground) != 0 ? 5 : 4; k > 0; --k) (void)get_varint(in);
  (void)in.get<double>();  // mass
  return get_number<double>(in);
}

void decode_path(std::string_view bytes, const Vec3& gravity, StoredTrajectory& rock) {
  rock.pieces.clear();
  rock.rows.clear();
  RockRecord& record = rock.record;
  record = {};
  ByteReader in(bytes);
  const std::uint64_t flags = get_varint(in);
  const bool planar = (flags & rock_is_planar) != 0;
  const auto has = [&](RockFlag flag) { return (flags & flag) != 0; };
  const auto index = [&] {
    const std::uint64_t number = get_varint(in);
    expect_bytes(number <= std::numeric_limits<std::uint32_t>::max(), "a rock has a number that is too large");
    return static_cast<std::uint32_t>(number);
  };
  record.was_lifted = has(rock_was_lifted);
  record.seeder.index = index();
  record.source.index = index();
  RockOutcome& outcome = record.outcome;
  const std::uint32_t reason = index();
  expect_bytes(reason < end_reason_count, "a rock has no valid end reason");
  outcome.reason = static_cast<EndReason>(reason);
  outcome.events = index();
  if (has(rock_has_ground)) outcome.ground = MaterialId{index()};
  record.body.mass = get_number<double>(in);
  record.body.radius = get_number<double>(in);
  record.body.inertia = has(rock_is_no_sphere) ? get_number<double>(in) : inertia_of_sphere(record.body);
  expect_bytes(record.body.mass > 0 && record.body.radius >= 0 && record.body.inertia >= 0, "a rock has no valid size");
  outcome.max_kinetic_energy = get_number<double>(in);
  outcome.max_bounce = get_number<double>(in);
  Motion& start = outcome.start;
  start.position = get_vector<double>(in, planar);
  if (!has(start_has_no_velocity)) start.velocity = get_vector<double>(in, planar);
  if (!has(start_has_no_spin)) start.spin = get_spin<double>(in, planar);
  Motion& end = outcome.end;
  if (has(end_has_place)) end.position = get_vector<double>(in, planar);
  if (has(end_has_time)) end.time = get_number<double>(in);
  if (has(end_has_velocity)) end.velocity = get_vector<double>(in, planar);
  if (has(end_has_spin)) end.spin = get_spin<double>(in, planar);

  Decoder decoder(in, gravity, planar, rock);
  const Motion last = decoder.read();
  if (!has(end_has_place)) end.position = last.position;
  if (!has(end_has_time)) end.time = last.time;
  if (!has(end_has_velocity) && !has(end_has_no_velocity)) end.velocity = last.velocity;
  if (!has(end_has_spin) && !has(end_has_no_spin)) end.spin = last.spin;
  decoder.finish(end);
}

}  // namespace talus
