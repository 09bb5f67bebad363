#include "talus/verification/case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/verification/fields.hpp"

namespace talus::verification {
namespace {

using project::Document;

std::vector<std::string_view> statistic_names() {
  std::vector<std::string_view> names;
  for (int k = 0; k < statistic_count; ++k) names.push_back(name(static_cast<Statistic>(k)));
  return names;
}

std::optional<EndReason> end_reason_of(std::string_view text) {
  for (int k = 0; k < end_reason_count; ++k) {
    if (text == name(static_cast<EndReason>(k))) return static_cast<EndReason>(k);
  }
  return std::nullopt;
}

std::vector<std::string_view> end_reason_names() {
  std::vector<std::string_view> names;
  for (int k = 0; k < end_reason_count; ++k) names.emplace_back(name(static_cast<EndReason>(k)));
  return names;
}

SampleQuantity sample_in(Fields& fields) {
  const std::string word = fields.text("sample");
  const toml::node* node = fields.from().get("sample");
  if (!node || word.empty()) return {};
  return fields.one_of(word, "sample", sample_quantity_of, sample_quantity_names(), *node).value_or(SampleQuantity{});
}

std::vector<Statistic> statistics_in(Fields& fields, std::string_view key) {
  std::vector<Statistic> list;
  for (const std::string& word : fields.texts(key, true)) {
    if (const auto s = fields.one_of(word, key, statistic_of, statistic_names(), *fields.from().get(key))) {
      list.push_back(*s);
    }
  }
  return list;
}

void check_column(Fields& fields, const PublishedTable& published, std::string_view column, const toml::node& node) {
  if (published.column(column)) return;
  const std::vector<std::string_view> known(published.columns().begin(), published.columns().end());
  fields.report(node, fmt::format("{} has no column {}", published.file(), column),
                fmt::format("its columns are {}", fmt::join(known, ", ")), suggestion(column, known));
}

class CaseReader {
 public:
  CaseReader(const Files& files, const std::string& case_name)
      : files_(files), name_(case_name), document_(text_of("case.toml"), path_of("case.toml")) {}

  Case read() {
    Case result;
    result.name = name_;
    Fields fields(document_, document_.root(), "", problems_);
    result.title = fields.text("title");
    result.source = fields.text("source");
    result.about = fields.text("about");
    result.notes = fields.texts("notes", false);
    fields.tables("run", true, [&](const toml::table& from) { result.runs.push_back(read_run(from)); });
    for (const Run& run : result.runs) {
      runs_.push_back(run.name);
      rocks_.push_back(run.rocks.value_or(0));
    }
    fields.tables("table", true, [&](const toml::table& from) {
      if (auto table = read_table(from)) result.tables.push_back(std::move(*table));
    });
    fields.finish();
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
    return result;
  }

 private:
  [[nodiscard]] std::string path_of(std::string_view file) const { return fmt::format("{}/{}", name_, file); }
  [[nodiscard]] const std::string& text_of(std::string_view file) const {
    const auto found = files_.find(path_of(file));
    if (found == files_.end()) {
      throw BadInput(Problem{.file = path_of(file),
                             .where = {},
                             .what = "there is no such file",
                             .why = "the folder of the case needs it",
                             .hint = {}});
    }
    return found->second;
  }

  Run read_run(const toml::table& from) {
    Fields fields(document_, from, "run", problems_);
    Run run;
    run.name = fields.text("name");
    run.project = fields.text("project");
    run.settings = fields.texts("set", false);
    run.rocks = fields.whole_number("rocks", 1);
    if (!run.project.empty() && !files_.contains(path_of(run.project))) {
      fields.report(*from.get("project"), fmt::format("there is no file {}", run.project),
                    "it must be next to case.toml");
    }
    fields.finish();
    return run;
  }

  void check_run(Fields& fields, const std::string& run, const toml::node& node) {
    if (std::ranges::find(runs_, run) != runs_.end()) return;
    const std::vector<std::string_view> known(runs_.begin(), runs_.end());
    fields.report(node, fmt::format("there is no run \"{}\"", run),
                  fmt::format("the runs are {}", fmt::join(known, ", ")), suggestion(run, known));
  }

  void check_rocks(Fields& fields, const std::vector<std::string>& runs) {
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (rocks_[k] >= fewest_rocks_of_a_spread || std::ranges::find(runs, runs_[k]) == runs.end()) continue;
      fields.report(fields.from(), fmt::format("run \"{}\" has {} rocks", runs_[k], rocks_[k]),
                    "the spread of samples needs many more rocks than the samples have",
                    fmt::format("Give the run rocks = {} or more", fewest_rocks_of_a_spread));
    }
  }

  std::optional<Table> read_table(const toml::table& from) {
    Fields fields(document_, from, "table", problems_);
    Table table{fields.text("title"), fields.text("source"), {}, fields.text("why"), ValuesTable{}};
    const std::string kind = fields.text("kind");
    constexpr std::array<std::string_view, 6> kinds{"path", "statistics", "values", "count", "agreement", "soundness"};
    if (std::ranges::find(kinds, kind) == kinds.end()) {
      if (const toml::node* node = from.get("kind")) {
        fields.report(*node, fmt::format("kind is \"{}\"", kind),
                      fmt::format("expected one of {}", fmt::join(kinds, ", ")), suggestion(kind, kinds));
      }
      return std::nullopt;
    }
    if (kind != "values") {
      table.runs = fields.texts("runs", true);
      if (const toml::node* node = from.get("runs")) {
        for (const std::string& run : table.runs) check_run(fields, run, *node);
      }
    }
    if (kind == "statistics" || kind == "count") check_rocks(fields, table.runs);
    if (kind == "values") table.kind = read_values(fields);
    if (kind == "count") table.kind = read_count(fields);
    if (kind == "agreement") table.kind = read_agreement(fields);
    if (kind == "soundness") table.kind = read_soundness(fields);
    if (kind == "path" || kind == "statistics") {
      const std::string file = fields.text("published");
      if (file.empty()) return std::nullopt;
      PublishedTable published(text_of(file), path_of(file));
      table.kind = kind == "path" ? TableKind(read_path(fields, std::move(published)))
                                  : TableKind(read_statistics(fields, std::move(published)));
    }
    fields.finish();
    return table;
  }

  Tolerance read_tolerance(const toml::table& from) {
    Fields fields(document_, from, "tolerance", problems_);
    Tolerance tolerance;
    tolerance.units = fields.number("units").value_or(0);
    tolerance.relative = fields.number("relative").value_or(0);
    tolerance.absolute = fields.number("absolute").value_or(0);
    tolerance.of_scale = fields.number("of_scale").value_or(0);
    fields.finish();
    return tolerance;
  }
  std::optional<Tolerance> tolerance_in(Fields& fields) {
    const toml::node* node = fields.find("tolerance");
    if (!node) return std::nullopt;
    if (const toml::table* from = node->as_table()) return read_tolerance(*from);
    fields.report(*node, fmt::format("tolerance is {}", project::quoted(*node)),
                  "expected a table, for example { units = 1, relative = 0.001 }");
    return std::nullopt;
  }

  PathTable read_path(Fields& fields, PublishedTable published) {
    PathTable table{std::move(published), {}, {}, {}, tolerance_in(fields).value_or(Tolerance{}), {}};
    const toml::node* node = fields.need("columns");
    if (const toml::table* columns = node ? node->as_table() : nullptr) {
      for (const auto& [key, value] : *columns) check_column(fields, table.published, key.str(), value);
      for (const std::string& column : table.published.columns()) {  // in the order of the published table
        const toml::node* value = columns->get(column);
        if (!value) continue;
        const std::string word = value->value_or(std::string());
        if (const auto q = fields.one_of(word, column, path_quantity_of, path_quantity_names(), *value)) {
          table.columns.emplace_back(column, *q);
        }
      }
    } else if (node) {
      fields.report(*node, fmt::format("columns is {}", project::quoted(*node)),
                    "expected a table of the published table's columns and what they are");
    }
    if (fields.from().contains("times")) {
      read_times(fields, table);
    } else {
      read_events(fields, table);
    }
    fields.tables("exception", false,
                  [&](const toml::table& from) { table.exceptions.push_back(read_exception(from, table.published)); });
    return table;
  }

  void read_times(Fields& fields, PathTable& table) {
    const std::string column = fields.text("times");
    const toml::node& node = *fields.from().get("times");
    check_column(fields, table.published, column, node);
    table.times = table.published.column(column);
    for (std::size_t row = 0; table.times && row < table.published.rows().size(); ++row) {
      if (table.published.number(row, *table.times)) continue;
      fields.report(node, fmt::format("{} has no time in row {}", table.published.file(), table.published.rows()[row]),
                    fmt::format("each row needs a number of seconds in the column {}", column));
    }
  }

  void read_events(Fields& fields, PathTable& table) {
    const std::size_t rows = table.published.rows().size();
    const toml::node* node = fields.find("events");
    if (!node) {
      for (std::size_t k = 0; k < rows; ++k) table.events.push_back(k);
      return;
    }
    if (const toml::array* list = node->as_array()) {
      for (const toml::node& item : *list) {
        table.events.push_back(static_cast<std::size_t>(std::max<std::int64_t>(item.value_or(std::int64_t{0}), 0)));
      }
    }
    if (table.events.size() != rows) {
      fields.report(*node, fmt::format("events names {} rows", table.events.size()),
                    fmt::format("{} has {}, and each needs one", table.published.file(), rows));
    }
  }

  Exception read_exception(const toml::table& from, const PublishedTable& published) {
    Fields fields(document_, from, "exception", problems_);
    Exception exception;
    exception.rows = fields.texts("rows", false);
    exception.columns = fields.texts("columns", false);
    exception.why = fields.text("why");
    exception.tolerance = tolerance_in(fields);
    for (const std::string& column : exception.columns) check_column(fields, published, column, from);
    for (const std::string& row : exception.rows) {
      if (!published.row(row)) {
        fields.report(from, fmt::format("{} has no row {}", published.file(), row),
                      fmt::format("its rows are {}", fmt::join(published.rows(), ", ")));
      }
    }
    fields.finish();
    return exception;
  }

  StatisticsTable read_statistics(Fields& fields, PublishedTable published) {
    StatisticsTable table{std::move(published), fields.texts("columns", true), sample_in(fields),
                          statistics_in(fields, "tested")};
    for (const std::string& column : table.columns) {
      check_column(fields, table.published, column, *fields.from().get("columns"));
    }
    const auto report = [&](std::string what, std::string why) {
      Problem problem{
          .file = table.published.file(), .where = {}, .what = std::move(what), .why = std::move(why), .hint = {}};
      problems_.add(std::move(problem));
    };
    for (const std::string& row : table.published.rows()) {
      if (!statistic_of(row)) {
        report(fmt::format("there is no statistic {}", row),
               fmt::format("expected one of {}", fmt::join(statistic_names(), ", ")));
      }
    }
    if (!table.published.row(name(Statistic::count))) {
      report("the row count is missing", "it gives the size of the samples");
    }
    return table;
  }

  ValuesTable read_values(Fields& table_fields) {
    ValuesTable table;
    table_fields.tables("value", true, [&](const toml::table& from) {
      Fields fields(document_, from, "value", problems_);
      ValuesTable::Value value{fields.text("what"), fields.text("run"), sample_in(fields),
                               Statistic::mean,     Interval{},         tolerance_in(fields).value_or(Tolerance{})};
      if (const toml::node* node = from.get("run")) check_run(fields, value.run, *node);
      const std::string word = fields.text_or("statistic", "mean");
      const toml::node* named = from.get("statistic");
      value.statistic = fields.one_of(word, "statistic", statistic_of, statistic_names(), named ? *named : from)
                            .value_or(Statistic::mean);
      if (const toml::node* between = fields.find("between")) {
        const toml::array* ends = between->as_array();
        const bool is_pair = ends && ends->size() == 2;
        const auto low = is_pair ? project::number_in((*ends)[0]) : std::nullopt;
        const auto high = is_pair ? project::number_in((*ends)[1]) : std::nullopt;
        if (low && high) {
          value.published = Interval{*low, *high};
        } else {
          fields.report(*between, fmt::format("between is {}", project::quoted(*between)), "expected [low, high]");
        }
      } else if (const std::string text = fields.text("published"); auto number = printed(text)) {
        value.published = std::move(*number);
      } else if (!text.empty()) {
        fields.report(*from.get("published"), fmt::format("published is \"{}\"", text),
                      "expected a number as printed, in quotes");
      }
      fields.finish();
      table.values.push_back(std::move(value));
    });
    return table;
  }

  CountTable read_count(Fields& fields) {
    CountTable table;
    table.rocks = static_cast<std::uint64_t>(fields.whole_number("rocks", 1).value_or(1));
    table.sample = sample_in(fields);
    const toml::node* node = fields.need("published");
    const toml::table* columns = node ? node->as_table() : nullptr;
    if (node && !columns) {
      fields.report(*node, fmt::format("published is {}", project::quoted(*node)),
                    "expected a table of programs and their counts");
    }
    for (const auto& [key, value] : columns ? *columns : toml::table{}) {
      if (auto number = printed(value.value_or(std::string()))) {
        table.published.emplace_back(std::string(key.str()), std::move(*number));
      } else {
        fields.report(value, fmt::format("{} is {}", key.str(), project::quoted(value)),
                      "expected a number as printed, in quotes");
      }
    }
    return table;
  }

  AgreementTable read_agreement(Fields& fields) {
    AgreementTable table{sample_in(fields), statistics_in(fields, "statistics"), 3};
    table.decimals = static_cast<int>(fields.whole_number("decimals", 0).value_or(3));
    return table;
  }

  SoundnessTable read_soundness(Fields& fields) {
    SoundnessTable table;
    const std::vector<std::string_view> known = end_reason_names();
    for (const std::string& word : fields.texts("ends", true)) {
      if (const auto r = fields.one_of(word, "ends", end_reason_of, known, *fields.from().get("ends"))) {
        table.ends.push_back(*r);
      }
    }
    table.energy_rise = fields.number("energy_rise").value_or(0);
    for (const std::string& word : fields.texts("shown", false)) {
      if (const auto q =
              fields.one_of(word, "shown", sample_quantity_of, sample_quantity_names(), *fields.from().get("shown"))) {
        table.shown.push_back(*q);
      }
    }
    return table;
  }

  const Files& files_;
  std::string name_;
  Document document_;
  Problems problems_;
  std::vector<std::string> runs_;
  std::vector<std::int64_t> rocks_;  // of each run; 0 if the project gives it
};

}  // namespace

bool Exception::concerns(const std::string& row, const std::string& column) const {
  const auto has = [](const std::vector<std::string>& list, const std::string& name) {
    return list.empty() || std::ranges::find(list, name) != list.end();
  };
  return has(rows, row) && has(columns, column);
}

const Run& Case::run(std::string_view run_name) const { return *std::ranges::find(runs, run_name, &Run::name); }

Case read_case(const Files& files, const std::string& name) { return CaseReader(files, name).read(); }

}  // namespace talus::verification
