#include "talus/calibration/result_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "talus/calibration/result_summary.hpp"
#include "talus/calibration/saved_samples.hpp"
#include "talus/files/csv_text.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"
#include "talus/model/fixed_columns.hpp"
#include "talus/project/differences.hpp"
#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"
#include "talus/report/study_page.hpp"
#include "talus/study/saved_sets.hpp"

namespace talus::calibration {

namespace {

/// A site's name as the name of a file.
std::string file_name(const std::string& name) {
  std::string safe = name;
  std::ranges::replace_if(
      safe,
      [](unsigned char c) {
        return c < ' ' || std::string_view("/\\:*?\"<>|").find(static_cast<char>(c)) != std::string_view::npos;
      },
      '_');
  return (safe.starts_with('.') ? "_" + safe : safe) + ".toml";
}

/// What the projects of the sites had fixed, as columns of a sample (model/fixed_columns.hpp).
std::vector<project::FixedSetting> fixed_columns(const PreparedStudy& study) {
  std::map<std::string, std::map<std::string, std::vector<std::string>>> sites_of;  // by path and value
  for (std::size_t site = 0; site < study.sites().size(); ++site) {
    const study::PreparedSite& prepared = study.sites()[site];
    const study::PreparedSites::AtSite& here = study.prepared().at_site(site);
    const auto with = [&](double share) {
      return project::echo(
          prepared.with(here.numbers, here.values(study.values_at(Place(study.parameters().size(), share)))));
    };
    std::vector<std::string> varied;
    for (const project::Difference& each : project::differences(with(0.25), with(0.75))) varied.push_back(each.key);
    std::optional<project::Project> as_written;
    try {
      as_written = project::read_project(prepared.project().file).project;
    } catch (const BadInput&) {
      // Without the settings of the study it is no project: then all values of its materials and forests are the
      // study's.
    }
    for (const project::FixedSetting& each :
         project::fixed_settings(prepared.project(), as_written ? &*as_written : nullptr, varied))
      sites_of[each.path][each.value].push_back(study.study().sites[site].name);
  }
  std::vector<project::FixedSetting> columns;
  for (const auto& [path, values] : sites_of) {
    for (const auto& [value, sites] : values)
      columns.push_back({project::fixed_column(path, values.size() > 1 ? sites : std::vector<std::string>()), value});
  }
  return columns;
}

}  // namespace

std::string posterior_table(const PreparedStudy& study, const CalibrationResult& result) {
  constexpr double negligible = 1e-9;
  const std::vector<project::FixedSetting> fixed = fixed_columns(study);
  std::string text;
  CsvRow header(text);
  header << "weight"
         << "score";
  for (const study::Parameter& parameter : study.parameters()) header << std::string_view(parameter.name);
  for (const project::FixedSetting& each : fixed) header << std::string_view(each.path);
  header.end();
  for (const SetResult& set : result.sets) {
    if (set.weight < negligible) continue;
    CsvRow row(text);
    row << set.weight << set.score;
    for (const double value : set.values) row << value;
    for (const project::FixedSetting& each : fixed) row << std::string_view(each.value);
    row.end();
  }
  return text;
}

std::string sets_table(const PreparedStudy& study, const CalibrationResult& result) {
  std::string text;
  CsvRow header(text);
  header << "set"
         << "round"
         << "weight"
         << "score"
         << "log_likelihood"
         << "smoothed_log_likelihood"
         << "agrees";
  for (const study::Parameter& parameter : study.parameters()) header << std::string_view(parameter.name);
  header.end();
  for (std::size_t k = 0; k < result.sets.size(); ++k) {
    const SetResult& set = result.sets[k];
    CsvRow row(text);
    row << k << set.round << set.weight << set.score;
    for (const double value : {set.log_likelihood, set.smoothed_log_likelihood}) {
      if (std::isfinite(value)) {
        row << value;
      } else {
        row << "-inf";
      }
    }
    row << (agrees(set) ? "yes" : "no");
    for (const double value : set.values) row << value;
    row.end();
  }
  return text;
}

std::string project_with(const PreparedStudy& study, std::size_t site, const study::ParameterSet& values,
                         const std::filesystem::path& folder) {
  const study::PreparedSite& prepared = study.sites()[site];
  const study::PreparedSites::AtSite& here = study.prepared().at_site(site);
  const std::filesystem::path& file = prepared.project().file;
  project::Document document(project::text_of_file(file), file.string());
  Problems problems;
  for (const std::string& setting : study.study().sites[site].set) document.set(setting, problems);
  for (const std::string& setting : study.overrides()) document.set(setting, problems);
  const project::Project with = prepared.with(here.numbers, here.values(values));
  for (const project::SettingNumber& number : here.numbers) {
    for (const std::string& setting : number.overrides(with)) document.set(setting, problems);
  }
  const auto absolute = [](const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal();
  };
  for (const project::NamedFile& named : prepared.project().named_files) {
    const std::filesystem::path target = absolute(file.parent_path() / named.file);
    const std::filesystem::path relative = target.lexically_relative(absolute(folder));
    document.set(fmt::format("{}='{}'", named.path, (relative.empty() ? target : relative).generic_string()), problems);
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  std::ostringstream text;
  text << fmt::format("# The best fit of the study {}, written by talus calibrate.\n", study.study().name)
       << toml::toml_formatter(document.root()) << '\n';
  return std::move(text).str();
}

void write_results(const std::filesystem::path& folder, const PreparedStudy& study, const CalibrationResult& result) {
  write_file(folder / "posterior.csv", posterior_table(study, result));
  write_file(folder / "sets.csv", sets_table(study, result));
  const std::filesystem::path best = folder / "best";
  make_output_folder(best);
  for (std::size_t site = 0; site < study.sites().size(); ++site) {
    write_file(best / file_name(study.study().sites[site].name),
               project_with(study, site, result.sets[result.best].values, best));
  }
  const nlohmann::ordered_json summary = summary_of(study, result);
  write_file(folder / "report.html", calibration_page(study.study().name, summary, posterior_sets(result)));
  write_file(folder / "summary.json", summary.dump(2) + '\n');
}

CalibrationResult calibrate_into(const std::filesystem::path& folder, const PreparedStudy& study,
                                 const FolderOptions& options) {
  make_output_folder(folder);
  const FolderLock lock = lock_output_folder(folder);
  const study::SavedSets saved(folder, study.fingerprint());
  const auto known = [&](std::size_t set) -> std::optional<std::vector<Sample>> {
    const auto bytes = saved.of(set);
    return bytes ? samples_in(*bytes) : std::nullopt;
  };
  const auto save = [&](std::size_t first, const std::vector<SetResult>& sets) {
    std::vector<std::string> results;
    for (const SetResult& set : sets) results.push_back(bytes_of(set.samples));
    saved.save(first, results);
  };
  CalibrationResult result = calibrate(study, {.threads = options.threads,
                                               .progress = options.progress,
                                               .phase = options.phase,
                                               .known = known,
                                               .finished = save});
  if (options.phase) options.phase("writing the results");
  write_results(folder, study, result);
  return result;
}

}  // namespace talus::calibration
