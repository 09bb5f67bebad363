#include "talus/seeding/release_order.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace talus {

namespace {

__extension__ using Wide = unsigned __int128;  // products of two counts

/// The sum of floor((a i + b) / m) for i below n: the points of a grid below a line, by Euclid's algorithm.
Wide floor_sum(Wide n, Wide m, Wide a, Wide b) {
  Wide sum = 0;
  while (n > 0) {
    sum += n * (n - 1) / 2 * (a / m) + n * (b / m);
    a %= m;
    b %= m;
    const Wide top = a * n + b;
    n = top / m;
    b = top % m;
    std::swap(m, a);
  }
  return sum;
}

/// How many of the first turns, no more than there are places, have a place below `end`.
std::uint64_t turns_below(const ReleaseOrder& order, std::uint64_t end, std::uint64_t turns) {
  const Wide places = order.places, from = Wide{order.start} + places;
  return static_cast<std::uint64_t>(floor_sum(turns, places, order.step, from) -
                                    floor_sum(turns, places, order.step, from - end));
}

/// The largest partial quotient of places / step; 0 if they have a common divisor.
std::uint64_t largest_quotient(std::uint64_t places, std::uint64_t step) {
  std::uint64_t largest = 0;
  while (step > 0) {
    largest = std::max(largest, places / step);
    places = std::exchange(step, places % step);
  }
  return places == 1 ? largest : 0;
}

}  // namespace

std::uint64_t ReleaseOrder::place_of_turn(std::uint64_t turn) const {
  const std::uint64_t again = turn % places;
  if (places <= std::uint64_t{1} << 32U) return (start + again * step % places) % places;
  return static_cast<std::uint64_t>((start + Wide{again} * step) % places);
}

std::uint64_t ReleaseOrder::rocks_from(std::uint64_t begin, std::uint64_t end, std::uint64_t released) const {
  const std::uint64_t turns = released / rocks_at_once, last = released % rocks_at_once, rest = turns % places;
  std::uint64_t count =
      turns / places * (end - begin) + turns_below(*this, end, rest) - turns_below(*this, begin, rest);
  count *= rocks_at_once;
  if (last > 0) {
    const std::uint64_t place = place_of_turn(turns);
    if (place >= begin && place < end) count += last;
  }
  return count;
}

std::uint64_t even_step(std::uint64_t places) {
  constexpr std::uint64_t tries = 64;  // of neighbours on either side; the best has quotients of about 3
  const auto near = static_cast<std::uint64_t>(static_cast<double>(places) / std::numbers::phi);
  std::uint64_t best = 1, least = places;
  for (std::uint64_t k = 0; k < 2 * tries; ++k) {
    const std::uint64_t away = (k + 1) / 2;
    if (k % 2 == 0 ? near + away >= places : away >= near) continue;
    const std::uint64_t step = k % 2 == 0 ? near + away : near - away;
    const std::uint64_t largest = step > 0 ? largest_quotient(places, step) : 0;
    if (largest == 0 || largest >= least) continue;
    least = largest;
    best = step;
  }
  return best;
}

}  // namespace talus
