#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/best_set.hpp"
#include "talus/calibration/coverage.hpp"
#include "talus/calibration/doubts.hpp"
#include "talus/calibration/mixture.hpp"
#include "talus/calibration/result_figures.hpp"
#include "talus/calibration/result_files.hpp"
#include "talus/calibration/svg.hpp"
#include "talus/calibration/zone_prediction.hpp"
#include "talus/project/values.hpp"
#include "talus/statistics/without_rounding.hpp"

namespace talus::calibration {

namespace {

using project::counted;

constexpr const char* page_style =
    "body{font:15px/1.5 system-ui,sans-serif;color:#222;max-width:1080px;margin:24px auto;padding:0 16px}"
    "h1{font-size:24px}h2{font-size:19px;margin-top:32px}table{border-collapse:collapse;margin:8px 0}"
    "td,th{padding:3px 10px;text-align:right;border-bottom:1px solid #ddd}"
    "td:first-child,th:first-child{text-align:left}figure{display:inline-block;margin:6px 10px 6px 0}"
    "figcaption{font-size:13px;color:#444;max-width:340px}svg text{font-size:11px;fill:#444}.grid{stroke:#e6e6e6}"
    ".prior{fill:#bbb}.posterior{fill:#1f6fb4;fill-opacity:.6}.best{stroke:#c03;stroke-width:1.5}"
    ".band{fill:#1f6fb4;fill-opacity:.2}.wide{fill:#999;fill-opacity:.2}"
    ".median{fill:none;stroke:#1f6fb4;stroke-width:1.5}.observed{fill:none;stroke:#c03;stroke-width:1.8}"
    ".set{fill:#1f6fb4;fill-opacity:.35}.warning{background:#fff4d6;border-left:4px solid #e0a800;padding:4px 10px;"
    "margin:4px 0}";

constexpr std::size_t most_in_pairs = 6;  // parameters

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string figure(const Plot& plot, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", plot.text(), escaped(caption));
}

class Page {
 public:
  Page(const PreparedStudy& study, const CalibrationResult& result) : study_(study), result_(result) {
    for (const SetResult& set : result.sets) weights_.push_back(set.weight);
  }

  std::string text() {
    const std::string title = escaped(study_.study().name);
    out_ = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>"
        "<body>\n<h1>Calibration: {0}</h1>\n",
        title, page_style);
    introduction();
    for (const Problem& warning : result_.warnings.list())
      out_ += fmt::format("<p class=\"warning\">{}</p>\n", escaped(short_text(warning)));
    if (result_.effective_sets > 0) {
      parameters();
      pairs();
      predictions();
    }
    held_out();
    return out_ + "</body></html>\n";
  }

 private:
  static std::string short_text(Problem problem) {
    problem.file.clear();
    problem.line = 0;
    return problem.text();
  }

  void introduction() {
    std::size_t observations = 0;
    for (const ObservedGroup& group : study_.groups()) observations += group.count();
    const auto agreeing = std::ranges::count_if(result_.sets, [](const SetResult& set) { return agrees(set); });
    out_ += fmt::format(
        "<p>{}, {} at {}, {} of {}. {} as near to the observations as chance alone gives. The posterior is as accurate "
        "as {}.</p>\n",
        counted(study_.parameters().size(), "parameter", "parameters"),
        counted(observations, "observation", "observations"), counted(study_.sites().size(), "site", "sites"),
        counted(result_.sets.size(), "set", "sets"),
        counted(static_cast<std::size_t>(study_.study().rocks), "rock", "rocks"),
        counted(static_cast<std::size_t>(agreeing), "set is", "sets are"),
        counted(static_cast<std::size_t>(std::lround(result_.effective_sets)), "independent set", "independent sets"));
  }

  [[nodiscard]] std::vector<double> values_of(std::size_t parameter) const {
    std::vector<double> values;
    for (const SetResult& set : result_.sets) values.push_back(set.values[parameter]);
    return values;
  }

  void parameters() {
    out_ +=
        "<h2>What is known of each parameter</h2>\n<table><tr><th>parameter</th><th>prior, 90 %</th><th>posterior, 90 "
        "%</th><th>median</th><th>best set</th><th>width, posterior / prior</th><th></th></tr>\n";
    for (std::size_t k = 0; k < study_.parameters().size(); ++k) {
      const study::Parameter& parameter = study_.parameters()[k];
      const std::vector<double> values = values_of(k);
      const Learned learned = learned_about(k, study_, result_);
      const auto q = [&](double share) { return weighted_quantile(values, weights_, share); };
      out_ += fmt::format(
          "<tr><td>{}</td><td>{:.4g} to {:.4g}</td><td>{:.4g} to "
          "{:.4g}</td><td>{:.4g}</td><td>{:.4g}</td><td>{:.2f}</td>"
          "<td>{}</td></tr>\n",
          escaped(with_unit(parameter.name, parameter.unit)), parameter.prior.value(0.05), parameter.prior.value(0.95),
          q(0.05), q(0.95), q(0.5), result_.sets[result_.best].values[k], learned.width,
          learned.is_nothing() ? "the data say nothing about this one" : "");
    }
    out_ += "</table>\n";
    if (const std::string why = why_best_is_outside(study_, result_); !why.empty())
      out_ += fmt::format("<p>{}.</p>\n", escaped(why));
    for (std::size_t k = 0; k < study_.parameters().size(); ++k) histogram(k);
  }

  void histogram(std::size_t k) {
    const study::Parameter& parameter = study_.parameters()[k];
    const ParameterHistogram bins = histogram_of(k, study_, result_);
    const double highest = std::max(*std::ranges::max_element(bins.posterior), *std::ranges::max_element(bins.prior));
    Plot plot(330, 210, {bins.edges.front(), bins.edges.back(), with_unit(parameter.name, parameter.unit)},
              {0, highest * 1.05, "share"});
    for (std::size_t b = 0; b + 1 < bins.edges.size(); ++b) {
      plot.bar(bins.edges[b], bins.edges[b + 1], bins.prior[b], "prior");
      plot.bar(bins.edges[b], bins.edges[b + 1], bins.posterior[b], "posterior");
    }
    plot.vertical(result_.sets[result_.best].values[k], "best");
    out_ += figure(plot, "Grey: prior. Blue: posterior. Red: best set.");
  }

  void pairs() {
    const std::size_t count = study_.parameters().size();
    if (count < 2) return;
    out_ += "<h2>Correlations in the posterior</h2>\n<table><tr><th></th>";
    for (std::size_t k = 0; k < count; ++k) out_ += fmt::format("<th>{}</th>", k + 1);
    out_ += "</tr>\n";
    for (std::size_t a = 0; a < count; ++a) {
      out_ += fmt::format("<tr><td>{} {}</td>", a + 1, escaped(study_.parameters()[a].name));
      for (std::size_t b = 0; b < count; ++b)
        out_ += b < a ? fmt::format("<td>{:.2f}</td>", correlation_of(a, b, result_)) : "<td></td>";
      out_ += "</tr>\n";
    }
    out_ += "</table>\n";
    const double heaviest = *std::ranges::max_element(weights_);
    for (std::size_t a = 0; a < std::min(count, most_in_pairs); ++a) {
      for (std::size_t b = a + 1; b < std::min(count, most_in_pairs); ++b) {
        const project::Prior &x = study_.parameters()[a].prior, &y = study_.parameters()[b].prior;
        Plot plot(330, 250, {x.value(0.001), x.value(0.999), study_.parameters()[a].name},
                  {y.value(0.001), y.value(0.999), study_.parameters()[b].name});
        for (const SetResult& set : result_.sets) {
          constexpr double faint = 1e-3;
          if (set.weight < faint * heaviest) continue;
          plot.dot(set.values[a], set.values[b], 5 * std::sqrt(set.weight / heaviest), "set");
        }
        out_ += figure(plot, "The area of a dot is the weight of its set.");
      }
    }
  }

  void predictions() {
    out_ +=
        "<h2>Observed and predicted distributions</h2>\n<p>Red: observed. Blue: the posterior's prediction; 90 % of "
        "as many rocks as were observed would lie within the band. Grey: the same of the prior.</p>\n";
    std::vector<double> prior(result_.sets.size(), 0);
    for (std::size_t k = 0; k < prior.size(); ++k) prior[k] = result_.sets[k].round == 0 ? 1 : 0;
    for (std::size_t g = 0; g < study_.groups().size(); ++g) {
      if (study_.groups()[g].kind == ObservationKind::zones) {
        out_ += zones_as_html(study_, g, result_, weights_, prior);
      }
      for (std::size_t f = 0; f < study_.groups()[g].features.size(); ++f) {
        distribution(g, static_cast<Eigen::Index>(f));
      }
    }
  }

  void distribution(std::size_t g, Eigen::Index f) {
    const ObservedGroup& group = study_.groups()[g];
    const Eigen::MatrixXd predicted = mixture_of(result_.sets, weights_, g, rows_like(group.sample, 1000)).rows;
    if (predicted.rows() == 0) return;
    const auto [observed, grid, wide, bands] = prediction_of(g, static_cast<std::size_t>(f), study_, result_);
    const Feature& feature = group.features[static_cast<std::size_t>(f)];
    Plot plot(480, 270, {grid.front(), grid.back(), with_unit(feature.name, feature.unit)}, {0, 1, "share below"});
    plot.band(grid, wide.low, wide.high, "wide");
    plot.band(grid, bands.low, bands.high, "band");
    std::vector<std::pair<double, double>> middle, steps;
    for (std::size_t k = 0; k < grid.size(); ++k) middle.emplace_back(grid[k], bands.middle[k]);
    plot.line(middle, "median");
    const auto n = static_cast<double>(observed.size());
    for (std::size_t k = 0; k < observed.size(); ++k) {
      steps.emplace_back(observed[k], static_cast<double>(k) / n);
      steps.emplace_back(observed[k], static_cast<double>(k + 1) / n);
    }
    plot.line(steps, "observed");
    const auto mean = predicted.col(f).mean();
    const double spread = std::sqrt((predicted.col(f).array() - mean).square().mean());
    const double observed_mean = group.sample.rows.col(f).mean();
    const double observed_spread =
        std::sqrt((group.sample.rows.col(f).array() - observed_mean).square().sum() / std::max(n - 1, 1.0));
    out_ +=
        figure(plot, fmt::format("{}, {}: observed {:.4g} \u00b1 {:.3g} {}, predicted {:.4g} \u00b1 {:.3g} {} (mean "
                                 "and standard deviation). {} of the best set {:.3g}; chance alone gives up to "
                                 "{:.3g}.",
                                 study_.study().sites[group.site].name, group.name,
                                 without_rounding(observed_mean, observed_spread), observed_spread, feature.unit,
                                 without_rounding(mean, spread), spread, feature.unit,
                                 group.sample.has_strata() ? "Mean energy score" : "Energy distance",
                                 result_.sets[result_.best].distances[g], result_.thresholds[g]));
  }

  void held_out() {
    if (result_.held_out.empty()) return;
    out_ +=
        "<h2>Predictions of observations that were held out</h2>\n<p>Mean energy score (CRPS on a line) over the "
        "observed spread; lower is better. Constant: the distribution of the other observations.</p>\n<table><tr>"
        "<th>held out</th><th>observations</th><th>posterior</th><th>prior</th><th>constant</th></tr>\n";
    double posterior = 0, prior = 0, constant = 0, count = 0;
    bool has_constant = true;
    const auto row = [&](const std::string& name, double n, double a, double b, bool has, double c) {
      out_ += fmt::format("<tr><td>{}</td><td>{:g}</td><td>{:.3f}</td><td>{:.3f}</td><td>{}</td></tr>\n", escaped(name),
                          n, a, b, has ? fmt::format("{:.3f}", c) : "");
    };
    for (const HeldOut& held : result_.held_out) {
      const auto n = static_cast<double>(held.observations);
      row(held.name, n, held.posterior, held.prior, held.constant.has_value(), held.constant.value_or(0));
      posterior += n * held.posterior;
      prior += n * held.prior;
      constant += n * held.constant.value_or(0);
      has_constant = has_constant && held.constant.has_value();
      count += n;
    }
    row("all", count, posterior / count, prior / count, has_constant, constant / count);
    out_ += "</table>\n";
    coverage();
    if (study_.study().hold_out_sites) held_out_features();
  }

  void coverage() {
    out_ +=
        "<p>How many lie within the central 90 % of their prediction, and the number expected in 95 % of cases if "
        "predictions hold what they claim and observations are independent.</p>\n<table><tr><th>held out</th><th></th>"
        "<th>observations</th><th>within 90 %</th><th>expected</th></tr>\n";
    for (const HeldOutCoverage& each : coverage_of(result_.held_out)) {
      out_ += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{} to {}</td></tr>\n",
                          escaped(each.group), escaped(with_unit(each.feature.name, each.feature.unit)),
                          each.observations, each.within_90, each.min_expected, each.max_expected);
    }
    out_ += "</table>\n";
  }

  void held_out_features() {
    out_ += "<table><tr><th>held out</th><th></th><th>observed</th><th>predicted from the other sites</th></tr>\n";
    for (const HeldOut& held : result_.held_out) {
      for (const PredictedFeature& each : held.features) {
        out_ +=
            fmt::format("<tr><td>{}</td><td>{}</td><td>{:.4g} \u00b1 {:.3g}</td><td>{:.4g} \u00b1 {:.3g}</td></tr>\n",
                        escaped(each.group), escaped(with_unit(each.feature.name, each.feature.unit)),
                        without_rounding(each.observed.mean, each.observed.std_dev), each.observed.std_dev,
                        without_rounding(each.predicted.mean, each.predicted.std_dev), each.predicted.std_dev);
      }
    }
    out_ += "</table>\n";
  }

  const PreparedStudy& study_;
  const CalibrationResult& result_;
  std::vector<double> weights_;
  std::string out_;
};

}  // namespace

std::string report_of(const PreparedStudy& study, const CalibrationResult& result) {
  return Page(study, result).text();
}

}  // namespace talus::calibration
