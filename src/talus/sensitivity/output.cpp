#include "talus/sensitivity/output.hpp"

#include <nlohmann/json.hpp>

#include "talus/core/bytes.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"
#include "talus/report/study_page.hpp"
#include "talus/study/saved_sets.hpp"

namespace talus::sensitivity {

namespace {

using Json = nlohmann::ordered_json;

EffectRow row_of(const Study& study, const Input& input, const ResultEffects& result, const Effect& effect) {
  EffectRow row{.site = study.sites[result.site].name,
                .result = study.results[result.result].name,
                .unit = result.unit,
                .input = input.name,
                .values = input.values};
  if (const auto& e = effect.elementary) {
    row.effect = e->magnitude.value;
    row.effect_low = e->magnitude.low;
    row.effect_high = e->magnitude.high;
    row.mean_effect = e->mean;
    row.spread = e->standard_deviation;
  }
  if (const auto& i = effect.index) {
    row.total = i->total.value;
    row.total_low = i->total.low;
    row.total_high = i->total.high;
    row.first = i->first.value;
    row.first_low = i->first.low;
    row.first_high = i->first.high;
  }
  return row;
}

std::string effects_text(const Study& study, const Analysis& analysis) {
  std::string text = header_of<EffectRow>();
  for (const ResultEffects& result : analysis.results) {
    for (std::size_t k = 0; k < analysis.inputs.size(); ++k)
      if (result.of_inputs[k].size()) append_row(text, row_of(study, analysis.inputs[k], result, result.of_inputs[k]));
  }
  return text;
}

std::string runs_text(const Analysis& analysis) {
  std::vector<std::string> names;
  for (const Input& input : analysis.inputs) names.push_back(input.name);
  for (const ResultEffects& result : analysis.results) names.push_back(result.title);
  std::string text = header_of<RunRow>(names);
  RunRow row;
  for (const StudyRun& run : analysis.runs) {
    row.values.assign(run.inputs.begin(), run.inputs.end());
    row.values.insert(row.values.end(), run.results.begin(), run.results.end());
    append_row(text, row);
    ++row.run;
  }
  return text;
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json json_of(const Estimate& estimate) { return {estimate.value, or_null(estimate.low), or_null(estimate.high)}; }

Json json_of(const Effect& effect) {
  Json json = Json::object();
  if (const auto& e = effect.elementary) {
    json["effect"] = json_of(e->magnitude);
    json["mean_effect"] = e->mean;
    json["spread"] = e->standard_deviation;
    json["effects"] = e->count;
  }
  if (const auto& i = effect.index) {
    json["total"] = json_of(i->total);
    json["first"] = json_of(i->first);
  }
  return json;
}

Json summary_of(const Study& study, const Analysis& analysis) {
  Json sites = Json::array(), inputs = Json::array(), results = Json::array(), warnings = Json::array();
  for (const study::GivenSite& site : study.sites)
    sites.push_back({{"name", site.name}, {"project", site.project.string()}});
  for (const Input& input : analysis.inputs)
    inputs.push_back({{"name", input.name}, {"unit", input.unit}, {"values", input.values}});
  for (const ResultEffects& result : analysis.results) {
    Json effects = Json::array();
    for (const Effect& effect : result.of_inputs) effects.push_back(json_of(effect));
    results.push_back({{"title", result.title},
                       {"name", study.results[result.result].name},
                       {"site", study.sites[result.site].name},
                       {"unit", result.unit},
                       {"runs", result.defined},
                       {"mean", or_null(result.mean)},
                       {"least", or_null(result.least)},
                       {"most", or_null(result.most)},
                       {"inputs", std::move(effects)}});
  }
  for (const Problem& problem : analysis.warnings.list()) warnings.push_back(problem.text());
  return {{"talus", {{"version", TALUS_VERSION}}},
          {"name", study.name},
          {"sites", std::move(sites)},
          {"method", name(study.method)},
          {"seed", study.seed},
          {"rocks", study.rocks},
          {"runs", analysis.runs.size()},
          {"confidence", study.confidence},
          {"inputs", std::move(inputs)},
          {"results", std::move(results)},
          {"warnings", std::move(warnings)}};
}

std::string bytes_of(const RunResults& results) {
  ByteWriter out;
  out.count(results.size());
  for (const std::optional<double>& value : results) {
    out.flag(value.has_value());
    out.put(value.value_or(0));
  }
  return out.take();
}

std::optional<RunResults> results_in(std::string_view bytes) {
  try {
    ByteReader in(bytes);
    RunResults results(in.count(1 + sizeof(double)));
    for (std::optional<double>& value : results) {
      const bool is_given = in.flag();
      const auto number = in.get<double>();
      if (is_given) value = number;
    }
    in.expect_end();
    return results;
  } catch (const BadBytes&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<ColumnText> RunRow::family_texts() {
  return {{"…", "", "the value of each input, then of each result; empty if no rock reaches its line"}};
}

void write_results(const std::filesystem::path& folder, const Study& study, const Analysis& analysis) {
  const Json summary = summary_of(study, analysis);
  write_file(folder / EffectRow::file_name, effects_text(study, analysis));
  write_file(folder / RunRow::file_name, runs_text(analysis));
  write_file(folder / "report.html", study_page(study.name, summary));
  write_file(folder / "summary.json", summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::filesystem::path usual_folder(const Study& study) { return study.file.parent_path() / study.name; }

Analysis analyse_into(const std::filesystem::path& folder, const Study& study, const PreparedStudy& prepared,
                      AnalysisOptions options) {
  make_output_folder(folder);
  const FolderLock lock = lock_output_folder(folder);
  const study::SavedSets saved(folder, prepared.fingerprint());
  options.known = [&](std::size_t run) -> std::optional<RunResults> {
    const auto bytes = saved.of(run);
    return bytes ? results_in(*bytes) : std::nullopt;
  };
  options.finished = [&](std::size_t first, std::span<const StudyRun> runs) {
    std::vector<std::string> all;
    for (const StudyRun& run : runs) all.push_back(bytes_of(run.results));
    saved.save(first, all);
  };
  Analysis analysis = prepared.run(options);
  write_results(folder, study, analysis);
  return analysis;
}

}  // namespace talus::sensitivity
