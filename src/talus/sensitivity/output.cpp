#include "talus/sensitivity/output.hpp"

#include <nlohmann/json.hpp>

#include "talus/files/output_file.hpp"
#include "talus/report/study_page.hpp"

namespace talus::sensitivity {

namespace {

using Json = nlohmann::ordered_json;

void write_text(const std::filesystem::path& file, const std::string& text) {
  OutputFile out(file);
  out.write(text);
  out.commit();
}

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

Json summary_of(const Study& study, const Analysis& analysis, double seconds) {
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
          {"warnings", std::move(warnings)},
          {"timings", {{"seconds", seconds}}}};
}

}  // namespace

std::vector<ColumnText> RunRow::family_texts() {
  return {{"…", "", "the value of each input, then of each result; empty if no rock reaches its line"}};
}

void write_results(const std::filesystem::path& folder, const Study& study, const Analysis& analysis, double seconds) {
  make_output_folder(folder);
  const Json summary = summary_of(study, analysis, seconds);
  write_text(folder / EffectRow::file_name, effects_text(study, analysis));
  write_text(folder / RunRow::file_name, runs_text(analysis));
  write_text(folder / "report.html", study_page(study.name, summary));
  write_text(folder / "summary.json", summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace talus::sensitivity
