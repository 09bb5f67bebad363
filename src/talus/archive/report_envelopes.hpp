#pragma once
// envelopes.csv for the report: some of its columns, with no more cells than a page can show.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus {

struct ReportEnvelopes {
  struct Cell {
    double from_x_m = 0, to_x_m = 0;  // the middles of its first and last cell of the file
    std::vector<std::optional<double>>
        values{};  // one for each column: the maximum of its cells; nullopt without a rock
  };
  std::vector<std::string> columns{};  // as in the file, without x_m
  std::vector<Cell> cells{};
  std::uint64_t cells_each = 1;  // cells of the file in each of these; the last may have fewer
};

/// More could not be distinguished on a page.
inline constexpr std::size_t most_report_envelope_cells = 1000;

/// Reads reach, energy, velocity and height. Throws BadInput on a damaged file.
[[nodiscard]] ReportEnvelopes read_report_envelopes(const std::filesystem::path& file);

}  // namespace talus
