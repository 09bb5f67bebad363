#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/svg.hpp"
#include "talus/calibration/validation_results.hpp"

namespace talus::validation {

namespace {

using calibration::escaped;
using calibration::Plot;

constexpr const char* style =
    "body{font:15px/1.5 system-ui,sans-serif;color:#222;max-width:1120px;margin:24px auto;padding:0 16px}"
    "h1{font-size:24px}h2{font-size:19px;margin-top:32px}h3{font-size:16px;margin:20px 0 4px}"
    "table{border-collapse:collapse;margin:8px 0}td,th{padding:3px 10px;text-align:right;border-bottom:1px solid #ddd}"
    "td:first-child,th:first-child{text-align:left}figure{display:inline-block;margin:6px 10px 6px "
    "0;vertical-align:top}"
    "figcaption{font-size:13px;color:#444;max-width:500px}svg text{font-size:11px;fill:#444}.grid{stroke:#e6e6e6}"
    ".wide{stroke:#1f6fb4;stroke-width:1;fill:none}.narrow{stroke:#1f6fb4;stroke-width:4;stroke-opacity:.45;fill:none}"
    ".band{fill:#1f6fb4;fill-opacity:.2}.median{fill:none;stroke:#1f6fb4;stroke-width:1.5}"
    ".steps{fill:none;stroke:#c03;stroke-width:1.8}.observed{fill:#c03}.other{fill:none;stroke:#999;stroke-width:1.5;"
    "stroke-dasharray:4 3}.predicted{fill:#1f6fb4;fill-opacity:.13}.release{fill:#222}"
    ".limit,.warning{background:#fff4d6;border-left:4px solid #e0a800;padding:4px 10px;margin:4px 0}";

constexpr std::size_t dots_of_map = 1500;  // predicted stops

std::string figure_of(const Plot& plot, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", plot.text(), escaped(caption));
}

std::string list_of(const std::vector<std::string>& items) {
  std::string text = "<ul>\n";
  for (const std::string& item : items) text += fmt::format("<li>{}</li>\n", escaped(item));
  return text + "</ul>\n";
}

std::string cells(const std::vector<std::string>& texts, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& text : texts) row += fmt::format("<{0}>{1}</{0}>", tag, escaped(text));
  return row + "</tr>\n";
}

std::string count_text(const Coverage& part, std::size_t all) {
  return fmt::format("{} of {} ({:g} to {:g})", part.count, all, part.expected.low, part.expected.high);
}

std::string results_table(std::span<const ModelResult> models) {
  std::string text = "<h2>Runouts, observed and predicted from the other runs</h2>\n<table>" +
                     cells({"model", "predicted", "observed, m", "predicted, m", "90 % of the mean",
                            "90 % of the spread", "runs in their 50 %", "runs in their 90 %"},
                           "th");
  for (const ModelResult& model : models) {
    for (const SitePrediction& site : model.sites) {
      text += cells({model.model, site.site, fmt::format("{:.1f} ± {:.1f}", site.observed.mean, site.observed.std_dev),
                     fmt::format("{:.1f} ± {:.1f}", site.predicted.mean, site.predicted.std_dev),
                     fmt::format("{:.1f} to {:.1f}", site.mean_90.low, site.mean_90.high),
                     fmt::format("{:.1f} to {:.1f}", site.std_dev_90.low, site.std_dev_90.high),
                     count_text(site.in_50, site.runs.size()), count_text(site.in_90, site.runs.size())},
                    "td");
    }
  }
  return text +
         "</table>\n<p>Mean ± standard deviation over the runs. The ranges of mean and spread hold 90 % of repetitions "
         "of all runs, each with one set of parameters. In brackets: the number of runs expected in 95 % of cases if "
         "the intervals hold what they claim.</p>\n";
}

std::string scores_table(std::span<const ModelResult> models) {
  std::string text = "<h2>Errors beside those of a constant</h2>\n<table>" +
                     cells({"model", "predicted", "runout: posterior", "prior", "constant", "place: posterior", "prior",
                            "constant", "root mean square error", "constant", "mean error", "constant"},
                           "th");
  const auto m = [](double value) { return fmt::format("{:.1f}", value); };
  for (const ModelResult& model : models) {
    for (const SitePrediction& site : model.sites) {
      text += cells({model.model, site.site, m(site.posterior.runout), m(site.prior.runout), m(site.constant.runout),
                     m(site.posterior.place), m(site.prior.place), m(site.constant.place), m(site.rmse),
                     m(site.rmse_constant), m(site.mae), m(site.mae_constant)},
                    "td");
    }
  }
  return text +
         "</table>\n<p>All in metres; lower is better. Runout: mean continuous ranked probability score. Place: mean "
         "energy score of the stop on plan. Constant: the runouts, or the stops, of the runs that were calibrated on, "
         "as the forecast for every run; for the errors of single runs, their mean or median. Errors of single runs "
         "are those of the mean (root mean square) and of the median (mean magnitude) of what was predicted for each "
         "run from its own release.</p>\n";
}

std::string published_table(const Experiment& experiment) {
  if (experiment.published.empty()) return "";
  std::string text =
      "<h2>Other programs on this experiment</h2>\n<table>" +
      cells({"program", "observed, m", "predicted, m", "difference, m", "mean error of a run, m", "source"}, "th");
  for (const PublishedResult& other : experiment.published) {
    text +=
        cells({other.name, fmt::format("{:.1f}", other.observed_mean_m), fmt::format("{:.1f}", other.predicted_mean_m),
               fmt::format("{:+.1f}", other.predicted_mean_m - other.observed_mean_m),
               other.mean_abs_error_m ? fmt::format("{:.1f}", *other.mean_abs_error_m) : "", other.source},
              "td");
  }
  return text + "</table>\n";
}

std::string group_table(std::span<const GroupRow> groups) {
  if (groups.empty()) return "";
  std::string text =
      "<h2>By group</h2>\n<table>" + cells({"group", "model", "runs", "observed mean runout, m", "predicted, m",
                                            "error of a run, m: root mean square", "of a constant"},
                                           "th");
  for (const GroupRow& row : groups) {
    text += cells(
        {row.group, row.model, fmt::format("{}", row.runs), fmt::format("{:.1f}", row.observed_mean),
         fmt::format("{:.1f}", row.mean), fmt::format("{:.1f}", row.rmse), fmt::format("{:.1f}", row.rmse_constant)},
        "td");
  }
  return text + "</table>\n";
}

/// What was predicted for each run, in the order of the observed runouts.
std::string run_figure(const SitePrediction& site) {
  std::vector<const PredictedRun*> runs;
  for (const PredictedRun& run : site.runs) runs.push_back(&run);
  std::ranges::stable_sort(runs, {}, [](const PredictedRun* run) { return run->observed.runout(); });
  double most = 0, mean = 0;
  for (const PredictedRun* run : runs) most = std::max({most, run->p95, run->observed.runout()});
  for (const ObservedRun& run : site.learned_from) mean += run.runout() / static_cast<double>(site.learned_from.size());
  const auto count = static_cast<double>(runs.size());
  Plot plot(500, 300, {0, count + 1, "run, by observed runout"}, {0, most * 1.05, "runout [m]"});
  plot.line({{0, mean}, {count + 1, mean}}, "other");
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto x = static_cast<double>(k + 1);
    plot.line({{x, runs[k]->p05}, {x, runs[k]->p95}}, "wide");
    plot.line({{x, runs[k]->p25}, {x, runs[k]->p75}}, "narrow");
    plot.dot(x, runs[k]->observed.runout(), 2.5, "observed");
  }
  return figure_of(plot,
                   "Red: observed. Blue: the central 50 % and 90 % predicted for each run from its own release. "
                   "Dashed: the mean of the runs that were calibrated on.");
}

double share_below(const std::vector<double>& ascending, double value) {
  const auto below = std::ranges::upper_bound(ascending, value) - ascending.begin();
  return static_cast<double>(below) / static_cast<double>(ascending.size());
}

/// The distribution of runouts, and 90 % of those of the replicas.
std::string distribution_figure(const SitePrediction& site) {
  std::vector<double> observed;
  for (const PredictedRun& run : site.runs) observed.push_back(run.observed.runout());
  std::ranges::sort(observed);
  const std::size_t replicas = site.runs.front().stops.size();
  double most = observed.back();
  std::vector<std::vector<double>> of_replica(replicas);
  for (std::size_t r = 0; r < replicas; ++r) {
    for (const PredictedRun& run : site.runs) of_replica[r].push_back((run.stops[r] - run.observed.release).norm());
    std::ranges::sort(of_replica[r]);
  }
  for (const PredictedRun& run : site.runs) most = std::max(most, run.p95);
  constexpr int places = 80;
  std::vector<double> grid, low, high;
  std::vector<std::pair<double, double>> middle, steps;
  for (int k = 0; k <= places; ++k) {
    const double at = most * 1.05 * k / places;
    std::vector<double> shares;
    for (const std::vector<double>& runouts : of_replica) shares.push_back(share_below(runouts, at));
    std::ranges::sort(shares);
    const auto q = [&](double part) {
      return shares[static_cast<std::size_t>(part * static_cast<double>(replicas - 1))];
    };
    grid.push_back(at);
    low.push_back(q(0.05));
    high.push_back(q(0.95));
    middle.emplace_back(at, q(0.5));
  }
  for (std::size_t k = 0; k < observed.size(); ++k) {
    const auto n = static_cast<double>(observed.size());
    steps.emplace_back(observed[k], static_cast<double>(k) / n);
    steps.emplace_back(observed[k], static_cast<double>(k + 1) / n);
  }
  Plot plot(500, 300, {0, most * 1.05, "runout [m]"}, {0, 1, "share below"});
  plot.band(grid, low, high, "band");
  plot.line(middle, "median");
  plot.line(steps, "steps");
  return figure_of(plot, "Red: observed. Blue: predicted; 90 % of repetitions of all runs lie within the band.");
}

/// Stops on plan.
std::string map_figure(const SitePrediction& site) {
  Vec2 least = site.runs.front().observed.stop, most = least;
  const auto widen = [&](const Vec2& at) {
    least = least.min(at);
    most = most.max(at);
  };
  std::vector<Vec2> dots;
  const std::size_t replicas = site.runs.front().stops.size(), all = replicas * site.runs.size();
  const std::size_t step = std::max<std::size_t>(all / dots_of_map, 1);
  for (std::size_t k = 0; k < all; k += step)
    dots.push_back(site.runs[k % site.runs.size()].stops[k / site.runs.size()]);
  for (const Vec2& dot : dots) widen(dot);
  for (const PredictedRun& run : site.runs) {
    widen(run.observed.stop);
    widen(run.observed.release);
  }
  constexpr double margin = 5;  // [m]
  least -= Vec2::all(margin);
  most += Vec2::all(margin);
  constexpr int width = 500, borders_x = 68, borders_y = 50;  // those of Plot, so that both axes have one scale
  const double scale = (width - borders_x) / (most.x() - least.x());
  const int height = std::clamp(static_cast<int>((most.y() - least.y()) * scale) + borders_y, 200, 700);
  Plot plot(width, height, {least.x(), most.x(), "x [m]"}, {least.y(), most.y(), "y [m]"});
  for (const Vec2& dot : dots) plot.dot(dot.x(), dot.y(), 2, "predicted");
  for (const PredictedRun& run : site.runs) {
    plot.dot(run.observed.release.x(), run.observed.release.y(), 2, "release");
    plot.dot(run.observed.stop.x(), run.observed.stop.y(), 3, "observed");
  }
  return figure_of(plot, "On plan. Black: releases. Red: observed stops. Blue: predicted stops, some of them.");
}

std::string parameter_table(const SitePrediction& site) {
  std::string text = "<table>" + cells({"parameter", "prior, 90 %", "posterior, 90 %", "median"}, "th");
  for (const FoundParameter& parameter : site.parameters) {
    text +=
        cells({parameter.unit.empty() ? parameter.name : fmt::format("{} [{}]", parameter.name, parameter.unit),
               fmt::format("{:.4g} to {:.4g}", parameter.prior_p05, parameter.prior_p95),
               fmt::format("{:.4g} to {:.4g}", parameter.p05, parameter.p95), fmt::format("{:.4g}", parameter.median)},
              "td");
  }
  return text + "</table>\n";
}

std::string short_text(Problem problem) {
  problem.file = std::filesystem::path(problem.file).filename().string();
  return problem.text();
}

}  // namespace

std::string page_of(const Experiment& experiment, std::span<const ModelResult> models) {
  const std::string title = escaped(experiment.title);
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>"
      "<body>\n<h1>Validation: {0}</h1>\n<p>{2}</p>\n",
      title, style, escaped(experiment.summary));
  for (const std::string& limit : experiment.limits) text += fmt::format("<p class=\"limit\">{}</p>\n", escaped(limit));
  text +=
      results_table(models) + scores_table(models) + group_table(group_rows_of(models)) + published_table(experiment);
  for (const ModelResult& model : models) {
    text += fmt::format("<h2>{}</h2>\n", escaped(model.model));
    for (const SitePrediction& site : model.sites) {
      text += fmt::format("<h3>{}, from {}</h3>\n", escaped(site.site), escaped(site.from));
      text += run_figure(site) + distribution_figure(site) + map_figure(site);
      text += parameter_table(site);
      for (const Problem& warning : site.warnings.list())
        text += fmt::format("<p class=\"warning\">{}</p>\n", escaped(short_text(warning)));
    }
  }
  text += "<h2>How it was done</h2>\n<p>" + escaped(experiment.split) + "</p>\n<p>Sought:</p>\n" +
          list_of(experiment.sought) + "<p>Not sought:</p>\n" + list_of(experiment.not_sought) + "<h2>Data</h2>\n" +
          list_of(experiment.citations) + "<p>Licence: " + escaped(experiment.licence) + "</p>\n";
  return text + "</body></html>\n";
}

}  // namespace talus::validation
