#pragma once
// envelopes.csv as the report draws it: a few of its columns, of no more cells than a page can show.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus {

struct ReportEnvelopes {
  struct Cell {
    double from_x_m = 0, to_x_m = 0;              // the middles of its first and last cell of the file
    std::vector<std::optional<double>> values{};  // one a column: the greatest of its cells; none where no rock was
  };
  std::vector<std::string> columns{};  // as the file has them, without x_m
  std::vector<Cell> cells{};
  std::uint64_t cells_each = 1;  // of the file, in each of these but the last, which may have fewer
};

/// More could not be told apart on a page.
inline constexpr std::size_t most_report_envelope_cells = 1000;

/// Reach, energy, velocity and height. Throws BadInput on a file that is not what it should be.
[[nodiscard]] ReportEnvelopes read_report_envelopes(const std::filesystem::path& file);

}  // namespace talus
