#include "talus/model/build_seeders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/core/degrees.hpp"
#include "talus/core/overloaded.hpp"
#include "talus/core/stop.hpp"
#include "talus/gdal/zone_in_easting.hpp"
#include "talus/import/vector_file.hpp"
#include "talus/model/build_shapes.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/model/choose_cells.hpp"
#include "talus/model/drawn.hpp"
#include "talus/model/release_table_file.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/varied_section.hpp"

namespace talus::project {

namespace {

constexpr std::uint64_t most_reported = 5;  // places of one seeder

/// Adds one seeder to a model.
class SeederBuilder {
 public:
  SeederBuilder(const Project& project, Model& model, Problems& problems, Problems& warnings)
      : project_(project), model_(model), problems_(problems), warnings_(warnings) {}

  void add(const Seeder& s) {
    talus::Seeder seeder;
    seeder.name = s.name;
    seeder.first_rock = model_.rocks();
    seeder.rocks = static_cast<std::uint64_t>(s.rocks);
    if (!project_.sampling.parameters.empty())
      seeder.rocks_at_once = static_cast<std::uint64_t>(project_.sampling.ensembles);
    if (s.at_points.z_is_surface || s.height_above_m) seeder.above_surface = s.height_above_m.value_or(0);
    set_size_and_speed(s, seeder);
    if (!set_shapes(s, seeder)) return;
    const bool is_placed =
        std::visit(Overloaded{[&](const AtPoints& at) { return place_at_points(s, at.points, seeder); },
                              [&](const AlongLines& lines) { return place_along_lines(s, lines.file, seeder); },
                              [&](const InCells& cells) { return place_in_cells(s, cells, seeder); },
                              [&](const FromTable& table) { return place_at_rows(s, table, seeder); }},
                   s.way());
    if (off_terrain_ > most_reported) {
      report(s, fmt::format("{} more places are off the terrain", off_terrain_ - most_reported), "", "");
    }
    if (!is_placed || seeder.rocks == 0) return;
    seeder.step = even_step(count_places(seeder));
    model_.seeders.push_back(std::move(seeder));
  }

  static void set_size_and_speed(const Seeder& s, talus::Seeder& seeder);

 private:
  [[nodiscard]] Vec3 local(const std::array<double, 3>& p) const {
    return model_.frame.local_from_global({p[0], p[1], p[2]});
  }
  [[nodiscard]] bool is_on_terrain(const Vec2& at) const {
    return std::visit([&](const auto& surface) { return surface.elevation(at.x(), at.y()).has_value(); },
                      *model_.surface);
  }

  bool report(const Seeder& s, std::string what, std::string why, std::string hint) {
    problems_.add({Severity::error, project_.file.string(), s.line, fmt::format("seeder \"{}\"", s.name),
                   std::move(what), std::move(why), std::move(hint)});
    return false;
  }

  bool set_shapes(const Seeder& s, talus::Seeder& seeder) {
    seeder.turn = release_turn(project_, s);
    if (project_.analysis.model != RockModel::rigid_body) return true;
    try {
      std::string about;
      seeder.shapes = build_shapes(project_, s.shape, about, warnings_);
      if (!about.empty()) report(about);
    } catch (const BadInput& bad) {
      problems_.append(bad.problems());
      return false;
    }
    return true;
  }

  SourceId source_of(const std::string& name) {
    const auto found = std::find(model_.sources.begin(), model_.sources.end(), name);
    const auto index = static_cast<std::uint32_t>(found - model_.sources.begin());
    if (found == model_.sources.end()) model_.sources.push_back(name);
    return SourceId{index};
  }

  bool place_at_points(const Seeder& s, const std::vector<std::array<double, 3>>& points, talus::Seeder& seeder) {
    std::vector<Vec3> line;
    for (const auto& p : points) line.push_back(local(p));
    seeder.source = source_of(s.source);
    if (line.size() == 1) {
      seeder.where = line.front();
      return check_on_terrain(s, line.front());
    }
    seeder.where = ReleaseLines(line, seeder.source);
    return check_line(s, line, seeder.above_surface.has_value(), "");
  }

  bool place_along_lines(const Seeder& s, const std::filesystem::path& file, talus::Seeder& seeder) {
    VectorRequest request{.layer = s.layer,
                          .attributes = {},
                          .kinds = {ShapeKind::line},
                          .polygons_are_in_space = false,
                          .heights_are_used = !seeder.above_surface,
                          .terrain_crs_wkt = model_.crs_wkt};
    if (!s.source_attribute.empty()) request.attributes = {s.source_attribute};
    VectorLayer layer;
    try {
      layer = read_vector_file(project_.file.parent_path() / file, request, warnings_);
    } catch (const BadInput& bad) {
      problems_.append(bad.problems());
      return false;
    }
    const auto has_z = [](const VectorFeature& feature) { return feature.has_z; };
    const auto first_without = std::find_if_not(layer.features.begin(), layer.features.end(), has_z);
    if (!seeder.above_surface && first_without != layer.features.end()) {
      if (std::any_of(layer.features.begin(), layer.features.end(), has_z)) {
        return report(s, fmt::format("feature {} of lines \"{}\" has no heights", first_without->id, file.string()),
                      "others do", "Give height_above_m to start all rocks at that height above the terrain");
      }
      seeder.above_surface = 0;
    }
    bool good = true;
    ReleaseLines lines;
    for (const VectorFeature& feature : layer.features) {
      const bool is_named = !feature.values.empty() && feature.values[0] && !feature.values[0]->empty();
      const SourceId source = source_of(is_named ? *feature.values[0] : s.source);
      for (const VectorShape& part : feature.parts) {
        std::vector<Vec3> line;
        for (const Vec3& p : part.lists.front()) {
          // Lengths along lines on the ground are measured on plan.
          line.push_back(model_.frame.local_from_global(seeder.above_surface ? Vec3(p.x(), p.y(), 0) : p));
        }
        good = check_line(s, line, seeder.above_surface.has_value(), fmt::format("feature {}, ", feature.id)) && good;
        lines.add(line, source);
      }
    }
    if (lines.length() == 0) return report(s, fmt::format("lines \"{}\" have no length", file.string()), "", "");
    report(fmt::format("seeder \"{}\": {} lines, {:.6g} m long", s.name, layer.features.size(), lines.length()));
    seeder.where = std::move(lines);
    return good;
  }

  bool place_in_cells(const Seeder& s, const InCells& given, talus::Seeder& seeder) {
    const CellContext context{project_, model_, [this](const std::string& name) { return source_of(name); }};
    std::string found;
    auto cells = choose_cells(s, given, context, problems_, warnings_, found);
    if (!cells) return false;
    if (given.rocks_per_cell && !set_rocks(s, seeder, *given.rocks_per_cell, cells->cells.size(), "cells"))
      return false;
    seeder.source = cells->sources.front().source;
    seeder.above_surface = s.height_above_m.value_or(0);
    report(fmt::format("{}; {} rocks", found, seeder.rocks));
    seeder.where = std::move(*cells);
    return true;
  }

  /// A row of a table is a place.
  bool place_at_rows(const Seeder& s, const FromTable& table, talus::Seeder& seeder) {
    const ReleaseTableContext context{project_, model_, [this](const std::string& name) { return source_of(name); }};
    ReadReleases read;
    try {
      read = read_release_table(s, table, context, warnings_);
    } catch (const BadInput& bad) {
      problems_.append(bad.problems());
      return false;
    }
    const std::size_t rows = read.table.count();
    if (table.rocks_per_row && !set_rocks(s, seeder, *table.rocks_per_row, rows, "rows")) return false;
    bool good = set_shapes_of_rows(s, read.table, seeder);
    for (std::size_t row = 0; row < rows; ++row) {
      stop_point(row);
      const Vec3& place = read.table.place(row);
      if (is_on_certain_terrain(place)) continue;
      good = check_on_terrain(s, place, fmt::format("{} {}: ", read.origin_kind, read.origins[row])) && good;
    }
    if (seeder.rocks < rows) {
      warnings_.add({.severity = Severity::warning,
                     .file = project_.file.string(),
                     .line = s.line,
                     .where = fmt::format("seeder \"{}\"", s.name),
                     .what = fmt::format("{} of {} rows release no rock", rows - seeder.rocks, rows),
                     .why = fmt::format("the seeder has {} rocks", seeder.rocks),
                     .hint = "Leave out rocks, or give rocks_per_row"});
    }
    seeder.source = read.table.sources().front().source;
    report(fmt::format("seeder \"{}\": {} rows of \"{}\", {}; {} rocks", s.name, rows, table.file.string(),
                       read.columns, seeder.rocks));
    seeder.where = std::move(read.table);
    return good;
  }

  /// Axes in a table stretch the blocks of the seeder's shape; without one, rounded blocks.
  bool set_shapes_of_rows(const Seeder& s, const ReleaseTable& table, talus::Seeder& seeder) {
    if (!table.has_axes()) return true;
    if (s.shape == sphere_word) {
      std::string about;
      seeder.shapes = build_shapes(project_, "equant", about, warnings_);
    }
    const auto is_fixed = [](const RockKind& kind) { return !kind.stretch; };
    if (std::ranges::none_of(seeder.shapes->kinds, is_fixed)) return true;
    return report(s, fmt::format("shape is \"{}\", and its table gives the axes of blocks", s.shape),
                  "only a block can have any axes", "Use a shape with b_over_a and c_over_b, or rename a_m, b_m, c_m");
  }

  /// `each` rocks from each of `count` places.
  bool set_rocks(const Seeder& s, talus::Seeder& seeder, std::int64_t each, std::size_t count, const char* places) {
    const double rocks = static_cast<double>(each) * static_cast<double>(count);
    const double most = setting("seeder", "rocks").range.most;
    if (static_cast<double>(model_.rocks()) + rocks > most) {
      return report(s, fmt::format("{} rocks from each of {} {}", each, count, places),
                    fmt::format("expected at most {:g} rocks in all", most), "Give fewer, or use rocks");
    }
    seeder.rocks = static_cast<std::uint64_t>(each) * count;
    return true;
  }

  void report(const std::string& line) {
    if (!model_.seeder_report.empty()) model_.seeder_report += '\n';
    model_.seeder_report += line;
  }

  bool check_line(const Seeder& s, const std::vector<Vec3>& line, bool is_on_ground, const std::string& which) {
    bool good = true;
    for (const Vec3& p : line) good = check_on_terrain(s, p, which) && good;
    if (!good || !is_on_ground || std::holds_alternative<Profile>(*model_.surface)) return good;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Vec2 from = line[k].xy(), to = line[k + 1].xy();
      std::vector<Vec3> ground;
      if (const auto* mesh = std::get_if<TriangleMesh>(&*model_.surface)) ground = mesh->draped(from, to);
      if (const auto* raster = std::get_if<RasterSurface>(&*model_.surface)) ground = raster->draped(from, to);
      // There is a point wherever the ground bends, so between two points there is either ground throughout or none.
      for (std::size_t i = 0; i + 1 < ground.size(); ++i) {
        const Vec3 between = 0.5 * (ground[i] + ground[i + 1]);
        if (is_on_terrain(between.xy())) continue;
        good = check_on_terrain(s, between, which) && good;
      }
    }
    return good;
  }

  [[nodiscard]] bool is_on_certain_terrain(const Vec3& at) const { return !model_.varying && is_on_terrain(at.xy()); }

  bool check_on_terrain(const Seeder& s, const Vec3& at, const std::string& which = "") {
    if (is_on_terrain(at.xy())) return check_on_varied_section(s, at.x(), which);
    if (++off_terrain_ > most_reported) return false;
    const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *model_.surface);
    const Vec3 low = model_.frame.global_from_local(box.low), high = model_.frame.global_from_local(box.high);
    const Vec3 p = model_.frame.global_from_local(at);
    const bool is_within =
        at.x() >= box.low.x() && at.x() <= box.high.x() && at.y() >= box.low.y() && at.y() <= box.high.y();
    const bool is_flat = project_.is_2d();
    return report(s,
                  is_flat ? fmt::format("{}x = {:.10g} is off the terrain", which, p.x())
                          : fmt::format("{}({:.10g}, {:.10g}) is off the terrain", which, p.x(), p.y()),
                  is_flat ? fmt::format("the section extends from x = {:.10g} to {:.10g}", low.x(), high.x())
                  : is_within
                      ? std::string("the terrain has a hole there, without data or triangles")
                      : fmt::format("on plan the terrain lies within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}",
                                    low.x(), high.x(), low.y(), high.y()),
                  project_.terrain.rotate_deg != 0 ? "terrain.rotate_deg rotates only the terrain, not the seeders"
                  : !is_flat && is_on_terrain(local({p.y(), p.x(), p.z()}).xy()) ? swapped_hint
                  : !is_flat                                                     ? hint_for_zone(p, low.x())
                                                                                 : "");
  }

  /// If a place lies on the terrain with the number of a zone in front of its easting, or without it. Empty if not.
  [[nodiscard]] std::string hint_for_zone(const Vec3& p, double terrain_x) const {
    const double shift =
        (std::floor(terrain_x / metres_per_zone) - std::floor(p.x() / metres_per_zone)) * metres_per_zone;
    if (shift == 0 || !is_on_terrain(local({p.x() + shift, p.y(), p.z()}).xy())) return "";
    return fmt::format("With x = {:.10g} it would lie on the terrain: eastings may begin with the number of a zone",
                       p.x() + shift);
  }

  /// Checks that a section with varying vertices has ground at x for every rock.
  bool check_on_varied_section(const Seeder& s, double x, const std::string& which) {
    if (!model_.varying) return true;
    const CertainStretch certain = certain_stretch(project_.terrain.section);
    const double origin = model_.frame.origin.x();
    if (x >= certain.from - origin && x <= certain.to - origin) return true;
    if (++off_terrain_ > most_reported) return false;
    return report(s, fmt::format("{}x = {:.10g} may be off the terrain", which, x + origin), why_uncertain(certain),
                  "Move it inwards, or reduce the standard deviations in x of the end vertices");
  }

  const Project& project_;
  Model& model_;
  Problems& problems_;
  Problems& warnings_;
  std::uint64_t off_terrain_ = 0;  // number of places
};

void SeederBuilder::set_size_and_speed(const Seeder& s, talus::Seeder& seeder) {
  if (s.size) {
    seeder.size_of = s.size->of;
    seeder.size = sampler_of(s.size->key(), s.size->distribution);
  }
  seeder.density = sampler_of("density_kg_m3", s.density_kg_m3);
  seeder.direction.reset();
  if (const auto& d = s.direction) seeder.direction = Vec3((*d)[0], (*d)[1], (*d)[2]).normalized();
  if (s.speed_m_s) seeder.speed = sampler_of("speed_m_s", *s.speed_m_s);
  seeder.horizontal = sampler_of("horizontal_velocity_m_s", s.horizontal_velocity_m_s);
  seeder.vertical = sampler_of("vertical_velocity_m_s", s.vertical_velocity_m_s);
  seeder.spin = sampler_of("rotational_velocity_deg_s", s.rotational_velocity_deg_s, radians);
}

}  // namespace

void set_sizes_and_velocities(const Seeder& given, talus::Seeder& seeder) {
  SeederBuilder::set_size_and_speed(given, seeder);
}

void add_seeders(const Project& project, Model& model, Problems& problems, Problems& warnings) {
  for (std::size_t i = 0; i < project.seeders.size(); ++i) {
    const Seeder& seeder = project.seeders[i];
    locating_problems(project, name_in_problems(project, "seeder", seeder.name, i), problems, warnings,
                      [&](Problems& own_problems, Problems& own_warnings) {
                        SeederBuilder(project, model, own_problems, own_warnings).add(seeder);
                        return true;
                      });
  }
}

}  // namespace talus::project
