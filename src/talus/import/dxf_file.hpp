#pragma once
// Facts about a DXF that GDAL does not report, read from its text: pairs of lines, a code and a value (Autodesk, "DXF
// Reference"). Only for files that are built with GDAL.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

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

/// Entities of one kind on one layer.
struct DxfKind {
  std::uint64_t count = 0;
  std::int64_t line = 0;     // where the first begins
  bool has_heights = false;  // whether any of them has a height other than 0
  bool is_uneven = false;    // whether the points of any of them have different heights
  void add(const DxfKind& more);
};

/// What GDAL drops without a message: whole entities, and the heights of curves. Entities in layouts do not count;
/// those of a block count once for each layer on which it is inserted. The keys are the layer and the kind.
struct DxfContents {
  std::map<std::pair<std::string, std::string>, DxfKind> unread;  // surfaces, solids, proxies ...
  std::map<std::pair<std::string, std::string>, DxfKind> curves;  // SPLINE and HELIX
  std::set<std::string> hidden_layers;                            // switched off or frozen
};
[[nodiscard]] DxfContents contents_of_dxf(const std::filesystem::path& file);

}  // namespace talus
