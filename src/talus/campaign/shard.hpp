#pragma once
// A campaign in independent pieces: which rocks belong to which.

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

/// One of `of` pieces, `number` from 1.
struct Shard {
  std::uint64_t number = 1, of = 1;
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// "2/7"; nothing where the text is not a shard.
[[nodiscard]] std::optional<Shard> shard_from(std::string_view text);

/// The rocks of a shard: total (i - 1) / n up to, but without, total i / n, rounded down. Together the shards have
/// every rock once; their sizes differ by one at most.
[[nodiscard]] RockRange rocks_of(const Shard& shard, std::uint64_t total);

}  // namespace talus
