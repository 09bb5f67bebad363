#include "talus/sensitivity/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <unordered_set>

#include "talus/core/nearest.hpp"
#include "talus/core/utf8.hpp"
#include "talus/project/document.hpp"
#include "talus/project/read_table.hpp"
#include "talus/project/values.hpp"

namespace talus::sensitivity {

namespace {

using project::Document;
using project::Row;
using project::RowElsewhere;

/// The row to read the next table into.
Row row_to_read(Study& study, std::string_view table, int line) {
  const auto with_line = [line](auto& list) {
    list.emplace_back().line = line;
    return Row(RowElsewhere(&list.back()));
  };
  if (table == "parameter") return with_line(study.inputs);
  if (table == "result") return with_line(study.results);
  return RowElsewhere(&study);
}

/// The rules across several keys, and words.
class SensitivityCheck {
 public:
  SensitivityCheck(Study& study, const Document& document, const std::unordered_set<const toml::node*>& refused,
                   Problems& problems)
      : study_(study), document_(document), refused_(refused), problems_(problems) {}

  void check() {
    check_method();
    const auto rows = static_cast<std::uint64_t>(std::max<std::int64_t>(study_.rows, 1));
    if (study_.method == Method::sobol && !std::has_single_bit(rows) && !is_refused("", 0, "rows")) {
      refuse("", 0, "rows", fmt::format("rows is {}", rows), "points of a Sobol sequence are even in powers of two",
             fmt::format("Use {} or {}", std::bit_floor(rows), std::bit_ceil(rows)));
    }
    for (std::size_t k = 0; k < study_.inputs.size(); ++k) check_input(k);
    for (std::size_t k = 0; k < study_.results.size(); ++k) check_result(k);
  }

 private:
  const toml::table* row(std::string_view table, std::size_t index) const {
    if (table.empty()) return &document_.root();
    const toml::array* list = document_.root()[table].as_array();
    return list != nullptr && index < list->size() ? list->get(index)->as_table() : nullptr;
  }
  bool is_refused(std::string_view table, std::size_t index, std::string_view key) const {
    const toml::table* from = row(table, index);
    return from != nullptr && from->contains(key) && refused_.contains(from->get(key));
  }
  void refuse(std::string_view table, std::size_t index, std::string_view key, std::string what, std::string why,
              std::string hint) {
    const toml::table* from = row(table, index);
    const toml::node* node = from != nullptr && !key.empty() ? from->get(key) : nullptr;
    Problem problem = node != nullptr   ? document_.at(*node)
                      : from != nullptr ? document_.at(*from)
                                        : document_.nowhere(table);
    if (!table.empty()) problem.where = fmt::format("[[{}]] {}", table, index + 1);
    problem.what = std::move(what);
    problem.why = std::move(why);
    problem.hint = std::move(hint);
    problems_.add(std::move(problem));
  }
  void refuse_word(std::string_view table, std::size_t index, std::string_view key, const std::string& word,
                   const std::vector<std::string_view>& known) {
    const auto near = nearest(word, known);
    refuse(table, index, key, fmt::format("{} is \"{}\"", key, word),
           fmt::format("expected {}", fmt::join(known, ", ")), near ? fmt::format("Did you mean \"{}\"?", *near) : "");
  }

  void check_method() {
    for (const Method method : {Method::morris, Method::sobol}) {
      if (study_.method_word != name(method)) continue;
      study_.method = method;
      return;
    }
    if (!is_refused("", 0, "method")) {
      refuse_word("", 0, "method", study_.method_word, {name(Method::morris), name(Method::sobol)});
    }
  }

  void check_input(std::size_t k) {
    constexpr const char* table = "parameter";
    const StudyInput& each = study_.inputs[k];
    const bool was_refused = is_refused(table, k, "range") || is_refused(table, k, "prior");
    if (each.range.empty() && !each.prior && !was_refused) {
      refuse(table, k, "", "range or prior is missing", "an input varies within a distribution",
             "Write range = [least, greatest]");
    }
    if (!each.range.empty() && each.range.size() != 2) {
      refuse(table, k, "range", fmt::format("range has {} numbers", each.range.size()), "expected [least, greatest]",
             "");
    } else if (each.range.size() == 2 && !(each.range[0] < each.range[1])) {
      refuse(table, k, "range", fmt::format("range is [{:g}, {:g}]", each.range[0], each.range[1]),
             "expected [least, greatest]", each.range[0] > each.range[1] ? "Exchange the two" : "");
    }
    if (each.prior && each.prior->kind == DistributionKind::none) {
      refuse(table, k, "prior", "prior is a single value", "it would not vary",
             "Add distribution = \"normal\" and std_dev, or write range = [least, greatest]");
    }
    for (std::size_t other = 0; other < k; ++other) {
      if (each.path.empty() || each.path != study_.inputs[other].path) continue;
      refuse(table, k, "path", fmt::format("path \"{}\" is given twice", each.path), "an input varies once", "");
    }
  }

  void check_result(std::size_t k) {
    constexpr const char* table = "result";
    StudyResult& each = study_.results[k];
    const auto found = std::ranges::find(figure_quantities, each.quantity, &FigureQuantity::word);
    if (found == figure_quantities.end()) {
      std::vector<std::string_view> known;
      for (const FigureQuantity& quantity : figure_quantities) known.push_back(quantity.word);
      if (!each.quantity.empty() && !is_refused(table, k, "quantity"))
        refuse_word(table, k, "quantity", each.quantity, known);
      return;
    }
    each.of = found->of;
    if (found->is_at_line && each.at.empty() && !is_refused(table, k, "at")) {
      refuse(table, k, "quantity", "at is missing", fmt::format("{} is that at a line", each.quantity),
             "Name a collector or barrier of the project");
    }
    if (!found->is_at_line && !each.at.empty()) {
      refuse(table, k, "at", fmt::format("at is given with {}", each.quantity), "it is a quantity of the whole path",
             "Leave it out");
    }
    if (each.name.empty()) {
      const RunFigure figure{each.of, each.percentile, 0};
      each.name = figure.text() + (each.at.empty() ? "" : fmt::format(": {}", each.at));
    }
    if (!names_.emplace(each.name, k).second) {
      refuse(table, k, "name", fmt::format("\"{}\" is given twice", each.name), "results must differ", "");
    }
  }

  Study& study_;
  const Document& document_;
  const std::unordered_set<const toml::node*>& refused_;
  Problems& problems_;
  std::map<std::string, std::size_t> names_;
};

}  // namespace

std::string_view name(Method method) { return method == Method::morris ? "morris" : "sobol"; }

std::uint64_t Study::runs() const {
  const std::uint64_t k = inputs.size() + 1;  // and the seed
  return method == Method::morris ? static_cast<std::uint64_t>(trajectories) * (k + 1)
                                  : static_cast<std::uint64_t>(rows) * (k + 2);
}

Study read_study_text(std::string_view text, const std::filesystem::path& file) {
  Problems problems;
  const Document document(text, file.string());
  Study study;
  study.file = file;
  project::ValueReader reader(document, problems, study_tables());
  for (const project::Table& table : study_tables()) {
    project::read_table(
        table, document, reader, [&](int line) { return row_to_read(study, table.key, line); }, "a study", problems);
  }
  if (study.name.empty()) study.name = as_utf8(file.stem().string());
  SensitivityCheck(study, document, reader.refused(), problems).check();
  problems = problems.in_order_of(document.file());
  if (!problems.list().empty()) throw BadInput(std::move(problems));
  return study;
}

Study read_study(const std::filesystem::path& file) { return read_study_text(project::text_of_file(file), file); }

}  // namespace talus::sensitivity
