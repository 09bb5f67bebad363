#pragma once
// Which rocks are in the tables of a run.

#include <algorithm>
#include <cstdint>
#include <optional>

#include "talus/archive/even_choice.hpp"

namespace talus {

/// The rocks of endpoints.csv are an even choice of all; those of paths.csv and of impacts.csv are even choices of
/// these, so that every path has its end point. A limit counts rocks of the whole campaign; without one all rocks are
/// in the table.
class TableRocks {
 public:
  using Limit = std::optional<std::uint64_t>;
  struct Limits {
    Limit endpoints{}, paths{}, impacts = 0;
  };

  explicit TableRocks(std::uint64_t rocks, const Limits& limits)
      : endpoints_(
            std::max({limits.endpoints.value_or(rocks), limits.paths.value_or(rocks), limits.impacts.value_or(rocks)}),
            rocks),
        paths_(limits.paths.value_or(rocks), endpoints_.count()),
        impacts_(limits.impacts.value_or(rocks), endpoints_.count()) {}

  [[nodiscard]] bool has_endpoint(std::uint64_t rock) const { return endpoints_.contains(rock); }
  [[nodiscard]] bool has_path(std::uint64_t rock) const {
    return endpoints_.contains(rock) && paths_.contains(endpoints_.count_before(rock));
  }
  [[nodiscard]] bool has_impacts(std::uint64_t rock) const {
    return endpoints_.contains(rock) && impacts_.contains(endpoints_.count_before(rock));
  }
  [[nodiscard]] std::uint64_t impacts() const { return impacts_.count(); }
  [[nodiscard]] std::uint64_t endpoints() const { return endpoints_.count(); }
  [[nodiscard]] std::uint64_t paths() const { return paths_.count(); }

  /// Counts of rocks with a lower number.
  [[nodiscard]] std::uint64_t endpoints_before(std::uint64_t rock) const { return endpoints_.count_before(rock); }
  [[nodiscard]] std::uint64_t paths_before(std::uint64_t rock) const {
    return paths_.count_before(endpoints_.count_before(rock));
  }
  [[nodiscard]] std::uint64_t impacts_before(std::uint64_t rock) const {
    return impacts_.count_before(endpoints_.count_before(rock));
  }

 private:
  EvenChoice endpoints_, paths_, impacts_;
};

}  // namespace talus
