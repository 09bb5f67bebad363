#include "talus/model/release_table_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <numeric>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "talus/core/degrees.hpp"
#include "talus/core/utf8.hpp"
#include "talus/files/data_table.hpp"
#include "talus/files/file_formats.hpp"
#include "talus/files/mesh_problems.hpp"
#include "talus/import/vector_file.hpp"
#include "talus/model/release_columns.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

namespace {

using enum ReleaseColumn;
using Column = ReleaseColumn;

/// A row of the file.
struct FileRow {
  std::function<std::string_view(std::size_t column)> cell;  // of the file's columns; empty: none
  bool comma_is_point = false;
  std::optional<Vec3> point;  // of a vector file
  bool point_has_z = false;
  std::int64_t origin = 0;
  std::function<void(std::string what, std::string why, std::string hint)> refuse;
};

/// Turns rows of a file into rows of a ReleaseTable.
class RowReader {
 public:
  RowReader(const Seeder& seeder, const ReleaseTableContext& context, const FoundColumns& columns)
      : seeder_(seeder),
        context_(context),
        columns_(columns),
        is_2d_(context.project.is_2d()),
        has_own_size_(seeder.size.has_value()) {}

  void add(const FileRow& row) {
    ++number_;
    row_ = &row;
    is_good_ = true;
    values_.fill(ReleaseRow::none);
    for (const ReleaseColumnFacts& facts : release_columns()) read_number(facts);
    if (!is_good_) return;
    ReleaseRow given;
    const Vec3 place = place_of(given);
    read_velocity(given);
    given.spin_vector = vector_of(wx, wy, wz, "spin");
    given.spin = value(spin) * radians;
    read_size(given);
    read_axes(given);
    std::string name = text_of(columns_.name);
    const std::string source = text_of(columns_.source);
    if (!is_good_) return;
    table_.add(context_.model.frame.local_from_global(place), given, source_of(source), number_);
    if (columns_.name) table_.names.push_back(std::move(name));
    origins_.push_back(row.origin);
  }

  void finish(ReadReleases& out) {
    out.table = std::move(table_);
    out.origins = std::move(origins_);
  }

  void warn_of_doubts(const std::string& file, const char* origin_kind, Problems& warnings) const {
    for (const DoubtfulNumber& doubt : doubts_) {
      warnings.add(
          {.severity = Severity::warning,
           .file = file,
           .where = {},
           .what = fmt::format(
               "{} is {} ({} {}{})", doubt.column, number_text(doubt.number), origin_kind, doubt.origin,
               doubt.count > 1 ? fmt::format(", and {}", counted(doubt.count - 1, "other row", "other rows")) : ""),
           .why = doubt.doubt.why,
           .hint = doubt.doubt.hint});
    }
  }

 private:
  struct DoubtfulNumber {
    std::string column;
    double number;
    std::int64_t origin;
    std::uint64_t count;
    Doubt doubt;
  };

  [[nodiscard]] double& value(Column column) { return values_[static_cast<std::size_t>(column)]; }
  [[nodiscard]] bool has(Column column) { return ReleaseRow::has(value(column)); }

  void refuse(std::string what, std::string why, std::string hint = "") {
    is_good_ = false;
    row_->refuse(std::move(what), std::move(why), std::move(hint));
  }

  void read_number(const ReleaseColumnFacts& facts) {
    const auto place = columns_.places[static_cast<std::size_t>(facts.column)];
    const std::string_view text = place ? row_->cell(*place) : std::string_view();
    if (text.empty()) return;
    const std::string name = facts.name();
    const auto number = number_in_cell(text, row_->comma_is_point);
    const Range& range = facts.permitted();
    if (!number || !std::isfinite(*number)) {
      return refuse(fmt::format("{} is {}", name, in_quotes(text)), "expected a number");
    }
    if (!range.contains(*number)) {
      const std::string_view why = *number > range.least ? range.too_high : range.too_low;
      return refuse(fmt::format("{} is {}", name, number_text(*number)),
                    fmt::format("{}{}expected {}", why, why.empty() ? "" : "; ", range.text()));
    }
    value(facts.column) = *number;
    if (facts.setting.empty()) return;
    const Setting& like = setting("seeder", facts.setting);
    auto doubt = like.doubt ? like.doubt(*number) : std::nullopt;
    if (!doubt) return;
    const auto known = std::ranges::find(doubts_, name, &DoubtfulNumber::column);
    if (known != doubts_.end()) {
      ++known->count;
    } else {
      doubts_.push_back({name, *number, row_->origin, 1, std::move(*doubt)});
    }
  }

  /// In the user's coordinates.
  Vec3 place_of(ReleaseRow& given) {
    Vec3 place = row_->point.value_or(Vec3{});
    if (!row_->point) {
      for (const Column column : {x, y}) {
        if (is_2d_ && column == y) continue;
        if (!has(column)) refuse(facts_of(column).name() + " is empty", "every row is a place");
      }
      place = {value(x), is_2d_ ? 0 : value(y), 0};
      if (is_2d_ && has(y) && value(y) != 0) refuse(fmt::format("y_m is {:g}", value(y)), "a section has y = 0");
    }
    if (has(height_above)) {
      if (has(z)) refuse("z_m and height_above_m are given together", "they exclude each other", "Leave one empty");
      given.above_surface = value(height_above);
    } else if (seeder_.height_above_m) {
      given.above_surface = *seeder_.height_above_m;
    } else if (has(z)) {
      place.z() = value(z);
    } else if (!row_->point_has_z) {
      given.above_surface = 0;
    }
    if (ReleaseRow::has(given.above_surface)) place.z() = 0;
    return place;
  }

  /// Three components; those whose column the file does not have are 0.
  Vec3 vector_of(Column first, Column second, Column third, const char* kind) {
    const std::array columns{first, second, third};
    const bool is_given = std::ranges::any_of(columns, [&](Column column) { return has(column); });
    if (!is_given) return Vec3::all(ReleaseRow::none);
    Vec3 vector;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (!columns_.has(columns[k])) continue;
      const std::string name = facts_of(columns[k]).name();
      if (!has(columns[k])) {
        refuse(name + " is empty", fmt::format("other components of the {} are given", kind));
        continue;
      }
      // In a section rocks move in the plane of x and z, and spin about y.
      const bool is_in_plane = kind == std::string_view("spin") ? k == 1 : k != 1;
      if (is_2d_ && !is_in_plane && value(columns[k]) != 0)
        refuse(fmt::format("{} is {:g}", name, value(columns[k])), "in a section it is 0");
      vector[k] = value(columns[k]);
    }
    return vector;
  }

  void read_velocity(ReleaseRow& given) {
    given.velocity = vector_of(vx, vy, vz, "velocity");
    given.speed = value(speed);
    given.horizontal = value(horizontal);
    given.vertical = value(vertical);
    if (has(azimuth)) {
      const double on_plan = value(azimuth) * radians, down = has(plunge) ? value(plunge) * radians : 0;
      given.direction = {std::sin(on_plan) * std::cos(down), std::cos(on_plan) * std::cos(down), -std::sin(down)};
    } else if (has(plunge)) {
      refuse("azimuth_deg is empty", "plunge_deg is given");
    }
  }

  void read_size(ReleaseRow& given) {
    const auto sphere = [](double size) { return std::numbers::pi / 6 * size * size * size; };
    given.mass = value(mass);
    given.density = value(density);
    given.volume = has(volume) ? value(volume) : has(diameter) ? sphere(value(diameter)) : sphere(2 * value(radius));
    if (!ReleaseRow::has(given.mass)) {
      if (!ReleaseRow::has(given.volume) && !has_own_size_)
        refuse("the row gives no mass or size", "neither does the seeder", "Give mass_kg in the project or the table");
      return;
    }
    if (!ReleaseRow::has(given.volume)) return;
    given.density = given.mass / given.volume;
    given.volume = ReleaseRow::none;
    const Range& range = facts_of(density).permitted();
    if (range.contains(given.density)) return;
    refuse(fmt::format("its mass and size make a density of {:.4g} kg/m3", given.density),
           fmt::format("expected {}", range.text()), "Compare their units");
  }

  void read_axes(ReleaseRow& given) {
    if (!columns_.has(axis_a) && !columns_.has(axis_b) && !columns_.has(axis_c)) return;
    const std::array axes{axis_a, axis_b, axis_c};
    const auto count = std::ranges::count_if(axes, [&](Column column) { return has(column); });
    if (count == 0) {
      if (seeder_.shape == sphere_word)
        refuse("the row gives no axes", "other rows may have them, and the seeder names no shape", "Give it a shape");
      return;
    }
    if (count < 3) return refuse("the row gives only some axes", "a block has three: a_m, b_m and c_m");
    given.axes = {value(axis_a), value(axis_b), value(axis_c)};
    std::sort(given.axes.data(), given.axes.data() + Vec3::size(), std::greater{});
    const Range& ratio = setting("shape", "b_over_a").range;
    if (given.axes[2] < ratio.least * given.axes[0]) {
      refuse(fmt::format("its shortest axis is {:.2g} of the longest", given.axes[2] / given.axes[0]),
             fmt::format("expected at least {:g}", ratio.least), "Compare their units");
    }
  }

  SourceId source_of(const std::string& name) {
    const std::string& source = name.empty() ? seeder_.source : name;
    const auto known = sources_.find(source);
    return known != sources_.end() ? known->second : sources_.emplace(source, context_.source_of(source)).first->second;
  }

  std::string text_of(const std::optional<std::size_t>& column) {
    if (!column) return "";
    const std::string_view text = row_->cell(*column);
    const bool is_printable = std::ranges::none_of(text, [](char c) { return (c >= 0 && c < ' ') || c == 127; });
    if (!is_printable || as_utf8(text) != text)
      refuse(fmt::format("the row's text is {}", in_quotes(text)), "expected UTF-8 without line breaks");
    return std::string(text);
  }

  const Seeder& seeder_;
  const ReleaseTableContext& context_;
  const FoundColumns& columns_;
  bool is_2d_, has_own_size_;
  const FileRow* row_ = nullptr;
  bool is_good_ = true;
  std::array<double, release_column_count> values_{};
  std::uint32_t number_ = 0;
  std::vector<DoubtfulNumber> doubts_;
  std::unordered_map<std::string, SourceId> sources_;
  ReleaseTable table_;
  std::vector<std::int64_t> origins_;
};

/// The rows sorted by source, in the order of the file within each.
void sort_by_source(ReadReleases& read) {
  const std::vector<ReleaseTable::Run>& runs = read.table.sources();
  if (std::ranges::is_sorted(runs, {}, &ReleaseTable::Run::source)) return;
  std::vector<SourceId> sources;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::size_t end = run + 1 < runs.size() ? runs[run + 1].first : read.table.count();
    sources.resize(end, runs[run].source);
  }
  std::vector<std::uint32_t> order(read.table.count());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t row) { return sources[row]; });
  ReadReleases sorted{.origin_kind = read.origin_kind, .columns = std::move(read.columns)};
  sorted.table.names = std::move(read.table.names);  // by number in the file
  for (const std::uint32_t row : order) {
    sorted.table.add(read.table.place(row), read.table.given(row), sources[row], read.table.number(row));
    sorted.origins.push_back(read.origins[row]);
  }
  read = std::move(sorted);
}

class TableFile {
 public:
  TableFile(const Seeder& seeder, const FromTable& table, const ReleaseTableContext& context, Problems& warnings)
      : seeder_(seeder),
        table_(table),
        context_(context),
        warnings_(warnings),
        path_(context.project.file.parent_path() / table.file),
        problems_(path_.string(), "rows") {}

  ReadReleases read() {
    if (is_of_kind(table_.file, FileKind::point_text)) {
      read_text();
    } else {
      read_points();
    }
    if (read_.table.count() == 0) {
      throw BadInput(
          Problem{.file = path_.string(), .where = {}, .what = "has no rows", .why = "a row is a release", .hint = {}});
    }
    sort_by_source(read_);
    read_.table.order_by_place();
    return std::move(read_);
  }

 private:
  [[nodiscard]] ColumnRequest request() const {
    return {.name_column = table_.name_attribute,
            .source_column = seeder_.source_attribute,
            .is_2d = context_.project.is_2d(),
            .has_axes = context_.project.analysis.model == RockModel::rigid_body && !context_.project.is_2d(),
            .are_cut = ending_of(table_.file) == ".shp"};
  }

  void find_columns(std::span<const std::string> names, const ColumnRequest& request) {
    columns_ = find_release_columns(names, request, problems_);
    problems_.throw_if_any();
    read_.columns = fmt::format("columns {}", fmt::join(columns_.used, ", "));
    if (columns_.used.empty()) read_.columns = "no columns";
    if (!columns_.unused.empty()) read_.columns += fmt::format(" (not used: {})", fmt::join(columns_.unused, ", "));
    if (columns_.doubtful.empty()) return;
    warnings_.add({.severity = Severity::warning,
                   .file = path_.string(),
                   .where = {},
                   .what = fmt::format("columns are not used: {}", fmt::join(columns_.doubtful, ", ")),
                   .why = "the names in brackets, which are similar, would be",
                   .hint = "Correct the names in the file"});
  }

  void read_text() {
    DataTable text(path_);
    find_columns(text.columns(), request());
    RowReader rows(seeder_, context_, columns_);
    FileRow row{.cell = [&](std::size_t column) { return text.text(column); },
                .comma_is_point = text.comma_is_point(),
                .point = {},
                .refuse = [&](std::string what, std::string why,
                              std::string hint) { text.refuse(std::move(what), std::move(why), std::move(hint)); }};
    while (text.next()) {
      row.origin = text.line();
      rows.add(row);
    }
    text.throw_if_any();
    rows.finish(read_);
    rows.warn_of_doubts(path_.string(), read_.origin_kind, warnings_);
  }

  void read_points() {
    read_.origin_kind = "feature";
    std::vector<std::size_t> place_of_column;  // among the attributes that are read
    VectorRequest vectors{.layer = seeder_.layer,
                          .attributes = {},
                          .kinds = {ShapeKind::point},
                          .heights_are_used = !seeder_.height_above_m,
                          .terrain_crs_wkt = context_.model.crs_wkt};
    vectors.choose = [&](const std::vector<std::string>& names) {
      ColumnRequest columns = request();
      columns.has_geometry = true;
      find_columns(names, columns);
      std::vector<std::string> chosen;
      for (const std::string& name : names) {
        place_of_column.push_back(chosen.size());
        if (std::ranges::find(columns_.used, name) != columns_.used.end()) chosen.push_back(name);
      }
      return chosen;
    };
    const VectorLayer layer = read_vector_file(path_, vectors, warnings_);
    RowReader rows(seeder_, context_, columns_);
    for (const VectorFeature& feature : layer.features) {
      FileRow row{.cell =
                      [&](std::size_t column) {
                        const auto& value = feature.values[place_of_column[column]];
                        return value ? std::string_view(*value) : std::string_view();
                      },
                  .point = {},
                  .point_has_z = feature.has_z,
                  .origin = feature.id,
                  .refuse =
                      [&](const std::string& what, std::string why, std::string hint) {
                        problems_.add(0, fmt::format("feature {}: {}", feature.id, what), std::move(why),
                                      std::move(hint));
                      }};
      for (const VectorShape& part : feature.parts) {
        row.point = part.lists.front().front();
        rows.add(row);
      }
    }
    problems_.throw_if_any();
    rows.finish(read_);
    rows.warn_of_doubts(path_.string(), read_.origin_kind, warnings_);
  }

  const Seeder& seeder_;
  const FromTable& table_;
  const ReleaseTableContext& context_;
  Problems& warnings_;
  std::filesystem::path path_;
  FirstProblems problems_;
  FoundColumns columns_;
  ReadReleases read_;
};

}  // namespace

ReadReleases read_release_table(const Seeder& seeder, const FromTable& table, const ReleaseTableContext& context,
                                Problems& warnings) {
  return TableFile(seeder, table, context, warnings).read();
}

}  // namespace talus::project
