#pragma once
// A campaign divided into independent pieces.

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// Rocks `first` to `last` - 1.
struct RockRange {
  std::uint64_t first = 0, last = 0;
  [[nodiscard]] std::uint64_t count() const { return last - first; }
  friend auto operator<=>(const RockRange&, const RockRange&) = default;
};

/// Piece `number`, from 1, of `of` pieces.
struct Shard {
  std::uint64_t number = 1, of = 1;
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// From text such as "2/7"; nullopt if it is not a shard.
[[nodiscard]] std::optional<Shard> shard_from(std::string_view text);

/// The rocks of shard i of n: from total (i - 1) / n up to, but not including, total i / n, rounded down. Each rock is
/// in exactly one shard; the sizes of shards differ by at most one.
[[nodiscard]] RockRange rocks_of(const Shard& shard, std::uint64_t total);

}  // namespace talus
