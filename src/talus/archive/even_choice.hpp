#pragma once
// A selection of rocks that is evenly spread over their numbers and depends on nothing else.

#include <algorithm>
#include <cstdint>

namespace talus {

/// The rocks are divided into as many intervals of equal length as rocks are wanted. One rock is taken from each, at a
/// pseudorandom place that depends only on the number of the interval. So every range of rocks, and with it every
/// seeder, line and source, has its share to within one rock (stratified sampling: Cochran, Sampling Techniques,
/// chapter 5). Periodic releases, such as cells row by row, do not interfere with the selection.
class EvenChoice {
 public:
  /// `wanted` of `rocks`, or all if more are wanted. Expects up to 1e12 rocks.
  EvenChoice(std::uint64_t wanted, std::uint64_t rocks) : wanted_(std::min(wanted, rocks)), rocks_(rocks) {}

  [[nodiscard]] bool contains(std::uint64_t rock) const {
    if (wanted_ == rocks_ || wanted_ == 0) return wanted_ != 0;
    return chosen_in(stretch_of(rock)) == rock;
  }
  /// The number of chosen rocks with a lower number.
  [[nodiscard]] std::uint64_t count_before(std::uint64_t rock) const {
    if (wanted_ == rocks_ || wanted_ == 0) return wanted_ == 0 ? 0 : rock;
    if (rock >= rocks_) return wanted_;
    const std::uint64_t stretch = stretch_of(rock);
    return stretch + (chosen_in(stretch) < rock ? 1 : 0);
  }
  [[nodiscard]] std::uint64_t count() const { return wanted_; }

 private:
  __extension__ using Wide = unsigned __int128;  // for products of two rock counts

  [[nodiscard]] std::uint64_t stretch_of(std::uint64_t rock) const {
    return static_cast<std::uint64_t>(Wide{rock} * wanted_ / rocks_);
  }
  [[nodiscard]] std::uint64_t first_of(std::uint64_t stretch) const {
    return static_cast<std::uint64_t>((Wide{stretch} * rocks_ + wanted_ - 1) / wanted_);
  }
  [[nodiscard]] std::uint64_t chosen_in(std::uint64_t stretch) const {
    const std::uint64_t first = first_of(stretch), length = first_of(stretch + 1) - first;
    return first + static_cast<std::uint64_t>(Wide{mixed(stretch)} * length >> 64U);
  }
  /// SplitMix64: Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
  [[nodiscard]] static std::uint64_t mixed(std::uint64_t x) {
    x = (x + 1) * 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
  }

  std::uint64_t wanted_, rocks_;
};

}  // namespace talus
