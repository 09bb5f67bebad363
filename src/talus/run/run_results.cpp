#include "talus/run/run_results.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <system_error>

#include "talus/archive/design_tables.hpp"
#include "talus/archive/envelope_table.hpp"
#include "talus/archive/figure_counts.hpp"
#include "talus/archive/model_json.hpp"
#include "talus/archive/uncertainty_table.hpp"
#include "talus/campaign/paths_revision.hpp"
#include "talus/core/check.hpp"
#include "talus/core/memory.hpp"
#include "talus/export/derived_files.hpp"
#include "talus/export/vector_out.hpp"
#include "talus/files/file_record.hpp"
#include "talus/files/output_file.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/maps/source_maps.hpp"
#include "talus/model/design_plan.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/named_files.hpp"
#include "talus/report/report.hpp"
#include "talus/run/result_files.hpp"
#include "talus/run/run_size.hpp"
#include "talus/run/run_warnings.hpp"
#include "talus/store/trajectory_store.hpp"

namespace talus::project {

namespace {

/// The cells of the maps: of the project's size, or those of the terrain's raster.
template <class Surface>
MapGrid map_grid(const Project& project, const LocalFrame& frame, const Surface& surface) {
  const Vec2 low = surface.bounds().low.xy();
  if (const auto cell = project.output.raster_cell_m) {
    const double across = (surface.bounds().high.xy() - low).largest() / *cell;
    if (across < MapGrid::most_cells_across) return MapGrid::at_multiples(*cell, frame, low);
    throw BadInput(Problem{.file = project.file.string(),
                           .where = "[output]",
                           .what = fmt::format("raster_cell_m is {:g}", *cell),
                           .why = fmt::format("the terrain is {:.3g} such cells wide; expected fewer than {:g}", across,
                                              MapGrid::most_cells_across),
                           .hint = "Choose larger cells"});
  }
  if constexpr (std::is_same_v<Surface, RasterSurface>) {
    const RasterGrid& raster = surface.grid();
    return MapGrid::around_nodes({raster.x0, raster.y0}, {raster.dx, raster.dy}, frame);
  }
  TALUS_PROMISE(false, "the project was checked: only a raster has cells of its own");
  return MapGrid::at_multiples(1, frame, low);
}

std::optional<std::size_t> split_by(const RunDescription& description) {
  if (!description.maps->by_source) return std::nullopt;
  return description.sources.size();
}

void warn_of_unwritten_files(const RunDescription& description, Problems& warnings) {
  const auto warn = [&](const char* what, const char* setting) {
    warnings.add({Severity::warning, "", 0, "[output]", what, "this program was built without GDAL",
                  fmt::format("Build it with GDAL, or set {}", setting)});
  };
  if (description.wants_maps && !can_write_maps()) warn("no maps are written", "maps = false");
  if (description.wants_geopackage && !can_write_geopackage()) {
    warn("no GeoPackage is written", "geopackage = \"none\"");
  }
}

/// If every rock has a section of its own, heights above the ground are left out: they have no common reference.
void write_section_envelopes(const std::filesystem::path& folder, const RunDescription& description,
                             MapObserver* maps) {
  remove_envelopes(folder);
  if (maps == nullptr || !description.wants_envelopes) return;
  const nlohmann::ordered_json::json_pointer deviations("/terrain/section_std_dev_m");
  write_envelopes(folder, {maps->maps(), maps->by_ensemble()}, description.maps->selection,
                  !description.project.contains(deviations));
}

void write_all_maps(const std::filesystem::path& folder, const RunDescription& description, MapObserver* maps,
                    int threads) {
  remove_maps(folder);
  remove_source_maps(folder / "by_source");
  if (maps == nullptr || !description.wants_maps || !can_write_maps()) return;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const MapSelection& selection = description.maps->selection;
  write_maps({maps->maps(), maps->by_ensemble()}, selection, description.crs_wkt, folder);
  if (description.maps->by_source) {
    write_source_maps(maps->by_source(), description.sources, selection, description.crs_wkt, folder / "by_source");
  }
}

std::optional<StoredRocks> write_store(const std::filesystem::path& folder, RunSums& sums) {
  if (sums.store() == nullptr) return std::nullopt;
  const std::uint64_t done = sums.summary().done;
  const auto [rocks, rows, bytes] = sums.store()->write(folder / trajectories_name, done);
  const double share = done > 0 ? static_cast<double>(rocks) / static_cast<double>(done) : 1;
  return StoredRocks{rocks, share, rows, bytes};
}

StoreBudget budget_of_store(const RunDescription& description) {
  return {*description.store_bytes, description.store_rocks};
}

/// How many ensembles have maps of their own.
std::size_t ensembles_with_maps(const MapSelection& selection, const Model& model) {
  return selection.bands.any() ? model.ensembles.size() : 0;
}

}  // namespace

MapSelection map_selection(const Project& project, const Model& model) {
  const bool is_section = std::holds_alternative<Profile>(*model.surface);
  const std::vector<double> usual = is_section ? std::vector<double>{50, 95, 99} : std::vector<double>{95};
  MapSelection selection{project.output.maps, project.output.percentiles.value_or(usual)};
  selection.means = is_section || project.output.means;
  if (!model.ensembles.empty()) selection.bands = project.output.bands & project.output.maps & banded_map_subjects;
  return selection;
}

std::unique_ptr<MapObserver> map_observer(const Project& project, const Model& model) {
  if (project.output.maps.none()) return nullptr;
  const bool is_section = std::holds_alternative<Profile>(*model.surface);
  return std::visit(
      [&](const auto& surface) {
        const MapGrid grid = map_grid(project, model.frame, surface);
        std::optional<std::size_t> sources;
        if (project.output.maps_by_source && !is_section) sources = model.sources.size();
        const MapSelection selection = map_selection(project, model);
        return std::make_unique<MapObserver>(grid, max_height_over(surface, model.laws.model), sources,
                                             contents_of(selection), ensembles_with_maps(selection, model),
                                             contents_of_ensembles(selection));
      },
      *model.surface);
}

RunDescription plan_of(const Project& project, const Model& model) {
  RunDescription description;
  description.name = project.name;
  description.rocks = model.rocks();
  description.barriers = model.barriers.size();
  description.crs_wkt = model.crs_wkt;
  description.sources = model.sources;
  const bool is_section = std::holds_alternative<Profile>(*model.surface);
  description.wants_maps = project.output.maps.any() && !is_section;
  description.wants_envelopes = project.output.maps.any() && is_section;
  if (project.output.maps.any()) {
    const MapGrid grid =
        std::visit([&](const auto& surface) { return map_grid(project, model.frame, surface); }, *model.surface);
    const bool by_source = project.output.maps_by_source && !is_section;
    const MapSelection selection = map_selection(project, model);
    description.maps = {grid.origin(), grid.cell(), by_source, ensembles_with_maps(selection, model), selection};
  }
  if (project.design) description.design = design_plan(project, model);
  description.wants_geopackage = !is_section && project.output.geopackage_limit != 0;
  description.wants_report = project.output.report;
  const auto &megabytes = project.output.trajectories_MB, &stored = project.output.stored_limit;
  if (megabytes != 0 && stored != 0) {
    constexpr std::uint64_t megabyte = 1'000'000;
    description.store_bytes = megabytes ? static_cast<std::uint64_t>(*megabytes) * megabyte : StoreObserver::no_limit;
    if (stored) description.store_rocks = static_cast<std::uint64_t>(*stored);
  }
  return description;
}

void identify(RunDescription& description, const Project& project, const Model& model, const Problems& warnings) {
  description.project = echo(project);
  description.fingerprint = fingerprint_of(description.project, model);
  description.paths_revision = paths_revision;
  description.sample = sample_of(model);
  description.model = model_json(model);
  for (const Problem& problem : warnings.list())
    description.warnings.add(problem, with_relative_paths(problem.text(), project.file.parent_path()));
}

RunDescription describe(const Project& project, const Model& model, const Problems& warnings) {
  RunDescription description = plan_of(project, model);
  identify(description, project, model, warnings);
  return description;
}

RunDescription describe_run(const Project& project, const Model& model, const Problems& warnings,
                            const std::optional<Shard>& shard) {
  RunDescription description = describe(project, model, warnings);
  if (description.wants_maps && !can_write_maps() && !shard) description.maps.reset();
  return description;
}

TableRocks table_rocks(const Project& project, std::uint64_t rocks) {
  return TableRocks(rocks, {.endpoints = project.output.endpoint_limit,
                            .paths = project.output.path_limit,
                            .impacts = project.output.impact_limit});
}

RunSums::RunSums(const RunDescription& description, const Project& project, const Model& model)
    : summary_(description.rocks, description.barriers, model.frame, model.runout_frame) {
  if (description.design) design_.emplace(*description.design, description.rocks);
  if (description.maps) maps_ = map_observer(project, model);
  if (description.store_bytes) store_ = std::make_unique<StoreObserver>(budget_of_store(description), model);
}

RunSums::RunSums(const RunDescription& description)
    : summary_(description.rocks, description.barriers, {origin_of(description)}) {
  if (description.design) design_.emplace(*description.design, description.rocks);
  if (description.store_bytes) store_ = std::make_unique<StoreObserver>(budget_of_store(description));
  if (!description.maps) return;
  const MapGrid grid(description.maps->origin, description.maps->cell, {});
  const MapSelection& selection = description.maps->selection;
  maps_ = std::make_unique<MapObserver>(grid, nullptr, split_by(description), contents_of(selection),
                                        description.maps->ensembles, contents_of_ensembles(selection));
}

void RunSums::limit_maps_memory(std::uint64_t bytes) {
  if (maps_) maps_->limit_memory(bytes > 0 ? bytes : usable_memory() / 2);
}

std::optional<std::string> RunSums::lacking_memory() const {
  if (!maps_ || !maps_->lacks_memory()) return std::nullopt;
  return fmt::format(
      "not enough memory for the maps of this run: they take {}, and {} is what they may (--maps-memory)",
      size_text(static_cast<double>(maps_->memory_taken())), size_text(static_cast<double>(maps_->memory_limit())));
}

std::vector<SummingObserver*> RunSums::observers() {
  std::vector<SummingObserver*> list{&summary_};
  if (design_) list.push_back(&*design_);
  if (maps_) list.push_back(maps_.get());
  if (store_) list.push_back(store_.get());
  return list;
}

namespace {

/// Writes the files derived from the tables and the summary, which is still named `summary`.
void write_derived(const std::filesystem::path& folder, const RunDescription& description,
                   const std::optional<DesignResult>& design, const std::filesystem::path& summary) {
  remove_design_tables(folder);
  if (design) write_design_tables(folder, *description.design, *design);
  remove_uncertainty(folder);
  if (ensembles_of(description.project) > 0) write_uncertainty(folder, read_uncertainty(folder, summary.c_str()));
  write_derived_files(folder, summary.c_str());
  // A report of an earlier run would not match the tables.
  std::error_code ignored;
  std::filesystem::remove(folder / "report.html", ignored);
  if (!description.wants_report) return;
  const std::filesystem::path folders[] = {folder};
  (void)write_report(folders, folder / "report.html", summary.c_str());
}

}  // namespace

Findings findings_of(const RunDescription& description, const RunSums& sums, const RunCourse& course) {
  Findings found;
  warn_of_rocks(sums.summary(), found.warnings);
  warn_of_collectors(description, sums.summary(), found.warnings);
  if (course.interrupted && !course.shard && course.missing.empty()) {
    warn_of_sources(description, sums.summary().done, found.warnings);
  }
  if (sums.design() != nullptr) {
    found.design = evaluate(sums.design()->plan(), sums.design()->tally());
    if (!course.shard) warn_of_design(sums.design()->plan(), *found.design, found.warnings);
  }
  return found;
}

void write_summary(TextSink& out, const RunDescription& description, const Problems& found,
                   const std::optional<DesignResult>& design, const RunSums& sums, const RunCourse& course) {
  ToldWarnings warnings = description.warnings;
  for (const Problem& problem : found.list()) warnings.add(problem, problem.text());
  talus::write_summary(out, description, warnings, sums.summary(), course, design ? &*design : nullptr);
}

WrittenResults write_results(const std::filesystem::path& folder, const RunDescription& description, RunSums& sums,
                             RunCourse course) {
  Problems found;
  if (!course.shard) {
    course.trajectories = write_store(folder, sums);
    warn_of_unwritten_files(description, found);
    write_all_maps(folder / "maps", description, sums.maps(), course.threads);
    write_section_envelopes(folder, description, sums.maps());
  }
  const Findings findings = findings_of(description, sums, course);
  found.append(findings.warnings);
  OutputFile summary(folder / "summary.json");
  write_summary(summary, description, found, findings.design, sums, course);
  summary.sync();
  if (!course.shard) write_derived(folder, description, findings.design, OutputFile::part_of("summary.json"));
  const std::vector<std::string> written = written_files(folder, description, course.shard);
  remove_recorded_files_but(folder, written);
  write_file_record(folder, written);
  summary.commit();
  return {std::move(found), course.trajectories};
}

}  // namespace talus::project
