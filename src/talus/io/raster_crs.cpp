#ifdef TALUS_HAS_GDAL

#include "talus/io/raster_crs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

namespace talus {

namespace {

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

// Coordinates as rasters have them, whatever the order of axes in the definition: easting or longitude first.
OGRSpatialReference in_map_order(OGRSpatialReference crs) {
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

OGRSpatialReference wgs84() {
  OGRSpatialReference crs;
  crs.importFromEPSG(4326);
  return in_map_order(std::move(crs));
}

Transformation to_degrees(const OGRSpatialReference& crs) {
  const OGRSpatialReference from = in_map_order(crs), to = wgs84();
  return Transformation(OGRCreateCoordinateTransformation(&from, &to));
}

/// Longitude and latitude [degrees].
std::optional<Vec2> degrees(OGRCoordinateTransformation& transformation, const Vec2& place) {
  double x = place.x(), y = place.y();
  if (!transformation.Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  return Vec2(x, y);
}

/// The UTM zone of a place; nothing where it is no place of the earth.
std::optional<int> utm_epsg(const OGRSpatialReference& crs, const Vec2& centre) {
  const Transformation transformation = to_degrees(crs);
  const auto place = transformation ? degrees(*transformation, centre) : std::nullopt;
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

/// How long a step of 1 m along x and along y is on the ground [m].
std::optional<std::array<double, 2>> ground_lengths(const OGRSpatialReference& crs, const Vec2& centre) {
  constexpr double step = 100;  // m
  // The curvature of the ellipsoid of WGS 84: EPSG Guidance Note 7-2, section 1.2.
  constexpr double a = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f);
  const Transformation transformation = to_degrees(crs);
  if (!transformation) return std::nullopt;
  std::array<double, 2> lengths{};
  for (int axis = 0; axis < 2; ++axis) {
    const Vec2 half = 0.5 * step * (axis == 0 ? Vec2(1, 0) : Vec2(0, 1));
    const auto from = degrees(*transformation, centre - half), to = degrees(*transformation, centre + half);
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

void judge_scale(const OGRSpatialReference& crs, const Vec2& centre, RasterProblems& problems,
                 const CrsCommands& commands) {
  const auto lengths = ground_lengths(crs, centre);
  if (!lengths) return;
  const bool x_is_worse = std::abs((*lengths)[0] - 1) > std::abs((*lengths)[1] - 1);
  const double length = (*lengths)[x_is_worse ? 0 : 1];
  if (std::abs(length - 1) <= doubtful_scale) return;
  std::string what = fmt::format("is in {}, whose metres are not metres on the ground", name_of(crs));
  std::string why = fmt::format("at its centre a metre along {} is {:.3f} m", x_is_worse ? "x" : "y", length);
  std::string hint = "Project it: " + command_to_utm(crs, centre, commands);
  if (std::abs(length - 1) > refused_scale) {
    problems.refuse(std::move(what), std::move(why), std::move(hint));
  } else {
    problems.warn(std::move(what), std::move(why), std::move(hint));
  }
}

}  // namespace

std::string wkt_of(const OGRSpatialReference& crs) {
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  char* wkt = nullptr;
  const bool written = crs.exportToWkt(&wkt, options) == OGRERR_NONE && wkt;
  std::string out = written ? wkt : "";
  CPLFree(wkt);
  return out;
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
  return LengthUnit{unit && *unit ? unit : "a unit without a name", metres};
}

void judge_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems) {
  judge_terrain_crs(crs, centre, problems,
                    {[&](const std::string& target) {
                       return problems.command(fmt::format("gdalwarp -t_srs {} -r bilinear", target), "_metres.tif");
                     },
                     problems.command("gdal_translate -a_srs EPSG:XXXX", "_placed.tif")});
}

void judge_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems,
                       const CrsCommands& commands) {
  if (crs.IsGeographic()) {
    problems.refuse("is in degrees",
                    fmt::format("{} is a geographic coordinate system; Talus needs metres on plan", name_of(crs)),
                    "Project it: " + command_to_utm(crs, centre, commands));
  } else if (!crs.IsProjected()) {
    const char* kind = crs.IsLocal() ? "local" : crs.IsGeocentric() ? "geocentric" : "neither projected nor geographic";
    problems.refuse("has no coordinate system of a map",
                    fmt::format("{} is {}; Talus needs a projected one, in metres", name_of(crs), kind),
                    "Name the true one: " + commands.name);
  } else {
    const char* unit = nullptr;
    const double metres = crs.GetLinearUnits(&unit);
    if (std::abs(metres - 1) > 1e-9) {
      problems.refuse("is not in metres on plan",
                      fmt::format("the unit of {} is {}, {:.10g} m", name_of(crs),
                                  unit && *unit ? unit : "one without a name", metres),
                      "Project it: " + command_to_utm(crs, centre, commands));
    } else if (centre) {
      judge_scale(crs, *centre, problems, commands);
    }
  }
}

}  // namespace talus

#endif
