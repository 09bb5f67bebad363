#pragma once
// The columns of the tables of a run without blocks.

#include <algorithm>
#include <array>
#include <string_view>

#include "talus/archive/table_columns.hpp"

namespace talus {

template <class Row>
inline constexpr auto columns_without_blocks = [] {
  std::array<std::string_view, columns_in_run<Row>(false)> names;
  std::copy_n(column_names<Row>.begin(), names.size(), names.begin());
  return names;
}();
inline constexpr const auto& endpoint_columns = columns_without_blocks<EndpointRow>;
inline constexpr const auto& path_columns = columns_without_blocks<PathEventRow>;
inline constexpr const auto& barrier_columns = columns_without_blocks<HitRow>;

}  // namespace talus
