#ifdef TALUS_HAS_GDAL

#include "talus/gdal/raster_crs.hpp"

#include <fmt/format.h>

#include <cpl_conv.h>
#include <cpl_error.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <optional>

#include "talus/gdal/zone_in_easting.hpp"

namespace talus {

namespace {

// With easting or longitude first, as in rasters, whatever the order of axes in the definition.
OGRSpatialReference in_map_order(OGRSpatialReference crs) {
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

/// From places in a projected system to longitude and latitude on its own datum. (Other datums are less than a
/// kilometre from it. To them PROJ has many ways, and finding the best one takes as long as reading the raster.)
class ToDegrees {
 public:
  explicit ToDegrees(const OGRSpatialReference& crs) {
    const std::unique_ptr<OGRSpatialReference> base(crs.CloneGeogCS());
    if (!base) return;
    const OGRSpatialReference from = in_map_order(crs), to = in_map_order(*base);
    per_unit_ = to.GetAngularUnits() * 180 / std::numbers::pi;
    prime_meridian_ = to.GetPrimeMeridian();
    transformation_.reset(OGRCreateCoordinateTransformation(&from, &to));
  }
  [[nodiscard]] bool is_known() const { return transformation_ != nullptr; }
  /// Longitude from Greenwich and latitude [degrees]; nullopt if the place has none.
  [[nodiscard]] std::optional<Vec2> operator()(const Vec2& place) const {
    double x = place.x(), y = place.y();
    if (!transformation_->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    return Vec2(x * per_unit_ + prime_meridian_, y * per_unit_);
  }

 private:
  std::unique_ptr<OGRCoordinateTransformation> transformation_;
  double per_unit_ = 1, prime_meridian_ = 0;  // [degrees]
};

/// The EPSG code of the UTM zone of a place; nullopt if it has no longitude and latitude, or is too near a pole.
std::optional<int> utm_epsg(const OGRSpatialReference& crs, const Vec2& centre) {
  const ToDegrees degrees(crs);
  const auto place = degrees.is_known() ? degrees(centre) : std::nullopt;
  if (!place || std::abs(place->y()) > 84 || std::abs(place->x()) > 360) return std::nullopt;
  const double longitude = std::remainder(place->x(), 360);
  const int zone = std::clamp(static_cast<int>(std::floor((longitude + 180) / 6)) + 1, 1, 60);
  return (place->y() >= 0 ? 32600 : 32700) + zone;
}

std::string command_to_utm(const OGRSpatialReference& crs, const std::optional<Vec2>& centre,
                           const CrsCommands& commands) {
  const auto epsg = centre ? utm_epsg(crs, *centre) : std::nullopt;
  return commands.project("EPSG:" + (epsg ? std::to_string(*epsg) : std::string("XXXX")));
}

/// The length on the ground of 1 m along x and along y [m].
std::optional<std::array<double, 2>> ground_lengths(const OGRSpatialReference& crs, const Vec2& centre) {
  constexpr double step = 100;  // m
  // The curvature of the ellipsoid of WGS 84: EPSG Guidance Note 7-2, section 1.2.
  constexpr double a = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f);
  const ToDegrees degrees(crs);
  if (!degrees.is_known()) return std::nullopt;
  std::array<double, 2> lengths{};
  for (int axis = 0; axis < 2; ++axis) {
    const Vec2 half = 0.5 * step * (axis == 0 ? Vec2(1, 0) : Vec2(0, 1));
    const auto from = degrees(centre - half), to = degrees(centre + half);
    if (!from || !to) return std::nullopt;
    const double latitude = 0.5 * (from->y() + to->y()) * std::numbers::pi / 180;
    const double w2 = 1 - e2 * std::sin(latitude) * std::sin(latitude);
    const double meridian = a * (1 - e2) / std::pow(w2, 1.5), parallel = a / std::sqrt(w2) * std::cos(latitude);
    const Vec2 turned = (*to - *from) * std::numbers::pi / 180;
    lengths[static_cast<std::size_t>(axis)] =
        std::hypot(std::remainder(turned.x(), 2 * std::numbers::pi) * parallel, turned.y() * meridian) / step;
  }
  return lengths;
}

/// How far a place is outside its coordinate system's area of use [degrees of longitude or latitude]; 0 inside, or if
/// that area is not known.
double degrees_outside(OGRSpatialReference crs, const Vec2& place) {
  if (crs.IsCompound()) crs.StripVertical();
  double west = 0, south = 0, east = 0, north = 0;
  if (!crs.GetAreaOfUse(&west, &south, &east, &north, nullptr) || west < -180 || south < -90) return 0;
  const double width = east >= west ? east - west : east - west + 360;  // the area may cross the 180th meridian
  const double eastwards = place.x() - west - 360 * std::floor((place.x() - west) / 360);
  const double east_or_west = eastwards <= width ? 0 : std::min(eastwards - width, 360 - eastwards);
  return std::max({east_or_west, south - place.y(), place.y() - north});
}

/// Compares lengths on plan with those on the ground; returns false if it added an error or a warning.
bool check_scale(const OGRSpatialReference& crs, const Vec2& centre, RasterProblems& problems,
                 const CrsCommands& commands) {
  const auto lengths = ground_lengths(crs, centre);
  if (!lengths) return true;
  const bool x_is_worse = std::abs((*lengths)[0] - 1) > std::abs((*lengths)[1] - 1);
  const double length = (*lengths)[x_is_worse ? 0 : 1];
  if (std::abs(length - 1) <= doubtful_scale) return true;
  std::string what = fmt::format("is in {}, whose metres are not metres on the ground", name_of(crs));
  std::string why = fmt::format("at its centre a metre along {} is {:.3f} m", x_is_worse ? "x" : "y", length);
  std::string hint = "Project it: " + command_to_utm(crs, centre, commands);
  if (std::abs(length - 1) > refused_scale) {
    problems.refuse(std::move(what), std::move(why), std::move(hint));
  } else {
    problems.warn(std::move(what), std::move(why), std::move(hint));
  }
  return false;
}

/// How eastings that begin with the number of a zone, as in Germany's and Russia's, can be used: where the place
/// without it lies within the area of the coordinate system. Empty if they do not.
std::string hint_for_zone(const OGRSpatialReference& crs, const Vec2& centre, const ToDegrees& degrees) {
  const auto zone = zone_in_easting(centre.x());
  const auto exchanged = degrees(Vec2(centre.y(), centre.x()));
  if (!zone || (exchanged && degrees_outside(crs, *exchanged) <= 3)) return "";
  const auto without = degrees(centre - Vec2(*zone * metres_per_zone, 0));
  if (!without || degrees_outside(crs, *without) > 3) return "";
  return fmt::format("Its eastings seem to begin with the number of a zone, {}: ", *zone) + way_out_of_zone(*zone);
}

/// Finds files with the wrong coordinate system, or with x and y exchanged, by their place on the earth.
void check_place_on_earth(const OGRSpatialReference& crs, const Vec2& centre, RasterProblems& problems,
                          const CrsCommands& commands) {
  constexpr double doubtful = 3, refused = 20;  // degrees; some use a neighbouring UTM zone (6 degrees), but no other
  const ToDegrees degrees(crs);
  if (!degrees.is_known()) return;
  const auto place = degrees(centre);
  const std::string at = fmt::format("({:.10g}, {:.10g})", centre.x(), centre.y());
  const std::string zone = hint_for_zone(crs, centre, degrees);
  const std::string hint =
      zone.empty() ? "Assign the right one, or put its coordinates in the order x, y: " + commands.name : zone;
  if (!place || std::abs(place->y()) > 90) {
    problems.refuse("is nowhere on the earth", fmt::format("its centre {} has no position in {}", at, name_of(crs)),
                    hint);
    return;
  }
  const double outside = degrees_outside(crs, *place);
  const std::string why =
      fmt::format("its centre {} is {:.0f} degrees outside the area of {}", at, outside, name_of(crs));
  if (outside > refused) {
    problems.refuse("is far outside the area of its coordinate system", why, hint);
  } else if (check_scale(crs, centre, problems, commands) && outside > doubtful) {
    problems.warn("is outside the area of its coordinate system", why, hint);
  }
}

/// Values of parameters in PROJ's strings that are names of files. An initialisation file of an authority is a code.
bool names_file(std::string_view key, std::string_view value) {
  static constexpr std::array<std::string_view, 9> keys{"nadgrids", "geoidgrids", "grids", "xy_grids", "z_grids",
                                                        "init",     "file",       "model", "catalog"};
  if (std::ranges::find(keys, key) == keys.end()) return false;
  if (key == "init") {
    std::string authority(value.substr(0, value.find(':')));
    std::ranges::transform(authority, authority.begin(), [](unsigned char c) { return std::tolower(c); });
    static constexpr std::array<std::string_view, 5> known{"epsg", "esri", "iau2000", "ignf", "ogc"};
    return std::ranges::find(known, authority) == known.end();
  }
  // Of a list, each may be marked as optional by @.
  return value.find_first_of("/\\") != std::string_view::npos || value.starts_with('~') || value.starts_with('.') ||
         value.find(",.") != std::string_view::npos || value.find(",~") != std::string_view::npos ||
         value.find("@.") != std::string_view::npos || value.find("@~") != std::string_view::npos;
}

}  // namespace

bool is_local(const OGRSpatialReference& crs) {
  if (!crs.IsCompound()) return crs.IsLocal() != 0;
  OGRSpatialReference plan = crs;
  plan.StripVertical();
  return plan.IsLocal() != 0;
}

std::optional<std::string> file_named_in(std::string_view words) {
  // key=value, where both end as words do in PROJ's strings and in WKT
  constexpr std::string_view ends = " \t\r\n\"'[](),+";
  for (std::size_t at = words.find('='); at != std::string_view::npos; at = words.find('=', at + 1)) {
    const std::size_t before = at == 0 ? std::string_view::npos : words.find_last_of(ends, at - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t first = std::min(words.find_first_not_of("\"'", at + 1), words.size());
    const std::size_t end = std::min(words.find_first_of(" \t\r\n\"'[]()", first), words.size());
    const std::string_view key = words.substr(begin, at - begin), value = words.substr(first, end - first);
    if (names_file(key, value)) return fmt::format("+{}={}", key, value);
  }
  // PARAMETERFILE["Latitude and longitude difference file","../grid.gsb"]
  constexpr std::string_view element = "PARAMETERFILE[";
  for (std::size_t at = words.find(element); at != std::string_view::npos; at = words.find(element, at + 1)) {
    const std::size_t name_end = words.find("\",", at), begin = words.find('"', name_end + 1);
    const std::size_t end = words.find('"', begin + 1);
    if (name_end == std::string_view::npos || begin == std::string_view::npos || end == std::string_view::npos) break;
    const std::string_view value = words.substr(begin + 1, end - begin - 1);
    if (names_file("grids", value)) return std::string(value);
  }
  return std::nullopt;
}

std::optional<std::string> file_named_in(const OGRSpatialReference& crs) {
  // Either form may lack what the other one has.
  for (const char* form : {"FORMAT=WKT2_2019", "FORMAT=WKT1_GDAL"}) {
    const char* const options[] = {form, nullptr};
    char* wkt = nullptr;
    CPLPushErrorHandler(CPLQuietErrorHandler);
    const bool is_written = crs.exportToWkt(&wkt, options) == OGRERR_NONE && wkt;
    CPLPopErrorHandler();
    auto found = is_written ? file_named_in(std::string_view(wkt)) : std::nullopt;
    CPLFree(wkt);
    if (found) return found;
  }
  return std::nullopt;
}

bool refuse_files_in_crs(const OGRSpatialReference& crs, RasterProblems& problems, const std::string& hint) {
  const auto file = file_named_in(crs);
  if (!file) return false;
  problems.refuse("has a coordinate system that names a file", *file + "; Talus reads no files that others name", hint);
  return true;
}

std::string option_to_keep_heights(const OGRSpatialReference& crs) {
  if (!crs.IsCompound()) return "";
  OGRSpatialReference plan = crs;
  plan.StripVertical();
  const char *authority = plan.GetAuthorityName(nullptr), *code = plan.GetAuthorityCode(nullptr);
  return authority && code ? fmt::format(" -s_srs {}:{}", authority, code) : " -s_srs EPSG:XXXX";
}

std::optional<Problem> fault_of_proj(GdalMessages& messages) {
  messages.clear();
  OGRSpatialReference any;
  if (any.importFromEPSG(4326) == OGRERR_NONE) return std::nullopt;
  std::string hint = "Install PROJ's data files; on Debian they are in the package proj-data";
  for (const char* variable : {"PROJ_DATA", "PROJ_LIB"}) {
    const char* const folder = std::getenv(variable);
    if (folder == nullptr) continue;
    hint = fmt::format("{} is {}: unset it, or set it to the folder of proj.db", variable, folder);
    break;
  }
  return Problem{.what = "coordinate systems cannot be looked up", .why = messages.failure(), .hint = std::move(hint)};
}

std::string wkt_of(const OGRSpatialReference& crs) {
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  char* wkt = nullptr;
  const bool written = crs.exportToWkt(&wkt, options) == OGRERR_NONE && wkt;
  std::string out = written ? wkt : "";
  CPLFree(wkt);
  return out;
}

std::optional<OGRSpatialReference> crs_for_file(const std::string& wkt) {
  OGRSpatialReference crs;
  if (wkt.empty() || crs.importFromWkt(wkt.c_str()) != OGRERR_NONE) return std::nullopt;
  crs = in_map_order(std::move(crs));
  const char *authority = crs.GetAuthorityName(nullptr), *code = crs.GetAuthorityCode(nullptr);
  if (authority == nullptr || code == nullptr || std::string_view(authority) != "EPSG") return crs;
  OGRSpatialReference numbered;
  if (numbered.importFromEPSG(std::atoi(code)) != OGRERR_NONE) return crs;
  numbered = in_map_order(std::move(numbered));
  return numbered.IsSame(&crs) != 0 ? numbered : crs;
}

std::string name_of(const OGRSpatialReference& crs) {
  const char *authority = crs.GetAuthorityName(nullptr), *code = crs.GetAuthorityCode(nullptr);
  if (authority && code) return fmt::format("{}:{}", authority, code);
  const char* name = crs.GetName();
  return name && *name ? name : "an unnamed coordinate system";
}

std::string command_to_metres_of_height(double metres_per_unit, const OGRSpatialReference* crs,
                                        const RasterProblems& problems) {
  std::string plan;
  if (crs && crs->IsCompound()) {
    OGRSpatialReference horizontal = *crs;
    horizontal.StripVertical();
    const char *authority = horizontal.GetAuthorityName(nullptr), *code = horizontal.GetAuthorityCode(nullptr);
    plan = authority && code ? fmt::format(" -a_srs {}:{}", authority, code) : " -a_srs EPSG:XXXX";
  }
  return problems.command(fmt::format("gdal_translate -ot Float32 -scale 0 1 0 {:.15g}{}", metres_per_unit, plan),
                          "_metres_high.tif");
}

std::optional<LengthUnit> unit_of_height(const OGRSpatialReference& crs) {
  if (!crs.IsVertical()) return std::nullopt;
  const char* unit = nullptr;
  const double metres = crs.GetTargetLinearUnits("VERT_CS", &unit);
  return LengthUnit{unit && *unit ? unit : "an unnamed unit", metres};
}

bool has_depths(const OGRSpatialReference& crs) {
  if (!crs.IsVertical()) return false;
  OGRAxisOrientation orientation = OAO_Other;
  return crs.GetAxis(nullptr, crs.IsCompound() ? 2 : 0, &orientation) && orientation == OAO_Down;
}

std::optional<HeightFault> fault_of_heights(const OGRSpatialReference& crs) {
  if (has_depths(crs)) return HeightFault{"has depths", name_of(crs) + " measures them downwards; Talus needs heights"};
  if (const auto height = unit_of_height(crs)) {
    if (std::abs(height->metres - 1) <= 1e-9) return std::nullopt;
    return HeightFault{
        "has heights in " + height->name,
        fmt::format("that is the unit of {}, {:.10g} m; Talus needs metres", name_of(crs), height->metres)};
  }
  const char* unit = nullptr;
  if (!crs.IsProjected() || std::abs(crs.GetLinearUnits(&unit) - 1) <= 1e-9) return std::nullopt;
  return HeightFault{"has heights without a unit",
                     fmt::format("the unit of {} is {} on plan, and it has none for heights", name_of(crs),
                                 unit && *unit ? unit : "an unnamed unit")};
}

void check_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems) {
  check_terrain_crs(crs, centre, problems,
                    {[&](const std::string& target) {
                       return problems.command(
                           fmt::format("gdalwarp{} -t_srs {} -r bilinear", option_to_keep_heights(crs), target),
                           "_metres.tif");
                     },
                     problems.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif")});
}

void check_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems,
                       const CrsCommands& commands) {
  if (refuse_files_in_crs(crs, problems, "Assign one without it: " + commands.name)) return;
  if (crs.IsGeographic()) {
    problems.refuse("is in degrees",
                    fmt::format("{} is a geographic coordinate system; Talus needs metres on plan", name_of(crs)),
                    "Project it: " + command_to_utm(crs, centre, commands));
  } else if (is_local(crs)) {
    const char* unit = nullptr;
    const double metres = crs.GetLinearUnits(&unit);
    if (std::abs(metres - 1) > 1e-9) {
      problems.refuse(
          "is not in metres on plan",
          fmt::format("the unit of {} is {}, {:.10g} m", name_of(crs), unit && *unit ? unit : "unnamed", metres),
          "Multiply its coordinates by that number, and assign the result no coordinate system");
    }
  } else if (!crs.IsProjected()) {
    const char* kind = crs.IsGeocentric() ? "geocentric" : "neither projected nor geographic";
    problems.refuse("has no projected coordinate system",
                    fmt::format("{} is {}; Talus needs a projected one in metres", name_of(crs), kind),
                    "Assign the right one: " + commands.name);
  } else {
    const char* unit = nullptr;
    const double metres = crs.GetLinearUnits(&unit);
    if (std::abs(metres - 1) > 1e-9) {
      problems.refuse("is not in metres on plan",
                      fmt::format("the unit of {} is {}, {:.10g} m", name_of(crs),
                                  unit && *unit ? unit : "an unnamed unit", metres),
                      "Project it: " + command_to_utm(crs, centre, commands));
    } else if (centre) {
      check_place_on_earth(crs, *centre, problems, commands);
    }
  }
}

}  // namespace talus

#endif
