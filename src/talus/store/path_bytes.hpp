#pragma once
// What writer and reader of a path's bytes share: the tags and flags, and vectors as numbers. Private to store/.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "talus/core/bytes.hpp"
#include "talus/rocks/motion.hpp"
#include "talus/rocks/rock.hpp"
#include "talus/store/ground_parts.hpp"
#include "talus/store/varint.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

/// Flags of a rock. Its motion at the release and at the end need not be given.
enum RockFlag : std::uint32_t {
  rock_is_planar = 1,
  rock_was_lifted = 2,
  rock_has_ground = 4,
  rock_is_no_sphere = 8,  // its inertia is given
  start_has_no_velocity = 0x10,
  start_has_no_spin = 0x20,
  end_has_place = 0x40,  // otherwise that of the end of the last piece
  end_has_time = 0x80,
  end_has_velocity = 0x100,  // neither this nor the next: that of the end of the last piece
  end_has_no_velocity = 0x200,
  end_has_spin = 0x400,
  end_has_no_spin = 0x800,
  rock_is_block = 0x1000,  // its axes, moments and attitudes are given
};

/// Tags of a row: state and where its motion is.
enum RowTag : std::uint8_t { row_state = 0x07, row_where = 0x30, row_where_shift = 4 };
enum RowWhere { at_arrival, at_departure, row_is_given, at_path_end };

/// Tags of a piece.
enum PieceTag : std::uint8_t {
  is_piece = 0x80,
  piece_on_ground = 0x40,
  piece_has_place = 0x01,  // of its start
  piece_has_time = 0x02,
  piece_has_velocity = 0x04,
  piece_has_spin = 0x08,
  flight_has_path = 0x10,  // a vertical acceleration other than gravity
  flight_has_drag = 0x20,  // with that: a rate of drag other than in the flight before with one
  part_is_moment = 0x10,   // no duration, and no change
  part_has_end_spin = 0x20,
};

/// A vector as whole numbers of steps.
using Steps = std::array<std::int64_t, 3>;

[[nodiscard]] inline Steps steps_of(const Vec3& v, double step) {
  return {std::llround(v.x() / step), std::llround(v.y() / step), std::llround(v.z() / step)};
}
[[nodiscard]] inline Vec3 vector_of(const Steps& steps, double step) {
  return {static_cast<double>(steps[0]) * step, static_cast<double>(steps[1]) * step,
          static_cast<double>(steps[2]) * step};
}

/// Bytes of short items: room is made once for each, so that putting a number is a move.
class ByteBuffer {
 public:
  /// Room for an item, and all facts of a rock, of up to this many bytes.
  void make_room() {
    constexpr std::size_t longest_item = 512;
    if (bytes_.size() - size_ < longest_item) bytes_.resize(2 * bytes_.size() + longest_item);
  }
  template <PlainNumber Number>
  void put(Number x) {
    std::memcpy(bytes_.data() + size_, &x, sizeof x);
    size_ += sizeof x;
  }
  /// A whole number of any sign: 0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ...
  void put_signed(std::int64_t value) {
    put_varint((static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63));
  }
  void put_steps(const Steps& steps, bool is_planar) {
    put_signed(steps[0]);
    if (!is_planar) put_signed(steps[1]);
    put_signed(steps[2]);
  }
  void put_spin_steps(const Steps& steps, bool is_planar) {
    if (is_planar) return put_signed(steps[1]);
    put_steps(steps, false);
  }
  void put_tag(int tag) { put(static_cast<std::uint8_t>(tag)); }
  void put_varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7U) put(static_cast<std::uint8_t>(value | 0x80U));
    put(static_cast<std::uint8_t>(value));
  }
  /// In a plane y = 0, positions and velocities have x and z, spins y only.
  template <PlainNumber Number>
  void put_vector(const Vec3& v, bool is_planar) {
    put(static_cast<Number>(v.x()));
    if (!is_planar) put(static_cast<Number>(v.y()));
    put(static_cast<Number>(v.z()));
  }
  template <PlainNumber Number>
  void put_spin(const Vec3& w, bool is_planar) {
    if (is_planar) return put(static_cast<Number>(w.y()));
    put_vector<Number>(w, false);
  }
  void clear() { size_ = 0; }
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }

 private:
  std::vector<char> bytes_;
  std::size_t size_ = 0;
};

/// Beyond any number of a run, whose settings are limited (project/settings/limits.hpp); energies and distances of
/// smaller numbers are finite.
inline constexpr double largest_number = 1e30;

template <class Number>
[[nodiscard]] double get_number(ByteReader& in) {
  const auto x = static_cast<double>(in.get<Number>());
  expect_bytes(std::abs(x) <= largest_number, "a number is beyond any run");
  return x;
}
template <class Number>
[[nodiscard]] Vec3 get_vector(ByteReader& in, bool is_planar) {
  Vec3 v;
  v.x() = get_number<Number>(in);
  if (!is_planar) v.y() = get_number<Number>(in);
  v.z() = get_number<Number>(in);
  return v;
}
template <class Number>
[[nodiscard]] Vec3 get_spin(ByteReader& in, bool is_planar) {
  if (is_planar) return {0, get_number<Number>(in), 0};
  return get_vector<Number>(in, false);
}

[[nodiscard]] inline std::int64_t get_signed(ByteReader& in) {
  const std::uint64_t value = get_varint(in);
  return static_cast<std::int64_t>(value >> 1U) ^ -static_cast<std::int64_t>(value & 1U);
}
[[nodiscard]] inline Steps get_steps(ByteReader& in, bool is_planar) {
  Steps steps{};
  steps[0] = get_signed(in);
  if (!is_planar) steps[1] = get_signed(in);
  steps[2] = get_signed(in);
  return steps;
}
[[nodiscard]] inline Steps get_spin_steps(ByteReader& in, bool is_planar) {
  if (is_planar) return {0, get_signed(in), 0};
  return get_steps(in, false);
}

/// The step of a rock's spin [rad/s].
[[nodiscard]] inline double spin_step(double radius) { return StoreStep::velocity / (radius > 0 ? radius : 1); }

/// The velocity at the end of a part, if its acceleration were constant on the way.
[[nodiscard]] inline Vec3 expected_velocity(const Motion& start, const Vec3& way, double duration) {
  return duration > 0 ? 2 / duration * way - start.velocity : start.velocity;
}
/// The spin there, if the rock rolls on with the same axis.
[[nodiscard]] inline Vec3 expected_spin(const Motion& start, const Vec3& end_velocity) {
  const double speed = start.velocity.norm();
  return speed > 0 ? end_velocity.norm() / speed * start.spin : start.spin;
}

/// The motion at the end of a flight, computed as the run does.
[[nodiscard]] inline Motion end_of_flight(const PathPiece& flight) {
  const double s = flight.duration;
  return {flight.path.at(s), flight.drag.velocity(flight.path, s), flight.spin,
          flight.start_time + flight.drag.time(s)};
}

}  // namespace talus
