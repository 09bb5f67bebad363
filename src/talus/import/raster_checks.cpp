#ifdef TALUS_HAS_GDAL

#include "talus/import/raster_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include "talus/core/memory.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/raster_file.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus {

namespace {

/// Whether the coordinates of a file without a coordinate system are more likely degrees than metres.
bool seems_to_be_in_degrees(GDALDataset& dataset, const RasterPlacing& at) {
  constexpr double widest = 10;          // degrees: larger than any terrain
  constexpr double largest_cell = 0.01;  // degrees, about a kilometre; as metres, a centimetre would be too small
  const double east = at.west + at.dx * dataset.GetRasterXSize(), north = at.south + at.dy * dataset.GetRasterYSize();
  return at.west >= -180 && east <= 360 && at.south >= -90 && north <= 90 && east - at.west < widest &&
         north - at.south < widest && std::max(at.dx, at.dy) < largest_cell;
}

// Shares of the available memory: a terrain may take half, since maps need memory, too; from a tenth there is a
// warning.
constexpr double share_of_memory = 0.5, much_memory = 0.1;

/// Memory is allocated for all declared cells before the first is read, however short the file is.
void check_memory(GDALDataset& dataset, RasterProblems& problems) {
  const double nodes = static_cast<double>(dataset.GetRasterXSize()) * dataset.GetRasterYSize();
  // The elevations, and two rows in 64 bits.
  const double needed = nodes * sizeof(float) + 2.0 * sizeof(double) * dataset.GetRasterXSize();
  const auto available = static_cast<double>(usable_memory());
  const std::string cells = fmt::format("has {} x {} cells", dataset.GetRasterXSize(), dataset.GetRasterYSize());
  const std::string cut =
      "Cut it to the slope: " + problems.command("gdal_translate -projwin WEST NORTH EAST SOUTH", "_slope.tif");
  if (needed > share_of_memory * available) {
    problems.refuse(cells,
                    fmt::format("they need {:.1f} GB of memory; a terrain may take half of the {:.1f} GB available",
                                needed / 1e9, available / 1e9),
                    cut);
  } else if (needed > much_memory * available) {
    problems.warn(cells, fmt::format("they take {:.1f} GB of memory", needed / 1e9), cut);
  }
}

/// The length in metres of a unit of height by its name; nullopt for an unknown name.
std::optional<double> metres_of_unit(std::string name) {
  for (char& c : name) c = c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  struct Known {
    double metres = 1;  // in one unit
    std::array<std::string_view, 6> names;
  };
  // The international foot and the US survey foot: NIST Special Publication 811, appendix B.
  static constexpr std::array<Known, 6> known{
      {{1, {"m", "metre", "metres", "meter", "meters", "mtr"}},
       {0.3048, {"ft", "foot", "feet", "international foot", "ft (intl)"}},
       {1200.0 / 3937, {"us survey foot", "us ft", "ftus", "foot us", "us foot"}},
       {0.1, {"dm", "decimetre", "decimeter", "decimetres", "decimeters"}},
       {0.01, {"cm", "centimetre", "centimeter", "centimetres", "centimeters"}},
       {0.001, {"mm", "millimetre", "millimeter", "millimetres", "millimeters"}}}};
  for (const Known& unit : known) {
    if (std::find(unit.names.begin(), unit.names.end(), name) != unit.names.end()) return unit.metres;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RasterPlacing> placing_of(GDALDataset& dataset, RasterProblems& problems) {
  double t[6];
  if (!read_geotransform(dataset, t, problems)) return std::nullopt;
  const double columns = dataset.GetRasterXSize(), rows = dataset.GetRasterYSize();
  // A deviation of a thousandth of a cell over the whole raster is rounding.
  if (std::abs(t[2]) * rows > 1e-3 * std::abs(t[1]) || std::abs(t[4]) * columns > 1e-3 * std::abs(t[5])) {
    problems.refuse(
        "is rotated or sheared",
        fmt::format(
            "its geotransform is {:g}, {:g}, {:g}, {:g}, {:g}, {:g}; Talus needs rows that run from west to east", t[0],
            t[1], t[2], t[3], t[4], t[5]),
        "Make it north-up: " + problems.command("gdalwarp -r bilinear", "_north_up.tif"));
    return std::nullopt;
  }
  RasterPlacing out{};
  out.dx = std::abs(t[1]);
  out.dy = std::abs(t[5]);
  out.from_east = t[1] < 0;
  out.from_south = t[5] > 0;
  out.west = out.from_east ? t[0] - columns * out.dx : t[0];
  out.south = out.from_south ? t[3] : t[3] - rows * out.dy;
  return out;
}

void check_place(GDALDataset& dataset, const RasterPlacing& at, const OGRSpatialReference* crs, bool is_local,
                 RasterProblems& problems) {
  constexpr double smallest_cell = 1e-3;  // m
  const double east = at.west + at.dx * dataset.GetRasterXSize(), north = at.south + at.dy * dataset.GetRasterYSize();
  if (std::max({std::abs(at.west), std::abs(east), std::abs(at.south), std::abs(north)}) > largest_coordinate_m) {
    problems.refuse(
        "is too far from the origin",
        fmt::format("x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}; coordinates must be smaller than {:g} m", at.west,
                    east, at.south, north, largest_coordinate_m),
        "Assign its extent: " + problems.command("gdal_translate -a_ullr WEST NORTH EAST SOUTH", "_placed.tif"));
  } else if (crs ? !crs->IsGeographic() && std::min(at.dx, at.dy) < smallest_cell
                 : !is_local && seems_to_be_in_degrees(dataset, at)) {
    problems.refuse("seems to be in degrees",
                    fmt::format("its cells are {:.6g} x {:.6g}, and it {}", at.dx, at.dy,
                                crs ? "has the coordinate system " + name_of(*crs) : "has no coordinate system"),
                    "Assign the right one: " + problems.command("gdal_translate -a_srs EPSG:4326", "_placed.tif") +
                        ", and project the result");
  }
}

void check_size(GDALDataset& dataset, RasterProblems& problems) {
  const std::int64_t columns = dataset.GetRasterXSize(), rows = dataset.GetRasterYSize();
  if (columns < 2 || rows < 2) {
    problems.refuse(fmt::format("has {} x {} cells", columns, rows), "a surface needs 2 x 2 or more");
  }
  if (static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows) >= most_raster_nodes) {
    problems.refuse(
        fmt::format("has {} x {} cells", columns, rows), fmt::format("Talus reads fewer than {}", most_raster_nodes),
        "Cut it to the slope: " + problems.command("gdal_translate -projwin WEST NORTH EAST SOUTH", "_slope.tif"));
  } else {
    check_memory(dataset, problems);
  }
}

void check_band(GDALRasterBand& band, RasterProblems& problems) {
  if (GDALDataTypeIsComplex(band.GetRasterDataType())) {
    problems.refuse("has complex numbers in band 1", "an elevation is a real number",
                    "Keep the real part: " + problems.command("gdal_translate -ot Float32", "_real.tif"));
  }
  int has_scale = 0, has_offset = 0;
  const double scale = band.GetScale(&has_scale), offset = band.GetOffset(&has_offset);
  if ((has_scale && (!std::isfinite(scale) || scale == 0)) || (has_offset && !std::isfinite(offset))) {
    problems.refuse(fmt::format("has the scale {:g} and the offset {:g} for its heights", scale, offset),
                    "all cells would have the same height, or none",
                    "Remove them: " + problems.command("gdal_translate -a_scale 1 -a_offset 0", "_heights.tif"));
  }
  const GDALColorInterp colour = band.GetColorInterpretation();
  if (colour != GCI_Undefined && colour != GCI_GrayIndex) {
    const std::string word = GDALGetColorInterpretationName(colour);
    problems.refuse("is a picture",
                    fmt::format("band 1 is the colour component \"{}\"; Talus needs elevations there", word),
                    "If it does contain them: " +
                        problems.command("gdal_translate -b 1 -ot Float32 -colorinterp_1 gray", "_heights.tif"));
  }
}

void check_unit(GDALRasterBand& band, const OGRSpatialReference* crs, RasterProblems& problems) {
  const std::string unit = band.GetUnitType() ? band.GetUnitType() : "";
  if (crs && has_depths(*crs)) {
    problems.refuse("has depths", name_of(*crs) + " measures them downwards; Talus needs heights",
                    "Negate them: " + problems.command("gdal_translate -ot Float32 -scale 0 1 0 -1 -a_srs EPSG:XXXX",
                                                       "_heights.tif"));
  }
  const auto refuse = [&](const std::string& name, std::optional<double> metres) {
    if (metres) {
      problems.refuse(fmt::format("has heights in {}", name),
                      fmt::format("Talus needs metres; the unit is {:.10g} m", *metres),
                      "Convert them: " + command_to_metres_of_height(*metres, crs, problems));
    } else {
      problems.refuse(fmt::format("has heights in \"{}\"", name), "Talus needs metres",
                      "If they are metres, remove the unit: " + command_to_metres_of_height(1, crs, problems));
    }
  };
  const auto of_crs = crs ? unit_of_height(*crs) : std::nullopt;
  if (!unit.empty()) {
    const auto metres = metres_of_unit(unit);
    if (metres && of_crs && std::abs(*metres - of_crs->metres) > 1e-9) {
      problems.refuse(fmt::format("has heights in {} and in {}", unit, of_crs->name),
                      fmt::format("the first is the unit of its band, the second that of {}", name_of(*crs)),
                      "Correct the wrong one: " + problems.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif") +
                          ", or gdal_edit.py -units");
      return;
    }
    if (!metres || *metres != 1) refuse(unit, metres);
  } else if (of_crs && std::abs(of_crs->metres - 1) > 1e-9) {
    refuse(of_crs->name, of_crs->metres);
  }
}

}  // namespace talus

#endif
