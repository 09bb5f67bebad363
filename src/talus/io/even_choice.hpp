#pragma once
// So many of all rocks, evenly spread over their numbers: whether a rock is one of them depends on nothing else.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace talus::io {

class EvenChoice {
 public:
  /// `wanted` of `rocks`; all of them where more are wanted.
  EvenChoice(std::uint64_t wanted, std::uint64_t rocks) : wanted_(std::min(wanted, rocks)), rocks_(rocks) {}

  [[nodiscard]] bool contains(std::uint64_t rock) const {
    if (wanted_ == rocks_ || wanted_ == 0) return wanted_ != 0;
    return before(rock + 1) > before(rock);
  }
  /// How many rocks of a smaller number are chosen.
  [[nodiscard]] std::uint64_t count_before(std::uint64_t rock) const {
    return wanted_ == rocks_ ? rock : static_cast<std::uint64_t>(before(rock));
  }
  [[nodiscard]] std::uint64_t count() const { return wanted_; }

 private:
  // In doubles, which hold such products for any campaign that ends.
  [[nodiscard]] double before(std::uint64_t rock) const {
    const double share = static_cast<double>(wanted_) / static_cast<double>(rocks_);
    return std::floor(static_cast<double>(rock) * share + 1e-9);
  }

  std::uint64_t wanted_, rocks_;
};

}  // namespace talus::io
