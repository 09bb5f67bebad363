#include "talus/project/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "talus/core/utf8.hpp"
#include "talus/files/sha256.hpp"
#include "talus/project/check.hpp"
#include "talus/project/document.hpp"
#include "talus/project/read_table.hpp"
#include "talus/project/section_of_file.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/toml_kind.hpp"
#include "talus/project/values.hpp"

namespace talus::project {
namespace {

void note_line(Row row, int line) {
  if (auto* area = row.if_is<Area>()) area->line = line;
  if (auto* forest = row.if_is<ForestArea>()) forest->line = line;
  if (auto* shape = row.if_is<Shape>()) shape->line = line;
  if (auto* seeder = row.if_is<Seeder>()) seeder->line = line;
  if (auto* barrier = row.if_is<Barrier>()) barrier->source_line = line;
}

template <class Named>
void name_unnamed(Named& item, std::string_view kind, std::size_t index) {
  if (item.name.empty()) item.name = fmt::format("{} {}", kind, index + 1);
}

/// Sets the defaults that depend on other values.
void complete(Project& project) {
  if (project.name.empty()) project.name = as_utf8(project.file.stem().string());
  for (Layer& layer : project.layers) {
    if (layer.name.empty()) layer.name = as_utf8(layer.file.stem().string());
  }
  // If segments or triangles assign every material, the default is not used and any material will do.
  if (project.ground.default_material.empty() && !project.materials.empty()) {
    project.ground.default_material = project.materials.front().name;
  }
  if (project.output.raster_cell_m == 0) {
    project.output.raster_cell_m = project.terrain.raster.file.empty() ? std::optional(1.0) : std::nullopt;
  }
  for (std::size_t i = 0; i < project.areas.size(); ++i) name_unnamed(project.areas[i], "area", i);
  for (std::size_t i = 0; i < project.forests.size(); ++i) name_unnamed(project.forests[i], "forest", i);
  for (std::size_t i = 0; i < project.seeders.size(); ++i) {
    Seeder& seeder = project.seeders[i];
    name_unnamed(seeder, "seeder", i);
    if (seeder.source.empty()) seeder.source = seeder.name;
  }
  std::size_t barriers = 0, collectors = 0;
  for (Barrier& barrier : project.barriers) {
    if (barrier.is_collector) {
      name_unnamed(barrier, "collector", collectors++);
    } else {
      name_unnamed(barrier, "barrier", barriers++);
    }
  }
}

/// A limit of the store that is given rules alone.
void complete_store(const Document& document, Output& output) {
  const toml::table* given = document.root()["output"].as_table();
  const bool has_rocks = given && given->contains("trajectories"),
             has_size = given && given->contains("trajectories_MB");
  if (has_size && !has_rocks) output.stored_limit.reset();
  if (has_rocks && !has_size) output.trajectories_MB.reset();
}

/// Sets what seeders of a type have unless the project gives it: one rock for each row of a table; and the slopes of an
/// area face in many directions, so its rocks start down them.
void complete_seeders(const Document& document, Project& project) {
  const toml::array* rows = document.root()["seeder"].as_array();
  for (std::size_t i = 0; i < project.seeders.size(); ++i) {
    Seeder& seeder = project.seeders[i];
    const toml::table* row = rows ? (*rows)[i].as_table() : nullptr;
    if (!row) continue;
    std::optional<std::int64_t>& per_row = seeder.from_table.rocks_per_row;
    if (seeder.type == SeederType::table && !per_row && !row->contains("rocks")) per_row = 1;
    if (seeder.is_of_cells() && !row->contains("direction")) seeder.direction.reset();
  }
}

Problem about_option(std::string option, std::string what, std::string why) {
  return {.file = std::move(option), .where = {}, .what = std::move(what), .why = std::move(why), .hint = {}};
}

/// The number of rocks of a seeder with rocks_per_cell or rocks_per_row, and so its share of a total, is known only
/// with the terrain or the table.
void refuse_rocks_per_place(const Project& project, std::int64_t total, Problems& problems) {
  for (std::size_t i = 0; i < project.seeders.size(); ++i) {
    const Seeder& seeder = project.seeders[i];
    const bool is_per_cell = seeder.in_cells.rocks_per_cell.has_value();
    if (!is_per_cell && !seeder.from_table.rocks_per_row) continue;
    const std::string_view place = is_per_cell ? "cell" : "row";
    Problem problem = about_option(
        fmt::format("--rocks {}", total), fmt::format("cannot be shared among the {} seeders", project.seeders.size()),
        fmt::format("seeder {} has rocks_per_{}, and its {}s are not counted yet", i + 1, place, place));
    problem.hint = "Give it rocks instead, or set the rocks of each seeder: --set seeder.0.rocks=...";
    problems.add(std::move(problem));
    return;
  }
}

/// Shares `total` rocks among the seeders in proportion to their rocks, by the largest-remainder method.
void share_rocks(std::vector<Seeder>& seeders, std::int64_t total) {
  // 64 bits of mantissa; rounding errors of the division are corrected by the remainders.
  using Exact = long double;
  Exact all = 0;
  for (const Seeder& seeder : seeders) all += static_cast<Exact>(seeder.rocks);
  std::vector<Exact> remainders(seeders.size());
  std::int64_t left = total;
  for (std::size_t i = 0; i < seeders.size(); ++i) {
    const Exact share = static_cast<Exact>(seeders[i].rocks) * static_cast<Exact>(total) / all;
    seeders[i].rocks = static_cast<std::int64_t>(share);
    remainders[i] = share - static_cast<Exact>(seeders[i].rocks);
    left -= seeders[i].rocks;
  }
  std::vector<std::size_t> order(seeders.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
  for (std::size_t i = 0; left > 0; i = (i + 1) % order.size(), --left) ++seeders[order[i]].rocks;
}

}  // namespace

Reading read_project_text(std::string_view text, const std::filesystem::path& file, const Overrides& overrides) {
  Problems problems;
  Document document(text, file.string());
  expect_kind(document, TomlKind::project);
  for (const std::string& setting : overrides.settings) document.set(setting, problems);

  Reading reading;
  Project& project = reading.project;
  project.file = file;
  project.source = {text.size(), sha256_of(text)};
  ValueReader reader(document, problems);
  for (const Table& table : tables()) {
    const auto add = [&](int line) {
      const Row row = table.add(project);
      note_line(row, line);
      return row;
    };
    read_table(table, document, reader, add, "a project", problems);
  }

  const Range& rocks = setting("seeder", "rocks").range;
  if (overrides.rocks && !rocks.contains(static_cast<double>(*overrides.rocks))) {
    problems.add(about_option(fmt::format("--rocks {}", *overrides.rocks), "this is not a number of rocks",
                              fmt::format("expected {}", rocks.text())));
  }
  // As in a file, where it is a signed 64-bit integer, so that the echo of a run can be read again.
  constexpr auto most_seed = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (overrides.seed && *overrides.seed > most_seed) {
    problems.add(about_option(fmt::format("--seed {}", *overrides.seed), "this is not a seed",
                              fmt::format("expected 0 to {}", most_seed)));
  }
  complete_store(document, project.output);
  complete_seeders(document, project);
  if (overrides.rocks && project.seeders.size() > 1) refuse_rocks_per_place(project, *overrides.rocks, problems);
  if (!problems.has_errors()) complete(project);
  project.named_files = reader.named_files();
  read_section_of_file(project, problems);
  check(project, document, reader.refused(), overrides.asks_a_line, problems);
  problems = problems.in_order_of(document.file());
  if (problems.has_errors()) throw BadInput(std::move(problems));

  if (overrides.rocks) {
    if (project.seeders.size() == 1) {
      project.seeders.front().in_cells.rocks_per_cell.reset();
      project.seeders.front().from_table.rocks_per_row.reset();
    }
    share_rocks(project.seeders, *overrides.rocks);
  }
  if (overrides.seed) project.sampling.seed = *overrides.seed;
  reading.warnings = std::move(problems);
  return reading;
}

Reading read_project(const std::filesystem::path& file, const Overrides& overrides) {
  return read_project_text(text_of_file(file), file, overrides);
}

}  // namespace talus::project
