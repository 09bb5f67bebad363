#pragma once
// Facts about a DXF that GDAL does not report, read from its text: pairs of lines, a code and a value (Autodesk, "DXF
// Reference"). Only for files that are built with GDAL.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace talus {

/// The unit of the coordinates, $INSUNITS in the header: 0 none, 2 feet, 4 millimetres, 6 metres ...; nullopt if the
/// header has none.
[[nodiscard]] std::optional<int> unit_of_dxf(const std::filesystem::path& file);
/// For example "feet".
[[nodiscard]] std::string name_of_dxf_unit(int unit);

/// Whether the file ends with its end marker, EOF.
[[nodiscard]] bool is_whole_dxf(const std::filesystem::path& file);

/// The last entity or section marker (group code 0) up to a line (from 1), for example "SPLINE"; empty if none.
[[nodiscard]] std::string last_entity_in_dxf(const std::filesystem::path& file, std::int64_t line);

}  // namespace talus
