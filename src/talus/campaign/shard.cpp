#include "talus/campaign/shard.hpp"

#include <charconv>

namespace talus {

namespace {

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return value;
}

/// total k / n, rounded down, for k <= n. Quotient and remainder are multiplied separately, so that no product exceeds
/// n^2 or the total.
std::uint64_t share(std::uint64_t total, std::uint64_t k, std::uint64_t n) { return total / n * k + total % n * k / n; }

}  // namespace

std::optional<Shard> shard_from(std::string_view text) {
  constexpr std::uint64_t most = 1'000'000'000;  // more than any cluster needs; its square fits in 64 bits
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto number = whole_number(text.substr(0, slash)), of = whole_number(text.substr(slash + 1));
  if (!number || !of || *number < 1 || *number > *of || *of > most) return std::nullopt;
  return Shard{*number, *of};
}

RockRange rocks_of(const Shard& shard, std::uint64_t total) {
  return {share(total, shard.number - 1, shard.of), share(total, shard.number, shard.of)};
}

}  // namespace talus
