#pragma once
// The folder of a finished sensitivity study: sensitivity.csv, runs.csv, summary.json and report.html; in
// `sets`, finished runs.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>

#include "talus/files/csv_table.hpp"
#include "talus/sensitivity/analysis.hpp"

namespace talus::sensitivity {

/// A row of sensitivity.csv: an input's effect on a result. Cells of the other method are empty.
struct EffectRow {
  static constexpr const char* file_name = "sensitivity.csv";

  std::string site{}, result{}, unit{}, input{}, values{};
  std::optional<double> effect{}, effect_low{}, effect_high{}, mean_effect{}, spread{};
  std::optional<double> total{}, total_low{}, total_high{}, first{}, first_low{}, first_high{};

  static constexpr auto columns() {
    using R = EffectRow;
    return std::tuple(
        word("site", "name of the site", &R::site), word("result", "name of the result", &R::result),
        word("unit", "its unit", &R::unit),
        word("input", "path of the parameter, with `@SITE` if each site has its own; `(seed)`: which rocks are drawn",
             &R::input),
        word("values", "its range or distribution", &R::values),
        quantity("effect", "",
                 "`morris`: mean magnitude of the elementary effects, mu*, in units of the result over "
                 "the whole range of the input",
                 &R::effect),
        quantity("effect_low", "", "lower end of its confidence interval", &R::effect_low),
        quantity("effect_high", "", "upper end of its confidence interval", &R::effect_high),
        quantity("mean_effect", "", "`morris`: mean of the effects with their signs, mu", &R::mean_effect),
        quantity("spread", "", "`morris`: standard deviation of the effects, sigma", &R::spread),
        quantity("total", "", "`sobol`: total index", &R::total),
        quantity("total_low", "", "lower end of its confidence interval", &R::total_low),
        quantity("total_high", "", "upper end of its confidence interval", &R::total_high),
        quantity("first", "", "`sobol`: first-order index", &R::first),
        quantity("first_low", "", "lower end of its confidence interval", &R::first_low),
        quantity("first_high", "", "upper end of its confidence interval", &R::first_high));
  }
};

/// A row of runs.csv.
struct RunRow {
  static constexpr const char* file_name = "runs.csv";

  std::uint64_t run = 0;
  FamilyValues values{};

  static constexpr auto columns() {
    return std::tuple(key("run", "number of the run, from 0", &RunRow::run), family(&RunRow::values));
  }
  [[nodiscard]] static std::vector<ColumnText> family_texts();
};

/// The folder of results where none is given: named after the study, next to its file.
[[nodiscard]] std::filesystem::path usual_folder(const Study& study);

/// Analyses into a folder. Runs that an earlier analysis of the same study made there are not made again; those of
/// another study are removed. After a stop (Stopped is thrown) finished runs are kept. Throws BadInput if the folder
/// cannot be written to, or another program writes to it. Of the options, `known` and `finished` are set here.
[[nodiscard]] Analysis analyse_into(const std::filesystem::path& folder, const Study& study,
                                    const PreparedStudy& prepared, AnalysisOptions options);

/// Writes all files but the finished runs, each complete under its name.
void write_results(const std::filesystem::path& folder, const Study& study, const Analysis& analysis);

}  // namespace talus::sensitivity
