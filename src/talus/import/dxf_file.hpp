#pragma once
// What GDAL does not tell of a DXF, read from its text: pairs of lines, a code and a value (Autodesk, "DXF Reference").
// For files that are built with GDAL only.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace talus {

/// The number of the unit of its coordinates in its header, $INSUNITS: 0 none, 2 feet, 4 millimetres, 6 metres ...;
/// nothing where it does not say.
[[nodiscard]] std::optional<int> unit_of_dxf(const std::filesystem::path& file);
/// For example "feet".
[[nodiscard]] std::string name_of_dxf_unit(int unit);

/// Whether its last word is that it ends.
[[nodiscard]] bool is_whole_dxf(const std::filesystem::path& file);

/// The last thing that begins before a line, counted from 1, for example "SPLINE"; empty where there is none.
[[nodiscard]] std::string thing_in_dxf(const std::filesystem::path& file, std::int64_t line);

}  // namespace talus
