#pragma once
// What a change does to figures of a sample, when the same members are seen without and with it.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/statistics/bootstrap.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus {

/// The change of a share: of `members`, at least one, `gained` have the property only with the change, `lost` only
/// without it; the others tell nothing (McNemar). The interval adds one to either count: D. G. Bonett and R. M. Price,
/// "Adjusted Wald confidence intervals for a difference of binomial proportions based on paired data", Journal of
/// Educational and Behavioral Statistics 37 (2012) 479-488.
[[nodiscard]] Estimate paired_share_difference(std::uint64_t gained, std::uint64_t lost, std::uint64_t members,
                                               double confidence);

/// Quantities of one member.
struct MemberValues {
  static constexpr std::size_t quantities = 4;
  std::uint64_t member = 0;
  std::array<double, quantities> values{};
};

/// The change of the quantile p of each quantity, over the members that have values; `without` and `with`: those that
/// have them, in ascending order of the members. The interval is that of bootstrap.hpp, drawn from the members that
/// have values in either, each with both of its values. Nullopt if nobody has values in one of them. An interval is
/// empty if one of the two quantiles has no interval on its own (order_statistics.hpp): a bootstrap of so few values
/// would be too narrow.
[[nodiscard]] std::optional<std::array<Estimate, MemberValues::quantities>> paired_quantile_differences(
    std::span<const MemberValues> without, std::span<const MemberValues> with, double p, const Bootstrap& bootstrap);

}  // namespace talus
