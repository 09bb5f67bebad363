#include "talus/sensitivity/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "talus/project/document.hpp"

namespace talus::sensitivity {

namespace {

/// The rules across several keys, and words.
class SensitivityCheck {
 public:
  SensitivityCheck(Study& study, study::StudyProblems& problems) : study_(study), problems_(problems) {}

  void check() {
    check_method();
    const auto rows = static_cast<std::uint64_t>(std::max<std::int64_t>(study_.rows, 1));
    if (study_.method == Method::sobol && !std::has_single_bit(rows) && !problems_.is_refused("", 0, "rows")) {
      problems_.refuse("", 0, "rows", fmt::format("rows is {}", rows),
                       "points of a Sobol sequence are even in powers of two",
                       fmt::format("Use {} or {}", std::bit_floor(rows), std::bit_ceil(rows)));
    }
    for (std::size_t k = 0; k < study_.results.size(); ++k) check_result(k);
    problems_.check_names("result", study_.results);
  }

 private:
  void check_method() {
    for (const Method method : {Method::morris, Method::sobol}) {
      if (study_.method_word != name(method)) continue;
      study_.method = method;
      return;
    }
    if (!problems_.is_refused("", 0, "method")) {
      problems_.refuse_word("", 0, "method", study_.method_word, {name(Method::morris), name(Method::sobol)});
    }
  }

  void check_result(std::size_t k) {
    constexpr const char* table = "result";
    StudyResult& each = study_.results[k];
    for (const std::string& site : each.sites) problems_.check_site_name(table, k, "sites", site, study_);
    const auto found = std::ranges::find(figure_quantities, each.quantity, &FigureQuantity::word);
    if (found == figure_quantities.end()) {
      std::vector<std::string_view> known;
      for (const FigureQuantity& quantity : figure_quantities) known.push_back(quantity.word);
      if (!each.quantity.empty() && !problems_.is_refused(table, k, "quantity"))
        problems_.refuse_word(table, k, "quantity", each.quantity, known);
      return;
    }
    each.of = found->of;
    if (found->is_at_line && each.at.empty() && !problems_.is_refused(table, k, "at")) {
      problems_.refuse(table, k, "quantity", "at is missing", fmt::format("{} is that at a line", each.quantity),
                       "Name a collector or barrier of the project");
    }
    if (!found->is_at_line && !each.at.empty()) {
      problems_.refuse(table, k, "at", fmt::format("at is given with {}", each.quantity),
                       "it is a quantity of the whole path", "Leave it out");
    }
    if (each.name.empty()) {
      const RunFigure figure{each.of, each.percentile, 0};
      each.name = figure.text() + (each.at.empty() ? "" : fmt::format(": {}", each.at));
    }
  }

  Study& study_;
  study::StudyProblems& problems_;
};

}  // namespace

std::string_view name(Method method) { return method == Method::morris ? "morris" : "sobol"; }

StudyReading read_study_text(std::string_view text, const std::filesystem::path& file) {
  StudyReading reading;
  Study& study = reading.study;
  const auto row = [&](std::string_view table, int line) -> project::Row {
    if (table == "result") return study::added_row(study.results, line);
    return &study;
  };
  const auto check = [&](study::StudyProblems& problems) { SensitivityCheck(study, problems).check(); };
  reading.warnings = study::read_study_text(text, file, study, {study_tables(), row, check});
  return reading;
}

StudyReading read_study(const std::filesystem::path& file) {
  return read_study_text(project::text_of_file(file, "study"), file);
}

}  // namespace talus::sensitivity
