#pragma once
// Random numbers of a sensitivity analysis, each a pure function of (seed, purpose, row, column).

#include <cstddef>
#include <cstdint>

namespace talus {

class CountedDraws {
 public:
  /// The purposes; they share no number with each other or with a rock's draws (core/random.hpp).
  enum class Purpose : std::uint32_t { trajectories = 0x53000001, shift, bootstrap };

  CountedDraws(std::uint64_t seed, Purpose purpose) : seed_(seed), purpose_(purpose) {}

  [[nodiscard]] std::uint64_t bits(std::uint64_t row, std::uint32_t column) const;
  /// A whole number from 0 to count - 1. Expects a count from 1 to 2^32; biased by less than count / 2^64.
  [[nodiscard]] std::size_t below(std::size_t count, std::uint64_t row, std::uint32_t column) const;

 private:
  std::uint64_t seed_;
  Purpose purpose_;
};

}  // namespace talus
