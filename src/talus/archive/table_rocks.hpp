#pragma once
// Which rocks the tables of a run hold one by one.

#include <algorithm>
#include <cstdint>
#include <optional>

#include "talus/archive/even_choice.hpp"

namespace talus {

/// The rocks of endpoints.csv are an even choice of all; those of paths.csv one of these: where a path is, the end of
/// it is, too. A limit counts rocks of the whole campaign; without one all rocks are there.
class TableRocks {
 public:
  using Limit = std::optional<std::uint64_t>;

  explicit TableRocks(std::uint64_t rocks, Limit endpoints = {}, Limit paths = {})
      : endpoints_(std::max(endpoints.value_or(rocks), paths.value_or(rocks)), rocks),
        paths_(paths.value_or(rocks), endpoints_.count()) {}

  [[nodiscard]] bool has_endpoint(std::uint64_t rock) const { return endpoints_.contains(rock); }
  [[nodiscard]] bool has_path(std::uint64_t rock) const {
    return endpoints_.contains(rock) && paths_.contains(endpoints_.count_before(rock));
  }
  [[nodiscard]] std::uint64_t endpoints() const { return endpoints_.count(); }
  [[nodiscard]] std::uint64_t paths() const { return paths_.count(); }

  /// Of rocks with a smaller number.
  [[nodiscard]] std::uint64_t endpoints_before(std::uint64_t rock) const { return endpoints_.count_before(rock); }
  [[nodiscard]] std::uint64_t paths_before(std::uint64_t rock) const {
    return paths_.count_before(endpoints_.count_before(rock));
  }

 private:
  EvenChoice endpoints_, paths_;
};

}  // namespace talus
