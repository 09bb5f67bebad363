#include "talus/model/choose_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "talus/import/class_raster.hpp"
#include "talus/import/filler_values.hpp"
#include "talus/import/vector_file.hpp"
#include "talus/model/cell_heights.hpp"
#include "talus/seeding/hilbert_curve.hpp"
#include "talus/terrain/slope.hpp"

namespace talus::project {

namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;
constexpr std::size_t masked_at_once = 1 << 20;
constexpr std::size_t most_listed = 8;  // values of a mask in one message

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;  // so that limits of slope are inclusive

double in_degrees(double gradient_squared) { return slope_of_gradient_squared(gradient_squared) * degrees_per_radian; }
double gradient_squared(double slope_deg) { return std::pow(std::tan(slope_deg / degrees_per_radian), 2); }

struct Candidate {
  std::uint32_t cell;
  SourceId source;
};

class Chooser {
 public:
  Chooser(const Seeder& seeder, const InCells& cells, const CellContext& context, Problems& problems,
          Problems& warnings)
      : seeder_(seeder),
        given_(cells),
        context_(context),
        problems_(problems),
        warnings_(warnings),
        heights_(context.model, cells.cell_m.value_or(1)),
        grid_(heights_.grid()),
        least_gradient_(cells.min_slope_deg ? gradient_squared(*cells.min_slope_deg) * (1 - rounding) : 0),
        most_gradient_(cells.max_slope_deg ? gradient_squared(*cells.max_slope_deg) * (1 + rounding) : infinity) {
    if (!cells.mask.empty()) mask_.emplace(folder() / cells.mask, context.model.crs_wkt, warnings);
  }

  std::optional<ReleaseCells> choose(std::string& report) {
    if (given_.has_polygons()) {
      if (!add_cells_within_polygons()) return std::nullopt;
    } else {
      add_all_cells();
    }
    apply_mask();
    if (!report_result()) return std::nullopt;
    ReleaseCells cells = sorted_cells();
    report =
        fmt::format("seeder \"{}\": {} cells of {:g} x {:g} m", seeder_.name, cells.cells.size(), grid_.dx, grid_.dy);
    // The slopes include cells that the mask removed.
    if (!mask_) {
      report +=
          fmt::format(", {:.1f} to {:.1f} deg steep", in_degrees(gentlest_of_kept_), in_degrees(steepest_of_kept_));
    }
    if (cells.sources.size() > 1) report += fmt::format(", of {} sources", cells.sources.size());
    return cells;
  }

 private:
  [[nodiscard]] std::filesystem::path folder() const { return context_.project.file.parent_path(); }
  [[nodiscard]] Vec2 centre(std::uint32_t cell) const {
    return {grid_.x(cell % grid_.columns), grid_.y(cell / grid_.columns)};
  }
  [[nodiscard]] Problem about(std::string what, std::string why, std::string hint = "") const {
    return {.file = context_.project.file.string(),
            .line = seeder_.line,
            .where = fmt::format("seeder \"{}\"", seeder_.name),
            .what = std::move(what),
            .why = std::move(why),
            .hint = std::move(hint)};
  }
  bool refuse(std::string what, std::string why, std::string hint = "") {
    problems_.add(about(std::move(what), std::move(why), std::move(hint)));
    return false;
  }
  void warn(std::string what, std::string why, std::string hint = "") {
    Problem problem = about(std::move(what), std::move(why), std::move(hint));
    problem.severity = Severity::warning;
    warnings_.add(std::move(problem));
  }
  [[nodiscard]] std::string extent_of_terrain() const {
    const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *context_.model.surface);
    const Vec3 low = context_.model.frame.global_from_local(box.low),
               high = context_.model.frame.global_from_local(box.high);
    return fmt::format("x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}", low.x(), high.x(), low.y(), high.y());
  }
  /// The source of the seeder; created when first used.
  SourceId own_source() {
    if (!own_source_) own_source_ = context_.source_of(seeder_.source);
    return *own_source_;
  }
  [[nodiscard]] std::string name_of_polygons() const {
    return given_.polygons.empty() ? "polygon" : fmt::format("polygons \"{}\"", given_.polygons.string());
  }

  /// Adds the cells within each part of each feature; later features replace earlier ones.
  bool add_cells_within_polygons() {
    std::vector<Candidate> found;
    Vec2 low = Vec2::all(infinity), high = -low;
    const Vec2 half(0.5 * grid_.dx, 0.5 * grid_.dy), south_west = grid_.first - half;
    const Vec2 north_east = Vec2(grid_.x(grid_.columns - 1), grid_.y(grid_.rows - 1)) + half;
    std::uint64_t polygons = 0, elsewhere = 0, beyond = 0;
    const auto take = [&](const std::vector<std::vector<Vec3>>& rings, SourceId source) {
      const PlanPolygon polygon(rings);
      ++polygons;
      low = low.min(polygon.low());
      high = high.max(polygon.high());
      const bool touches = polygon.low().is_at_most(north_east) && south_west.is_at_most(polygon.high());
      const bool reaches_beyond = !south_west.is_at_most(polygon.low()) || !polygon.high().is_at_most(north_east);
      elsewhere += touches ? 0 : 1;
      beyond += touches && reaches_beyond ? 1 : 0;
      if (!touches) return;
      visit_points_within(polygon, grid_, [&](std::uint32_t row, std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t column = from; column < to; ++column) {
          found.push_back({row * grid_.columns + column, source});
        }
      });
    };
    if (!given_.polygons.empty()) {
      VectorRequest request{.layer = seeder_.layer,
                            .attributes = {},
                            .kinds = {ShapeKind::polygon},
                            .polygons_are_in_space = false,
                            .heights_are_used = false,
                            .terrain_crs_wkt = context_.model.crs_wkt};
      if (!seeder_.source_attribute.empty()) request.attributes = {seeder_.source_attribute};
      const VectorLayer layer = read_vector_file(folder() / given_.polygons, request, warnings_);
      for (const VectorFeature& feature : layer.features) {
        const bool is_named = !feature.values.empty() && feature.values[0] && !feature.values[0]->empty();
        const SourceId source = is_named ? context_.source_of(*feature.values[0]) : own_source();
        for (const VectorShape& part : feature.parts) take(part.lists, source);
      }
    } else {
      std::vector<std::vector<Vec3>> ring(1);
      for (const auto& [x, y] : given_.polygon) ring[0].emplace_back(x, y, 0);
      take(ring, own_source());
    }
    if (elsewhere == polygons) {
      return refuse(fmt::format("{} does not reach the terrain", name_of_polygons()),
                    fmt::format("it lies within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}; the terrain within {}",
                                low.x(), high.x(), low.y(), high.y(), extent_of_terrain()),
                    given_.polygons.empty() ? "" : "Check its extent and coordinate system with ogrinfo");
    }
    if (found.empty()) {
      return refuse(fmt::format("{} contains no cell", name_of_polygons()),
                    fmt::format("none of the cells of {:g} x {:g} m has its centre inside", grid_.dx, grid_.dy));
    }
    if (elsewhere + beyond > 0) {
      warn(fmt::format("{} of {} polygons extend beyond the terrain or lie outside it", elsewhere + beyond, polygons),
           "rocks start on the terrain only");
    }
    // The sort is stable, so the last candidate for a cell comes last and is kept.
    const auto is_before = [](const Candidate& a, const Candidate& b) { return a.cell < b.cell; };
    if (!std::is_sorted(found.begin(), found.end(), is_before)) {
      std::stable_sort(found.begin(), found.end(), is_before);
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i + 1 == found.size() || found[i + 1].cell != found[i].cell) consider(found[i]);
    }
    return true;
  }

  void add_all_cells() {
    for (std::uint32_t row = 0; row < grid_.rows; ++row) {
      for (std::uint32_t column = 0; column < grid_.columns; ++column) {
        consider({row * grid_.columns + column, own_source()});
      }
    }
  }

  /// Keeps a cell if the terrain has data there and its slope is within the limits.
  void consider(const Candidate& candidate) {
    ++candidates_;
    const auto z = heights_.around(candidate.cell % grid_.columns, candidate.cell / grid_.columns);
    if (!z) return;
    ++with_data_;
    const double gradient = horn_gradient_squared(*z, grid_.dx, grid_.dy);
    if (gradient > steepest_.gradient) steepest_ = {gradient, candidate.cell};
    if (gradient < gentlest_.gradient) gentlest_ = {gradient, candidate.cell};
    if (gradient < least_gradient_ || gradient > most_gradient_) return;
    ++steep_enough_;
    steepest_of_kept_ = std::max(steepest_of_kept_, gradient);
    gentlest_of_kept_ = std::min(gentlest_of_kept_, gradient);
    kept_.push_back(candidate);
    if (mask_ && kept_.size() - masked_ == masked_at_once) apply_mask();
  }

  /// Removes those cells kept since the last call that the mask does not select.
  void apply_mask() {
    if (!mask_) return;
    std::vector<Vec2> places;
    for (std::size_t i = masked_; i < kept_.size(); ++i) places.push_back(centre(kept_[i].cell));
    const auto values = mask_->at(places);
    std::size_t end = masked_;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i]) {
        ++unmasked_;
        continue;
      }
      if (values_.size() < most_listed || values_.contains(*values[i])) {
        ++values_[*values[i]];
      } else {
        ++other_values_;
      }
      const bool is_selected = given_.mask_value ? *values[i] == *given_.mask_value : *values[i] != 0;
      if (is_selected) kept_[end++] = kept_[masked_ + i];
    }
    kept_.resize(end);
    masked_ = end;
  }

  bool report_result() {
    const bool by_polygon = given_.has_polygons();
    if (with_data_ == 0) {
      return refuse("the terrain has no data there",
                    fmt::format("none of {} cells of {:g} x {:g} m{} has data with its eight neighbours", candidates_,
                                grid_.dx, grid_.dy, by_polygon ? " in " + name_of_polygons() : ""));
    }
    if (steep_enough_ == 0) return refuse_slope();
    if (mask_ && kept_.empty()) return refuse_mask();
    if (mask_ && !given_.mask_value) warn_of_mask_fillers();
    if (by_polygon && with_data_ < candidates_) {
      warn(fmt::format("{} of {} cells are left out", candidates_ - with_data_, candidates_),
           "they or one of their eight neighbours have no data, or lie on the edge of the terrain");
    }
    return true;
  }

  bool refuse_slope() {
    const auto place = [&](std::uint32_t cell) {
      const Vec2 at = centre(cell);
      return fmt::format("({:.10g}, {:.10g})", at.x(), at.y());
    };
    const bool too_gentle = steepest_.gradient < least_gradient_;
    if (too_gentle) {
      return refuse(fmt::format("no cell is as steep as {:g} deg", *given_.min_slope_deg),
                    fmt::format("the steepest of {} cells has {:.4g} deg, at {}", with_data_,
                                in_degrees(steepest_.gradient), place(steepest_.cell)));
    }
    if (gentlest_.gradient > most_gradient_) {
      return refuse(fmt::format("no cell is as gentle as {:g} deg", *given_.max_slope_deg),
                    fmt::format("the gentlest of {} cells has {:.4g} deg, at {}", with_data_,
                                in_degrees(gentlest_.gradient), place(gentlest_.cell)));
    }
    return refuse(fmt::format("no cell is {:g} to {:g} deg steep", *given_.min_slope_deg, *given_.max_slope_deg),
                  fmt::format("the {} cells have {:.4g} to {:.4g} deg", with_data_, in_degrees(gentlest_.gradient),
                              in_degrees(steepest_.gradient)));
  }

  bool refuse_mask() {
    const std::string file = given_.mask.string();
    if (mask_->points_within() == 0) {
      return refuse(fmt::format("mask \"{}\" does not reach the terrain", file),
                    "the terrain lies within " + extent_of_terrain(),
                    "Check its extent and coordinate system with gdalinfo");
    }
    return refuse(given_.mask_value ? fmt::format("mask \"{}\" has {} in none of the cells", file, *given_.mask_value)
                                    : fmt::format("mask \"{}\" is 0 in all of the cells", file),
                  fmt::format("of {} cells it has {}", steep_enough_, values_in_mask()));
  }

  [[nodiscard]] std::string values_in_mask() const {
    std::string found;
    for (const auto& [value, count] : values_) {
      found += fmt::format("{}{} in {}", found.empty() ? "" : ", ", value, count);
    }
    if (other_values_ > 0) found += fmt::format(", other values in {}", other_values_);
    if (unmasked_ > 0) found += fmt::format("{}no data in {}", found.empty() ? "" : ", ", unmasked_);
    return found;
  }

  /// Without mask_value every value but 0 selects a cell: also one that means no data, if the file does not declare it.
  /// A mask may select by 255 or 99 alone, and have zones with numbers.
  void warn_of_mask_fillers() {
    std::vector<std::int32_t> selecting;
    for (const auto& [value, count] : values_) {
      if (value != 0) selecting.push_back(value);
    }
    constexpr std::int32_t many_zones = 99;
    const auto filler = std::ranges::find_if(selecting, [&](std::int32_t value) {
      return value < 0 || (selecting.size() > 1 && value >= many_zones && may_be_filler(value));
    });
    if (filler == selecting.end()) return;
    const auto other = std::ranges::find_if(selecting, [&](std::int32_t value) { return value != *filler; });
    warn(fmt::format("mask \"{}\" selects cells by the value {}", given_.mask.string(), *filler),
         fmt::format("every value but 0 does; of {} cells it has {}", steep_enough_, values_in_mask()),
         fmt::format("If {0} means no data, declare it: gdal_translate -a_nodata {0}{1}", *filler,
                     other == selecting.end() ? "" : fmt::format("; or choose a value: mask_value = {}", *other)));
  }

  ReleaseCells sorted_cells() {
    struct Placed {
      std::uint64_t along;
      std::uint32_t cell;
      SourceId source;
    };
    std::vector<Placed> placed;
    placed.reserve(kept_.size());
    for (const Candidate& kept : kept_) {
      placed.push_back(
          {along_hilbert_curve(kept.cell % grid_.columns, kept.cell / grid_.columns), kept.cell, kept.source});
    }
    std::ranges::sort(placed, [](const Placed& a, const Placed& b) {
      return a.source != b.source ? a.source < b.source : a.along < b.along;
    });
    ReleaseCells cells;
    const Vec2 corner = grid_.first - Vec2(0.5 * grid_.dx, 0.5 * grid_.dy);
    cells.corner = corner - Vec2(context_.model.frame.origin.xy());
    cells.dx = grid_.dx;
    cells.dy = grid_.dy;
    cells.columns = grid_.columns;
    cells.place = given_.place;
    cells.cells.reserve(kept_.size());
    for (const Placed& kept : placed) {
      if (cells.sources.empty() || cells.sources.back().source != kept.source) {
        cells.sources.push_back({static_cast<std::uint32_t>(cells.cells.size()), kept.source});
      }
      cells.cells.push_back(kept.cell);
    }
    return cells;
  }

  const Seeder& seeder_;
  const InCells& given_;
  const CellContext& context_;
  Problems& problems_;
  Problems& warnings_;
  CellHeights heights_;
  const PlanGrid& grid_;
  std::optional<SourceId> own_source_;
  std::optional<ClassRaster> mask_;
  std::vector<Candidate> kept_;
  std::size_t masked_ = 0;  // number of kept_ to which the mask was applied
  std::uint64_t candidates_ = 0, with_data_ = 0, steep_enough_ = 0, unmasked_ = 0, other_values_ = 0;
  // Slopes as squared tangents.
  struct Extreme {
    double gradient;
    std::uint32_t cell = 0;
  };
  Extreme steepest_{-1}, gentlest_{infinity};  // of all cells with data
  double steepest_of_kept_ = 0, gentlest_of_kept_ = infinity;
  double least_gradient_, most_gradient_;         // limits
  std::map<std::int32_t, std::uint64_t> values_;  // of the mask, with their numbers of cells
};

}  // namespace

std::optional<ReleaseCells> choose_cells(const Seeder& seeder, const InCells& cells, const CellContext& context,
                                         Problems& problems, Problems& warnings, std::string& report) {
  constexpr double most_cells = 4294967295.0;  // 32-bit indices
  const double count = CellHeights::count(context.model, cells.cell_m.value_or(1));
  if (count > most_cells) {
    problems.add(
        {.file = context.project.file.string(),
         .line = seeder.line,
         .where = fmt::format("seeder \"{}\"", seeder.name),
         .what = fmt::format("cell_m is {:g}", cells.cell_m.value_or(1)),
         .why = fmt::format("the terrain would have {:.4g} such cells; expected at most {:.0f}", count, most_cells),
         .hint = {}});
    return std::nullopt;
  }
  try {
    return Chooser(seeder, cells, context, problems, warnings).choose(report);
  } catch (const BadInput& bad) {
    problems.append(bad.problems());
    return std::nullopt;
  }
}

}  // namespace talus::project
