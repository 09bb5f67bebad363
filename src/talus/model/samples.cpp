#include "talus/model/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "talus/files/data_table.hpp"
#include "talus/files/mesh_problems.hpp"
#include "talus/files/names_in_words.hpp"
#include "talus/model/drawn.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

namespace {

/// The place of a column; throws BadInput if there is none.
std::size_t place_of_column(const DataTable& table, const std::string& name, const std::string& file) {
  const std::vector<std::string> names(table.columns().begin(), table.columns().end());
  auto found = std::ranges::find(names, name);
  if (found == names.end())
    found = std::ranges::find(names, plain_column_name(name), [](const auto& n) { return plain_column_name(n); });
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw BadInput(Problem{.file = file,
                         .where = {},
                         .what = fmt::format("has no column \"{}\"", name),
                         .why = fmt::format("it has {}", talus::listed(names)),
                         .hint = meant(name, names)});
}

class ValuesReader {
 public:
  ValuesReader(const std::filesystem::path& path, const Setting& setting, const Distribution& given, Problems& warnings)
      : file_(path.string()), table_(path), setting_(setting), given_(given), warnings_(warnings) {}

  std::shared_ptr<const EmpiricalSample> read() {
    const std::string name = given_.column.empty() ? std::string(setting_.key) : given_.column;
    const std::size_t column = place_of_column(table_, name, file_);
    const bool is_weighted = !given_.weight_column.empty();
    const std::size_t weights = is_weighted ? place_of_column(table_, given_.weight_column, file_) : column;
    const Bounds bounds = drawn(setting_.key, given_)->bounds;
    std::vector<EmpiricalSample::Value> values;
    double weight_sum = 0;
    while (table_.next()) {
      const auto value = number(column);
      const std::optional<double> weight = is_weighted ? number(weights) : 1.0;
      if (!value || !weight) continue;
      if (*value < bounds.least || *value > bounds.most) {
        const std::string_view why = *value > bounds.most ? setting_.range.too_high : setting_.range.too_low;
        table_.refuse(fmt::format("{} is {}", table_.columns()[column], number_text(*value)),
                      fmt::format("{}{}expected {}", why, why.empty() ? "" : "; ", setting_.range.text()));
      } else if (*weight < 0) {
        table_.refuse(fmt::format("{} is {}", table_.columns()[weights], number_text(*weight)),
                      "a weight is not negative");
      } else {
        doubt(*value);
        weight_sum += *weight;
        values.push_back({*value, *weight});
      }
    }
    table_.throw_if_any();
    if (values.empty()) stop("has no rows", "a sample has one value or more");
    if (!(weight_sum > 0)) stop("has only weights of 0", "no value could be drawn");
    if (!std::isfinite(weight_sum)) stop("has weights with an infinite sum", "they are shares");
    return std::make_shared<const EmpiricalSample>(std::move(values));
  }

 private:
  [[noreturn]] void stop(std::string what, std::string why) const {
    throw BadInput(Problem{.file = file_, .where = {}, .what = std::move(what), .why = std::move(why), .hint = {}});
  }

  std::optional<double> number(std::size_t column) {
    const std::string_view text = table_.text(column);
    const auto value = number_in_cell(text, table_.comma_is_point());
    if (value && std::isfinite(*value)) return value;
    table_.refuse(fmt::format("{} is {}", table_.columns()[column], text.empty() ? "empty" : in_quotes(text)),
                  "expected a number");
    return std::nullopt;
  }

  /// Warns of the first doubtful value.
  void doubt(double value) {
    const auto doubt = setting_.doubt && !has_doubt_ ? setting_.doubt(value) : std::nullopt;
    if (!doubt) return;
    has_doubt_ = true;
    warnings_.add({.severity = Severity::warning,
                   .file = file_,
                   .line = table_.line(),
                   .where = {},
                   .what = fmt::format("the value is {}", number_text(value)),
                   .why = doubt->why,
                   .hint = doubt->hint});
  }

  std::string file_;
  DataTable table_;
  const Setting& setting_;
  const Distribution& given_;
  Problems& warnings_;
  bool has_doubt_ = false;
};

/// Calls visit(declared, number, setting, distribution) for each empirical distribution.
template <class Visit>
void for_empirical(Project& project, Visit&& visit) {
  for (const Table& declared : tables()) {
    const std::vector<Row> rows = declared.rows(project);
    for (std::size_t number = 0; number < rows.size(); ++number) {
      for (const Setting& setting : declared.settings) {
        Distribution* const distribution = distribution_in(setting.slot(rows[number]));
        if (distribution && distribution->kind == DistributionKind::empirical)
          visit(declared, number, setting, *distribution);
      }
    }
  }
}

std::string row_name(const Project& project, const Table& declared, std::size_t number) {
  const std::string& name =
      declared.key == "material" ? project.materials.at(number).name : project.seeders.at(number).name;
  return name_in_problems(project, declared.key, name, number);
}

}  // namespace

Project read_samples(const Project& project, Problems& warnings) {
  Problems problems;
  Project with = project;
  for_empirical(with, [&](const Table& declared, std::size_t number, const Setting& setting, Distribution& given) {
    if (given.sample) return;
    const std::string where = row_name(project, declared, number);
    try {
      locating_problems(project, where, problems, warnings, [&](Problems&, Problems& own_warnings) {
        given.sample = ValuesReader(project.file.parent_path() / given.file, setting, given, own_warnings).read();
        return true;
      });
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  });
  if (problems.has_errors()) throw BadInput(problems.in_order_of(project.file.string()));
  return with;
}

}  // namespace talus::project
