#include "talus/archive/figure_counts.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "talus/core/vec.hpp"
#include "talus/results/ensemble.hpp"

namespace talus {

std::uint64_t ensembles_of(const JsonValue& project) {
  const auto sampling = project.find("sampling");
  if (sampling == project.end() || !sampling->is_object() || !sampling->contains("parameters")) return 0;
  if (!sampling->at("parameters").is_string() || sampling->at("parameters").get<std::string>().empty()) return 0;
  const auto ensembles = sampling->find("ensembles");
  if (ensembles == sampling->end() || !ensembles->is_number_integer() || ensembles->get<std::int64_t>() < 0) return 0;
  return std::min(ensembles->get<std::uint64_t>(), most_ensembles);
}

FigureCounts::FigureCounts(const RunSummary& summary) {
  if (summary.rocks.done != summary.rocks.planned) return;
  std::vector<const BarrierSummary*> barriers;
  for (const BarrierSummary& barrier : summary.barriers) barriers.push_back(&barrier);
  std::ranges::stable_sort(barriers, std::ranges::greater(), &BarrierSummary::hits);
  if (barriers.size() > Convergence::most_lines) barriers.resize(Convergence::most_lines);
  std::vector<std::string> lines;
  for (const BarrierSummary* barrier : barriers) lines.push_back(barrier->name);
  convergence_.emplace(summary.rocks.planned, lines);
  EnsembleRocks run{.rocks = summary.rocks.planned, .ensembles = ensembles_of(*summary.project)};
  if (run.ensembles < 2) return;
  run.parameter_sets = summary.parameter_sets.value_or(run.parameter_sets);
  if (!summary.releases.empty()) run.seeders_begin.clear();
  for (const SeederReleases& of : summary.releases) run.seeders_begin.push_back(of.first_rock);
  uncertainty_.emplace(std::move(run), std::move(lines));
}

void FigureCounts::add(const TableReader<EndpointRow>& row) {
  using R = EndpointRow;
  const auto rock = row.get<&R::rock>();
  const RockValues values{row.get<&R::runout_xy_m>(), row.get<&R::max_ke_J>(), row.get<&R::max_bounce_m>()};
  if (convergence_) convergence_->add_end(rock, values);
  if (uncertainty_) uncertainty_->add_end(rock, values);
}

void FigureCounts::add(const TableReader<HitRow>& row) {
  using R = HitRow;
  const auto rock = row.get<&R::rock>();
  const std::string_view line = row.get<&R::barrier>();
  const ArrivalValues values{row.get<&R::ke_total_J>(), vector(row.get<&R::velocity_m_s>()).norm(),
                             row.get<&R::top_height_m>()};
  if (convergence_) convergence_->add_arrival(rock, line, values);
  if (uncertainty_) uncertainty_->add_arrival(rock, line, values);
}

Uncertainty read_uncertainty(const std::filesystem::path& folder, const char* summary) {
  std::vector<BarrierSummary> barriers;
  RunSummary run =
      read_run_summary(folder / summary, [&](BarrierSummary each) { barriers.push_back(std::move(each)); });
  run.barriers = std::move(barriers);
  FigureCounts figures(run);
  std::error_code ignored;
  if (const auto file = folder / EndpointRow::file_name; std::filesystem::exists(file, ignored))
    for (TableReader<EndpointRow> row(file); row.next();) figures.add(row);
  if (const auto file = folder / HitRow::file_name; std::filesystem::exists(file, ignored))
    for (TableReader<HitRow> row(file); row.next();) figures.add(row);
  return figures.uncertainty();
}

}  // namespace talus
