#include "talus/store/path_code.hpp"

#include <algorithm>
#include <limits>

#include "talus/rocks/energy.hpp"
#include "talus/store/varint.hpp"

namespace talus {

namespace {

/// Expects a motion with which a rock could be in a run.
void expect_possible(const Motion& motion, const Rock& body) {
  expect_bytes(motion.position.abs().largest() <= largest_number && std::abs(motion.time) <= largest_number &&
                   kinetic_energy(body, motion) <= largest_number,
               "a motion is beyond any run");
}

void read_block(ByteReader& in, StoredTrajectory& rock) {
  BlockRecord& block = rock.record.block.emplace();
  block.axes = get_vector<double>(in, false);
  block.inertia = get_vector<double>(in, false);
  block.short_axis_share = get_number<double>(in);
  const auto [least, most] = std::minmax({block.inertia.x(), block.inertia.y(), block.inertia.z()});
  expect_bytes(least > 0 && least >= 1e-9 * most, "a block has no valid moments");
  const std::uint64_t count = get_varint(in);
  constexpr std::uint64_t bytes_each = 8 * sizeof(double);
  expect_bytes(count > 0 && count <= in.left() / bytes_each, "a block has no valid number of attitudes");
  rock.attitudes.reserve(count);
  double last = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto time = get_number<double>(in), w = get_number<double>(in);
    const Vec3 v = get_vector<double>(in, false), spin = get_vector<double>(in, false);
    expect_bytes(time >= last, "attitudes are not in the order of time");
    const double norm = w * w + v.squared_norm();
    expect_bytes(std::abs(norm - 1) < 1e-6, "an attitude is not a turn");
    expect_bytes(most * spin.squared_norm() <= largest_number, "a block turns faster than in any run");
    rock.attitudes.push_back({last = time, Orientation::of_unit(w, v), spin});
  }
}

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
      expect_possible(now_, rock_.record.body);
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
      expect_possible(motion, rock_.record.body);
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
      now_.velocity = expected_velocity(start, way, duration) + vector_of(get_steps(in_, planar_), StoreStep::velocity);
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
  rock.attitudes.clear();
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
  record.body.inertia =
      has(rock_is_no_sphere) ? get_number<double>(in) : inertia_of_sphere(record.body.mass, record.body.radius);
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

  if (has(rock_is_block)) read_block(in, rock);

  Decoder decoder(in, gravity, planar, rock);
  const Motion last = decoder.read();
  if (!has(end_has_place)) end.position = last.position;
  if (!has(end_has_time)) end.time = last.time;
  if (!has(end_has_velocity) && !has(end_has_no_velocity)) end.velocity = last.velocity;
  if (!has(end_has_spin) && !has(end_has_no_spin)) end.spin = last.spin;
  for (const Motion* motion : {&start, &end}) expect_possible(*motion, record.body);
  decoder.finish(end);
  if (rock.attitudes.empty()) return;
  for (PathRow& row : rock.rows)
    row.orientation = orientation_at(rock.attitudes, record.block->inertia, row.motion.time);
}

}  // namespace talus
