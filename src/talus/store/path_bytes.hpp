#pragma once
// What writer and reader of a path's bytes share: the tags and flags, and vectors as numbers. Private to store/.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "talus/core/bytes.hpp"
#include "talus/rocks/motion.hpp"
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

template <class Number>
[[nodiscard]] double get_number(ByteReader& in) {
  const auto x = static_cast<double>(in.get<Number>());
  expect_bytes(std::isfinite(x), "a number is not finite");
  return x;
}
template <class Number>
[[nodiscard]] Vec3 get_vector(ByteReader& in, bool is_planar) {
  Vec3 v = Vec3::Zero();
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

/// A vector as a reader has it after it was written as floats.
[[nodiscard]] inline Vec3 as_floats(const Vec3& v) { return v.cast<float>().cast<double>(); }

/// The motion at the end of a flight, computed as the run does.
[[nodiscard]] inline Motion end_of_flight(const PathPiece& flight) {
  const double s = flight.duration;
  return {flight.path.at(s), flight.drag.velocity(flight.path, s), flight.spin,
          flight.start_time + flight.drag.time(s)};
}

}  // namespace talus
