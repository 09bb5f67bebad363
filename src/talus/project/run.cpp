#include "talus/project/run.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "talus/io/map_files.hpp"
#include "talus/io/output_file.hpp"
#include "talus/io/report.hpp"
#include "talus/io/result_tables.hpp"
#include "talus/io/summary_json.hpp"
#include "talus/project/echo.hpp"

namespace talus::project {

namespace {

void warn_of_lost_and_lifted(const Summary& summary, Problems& warnings) {
  const auto warn = [&](std::string where, std::string what, std::string why, std::string hint) {
    warnings.add({Severity::warning, "", 0, std::move(where), std::move(what), std::move(why), std::move(hint)});
  };
  if (summary.lifted > 0) {
    warn("seeders", fmt::format("{} of {} rocks were lifted onto the surface", summary.lifted, summary.done),
         "they would have started below it", "");
  }
  if (const auto lost = summary.ends[static_cast<std::size_t>(EndReason::lost)]; lost > 0) {
    warn("rocks", fmt::format("{} of {} rocks fell through the surface", lost, summary.done),
         "this is a defect of the program, not of your project",
         fmt::format("Please report it with the output of `talus replay --rock {}`", *summary.first_lost));
  }
}

}  // namespace

std::unique_ptr<MapObserver> map_observer(const Project& project, const Model& model) {
  if (!project.output.maps || std::holds_alternative<Profile>(model.surface)) return nullptr;
  return std::visit(
      [&](const auto& surface) {
        const MapGrid grid =
            MapGrid::at_multiples(project.output.raster_cell_m, model.frame, Vec2(surface.bounds().low.head(2)));
        return std::make_unique<MapObserver>(grid, model.laws.model, [&surface](double x, double y, double below) {
          return surface.elevation(x, y, below);
        });
      },
      model.surface);
}

RunResult run_in_memory(const Model& model, const CampaignOptions& options) {
  SummaryObserver statistics(model.rocks(), model.barriers.size(), model.frame);
  Observer* const observers[] = {&statistics};
  const CampaignOutcome outcome = run_campaign(model, observers, options);
  RunResult result{outcome, statistics.summary(), {}};
  warn_of_lost_and_lifted(result.summary, result.warnings);
  return result;
}

RunResult run_into(const std::filesystem::path& folder, const Project& project, const Model& model,
                   const Problems& warnings, const CampaignOptions& options) {
  make_output_folder(folder);
  const TableContext context = TableContext::of(model);
  SummaryObserver statistics(model.rocks(), model.barriers.size(), model.frame);
  EndpointsTable endpoints(folder / "endpoints.csv", context);
  BarriersTable barriers(folder / "barriers.csv", context);
  std::optional<std::uint64_t> limit;
  if (project.output.path_limit) limit = static_cast<std::uint64_t>(*project.output.path_limit);
  PathsTable paths(folder / "paths.csv", context, model.rocks(), limit);

  Problems map_warnings;
  std::unique_ptr<MapObserver> maps = map_observer(project, model);
  if (maps && !io::can_write_maps()) {
    map_warnings.add({Severity::warning, "", 0, "[output]", "no maps are written",
                      "this program was built without GDAL", "Build it with GDAL, or set maps = false"});
    maps.reset();
  }

  std::vector<Observer*> observers{&statistics, &endpoints, &barriers, &paths};
  if (maps) observers.push_back(maps.get());
  const CampaignOutcome outcome = run_campaign(model, observers, options);
  endpoints.finish();
  barriers.finish();
  paths.finish();
  io::remove_maps(folder / "maps");
  if (maps) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(outcome.threads));
    io::write_maps(maps->maps(), project.output.percentiles, model.crs_wkt, folder / "maps");
  }

  RunResult result{outcome, statistics.summary(), std::move(map_warnings)};
  warn_of_lost_and_lifted(result.summary, result.warnings);
  RunDescription description{project.name, echo(project), {}};
  Problems all = warnings;
  all.append(result.warnings);
  for (const Problem& problem : all.list()) description.warnings.push_back(problem.text());
  OutputFile summary(folder / "summary.json");
  summary.write(summary_json(description, model, result.summary, outcome).dump(1) + "\n");
  summary.commit();
  if (project.output.report) {
    const std::filesystem::path folders[] = {folder};
    io::write_report(folders, folder / "report.html");
  }
  return result;
}

}  // namespace talus::project
