#include "talus/model/build_ensembles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "talus/core/random.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/data_table.hpp"
#include "talus/files/mistyped_column.hpp"
#include "talus/model/fixed_columns.hpp"
#include "talus/model/model.hpp"
#include "talus/model/site_columns.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/parameter.hpp"

namespace talus::project {

namespace {

constexpr std::string_view weight_column = "weight";
constexpr std::uint32_t draw_of_sets = 0x50000001;  // a purpose of its own (core/random.hpp)
constexpr std::size_t most_sets = 1'000'000;
/// What all rocks of a run share: the steps of slides in lanes, and the energies of its tables.
constexpr std::array settings_of_all{"analysis.gravity_m_s2", "analysis.max_timestep_s",
                                     "analysis.stopped_velocity_m_s", "analysis.max_time_s"};

struct ParameterSample {
  std::vector<SettingNumber> numbers;
  std::vector<std::vector<double>> sets;
  std::vector<double> weights;
};

class SampleReader {
 public:
  SampleReader(const Project& project, Problems& warnings)
      : project_(project), warnings_(warnings), file_(project.file.parent_path() / project.sampling.parameters) {}

  ParameterSample read() {
    if (std::string why = why_unreadable(project_, project_.sampling.parameters); !why.empty())
      throw BadInput(problem(0, "cannot be read", std::move(why)));
    DataTable table(file_);
    read_columns(table);
    refuse_overlaps();
    throw_if_any();
    while (table.next()) {
      fixed_->check(table);
      read_set(table);
      if (sample_.sets.size() > most_sets)
        throw BadInput(problem(table.line(), "has too many rows",
                               fmt::format("expected at most {} sets of parameters", most_sets)));
    }
    table.throw_if_any();
    double sum = 0;
    for (const double weight : sample_.weights) sum += weight;
    if (sample_.sets.empty()) {
      problems_.add(problem(0, "has no rows", "each row is a set of parameters"));
    } else if (!(sum > 0)) {
      problems_.add(problem(0, fmt::format("{} is 0 in all rows", weight_column), "sets are drawn by weight"));
    }
    throw_if_any();
    return std::move(sample_);
  }

 private:
  [[nodiscard]] Problem problem(int line, std::string what, std::string why, std::string hint = "") const {
    return {.file = file_.string(),
            .line = line,
            .where = {},
            .what = std::move(what),
            .why = std::move(why),
            .hint = std::move(hint)};
  }
  void throw_if_any() {
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
  }

  /// Columns with a point in their name are parameters; others but `weight` are notes. `talus calibrate` writes a
  /// `score`; its values are of means where properties have distributions.
  void read_columns(const DataTable& table) {
    is_posterior_ = std::ranges::any_of(table.columns(),
                                        [](const std::string& name) { return plain_column_name(name) == "score"; });
    for (std::size_t k = 0; k < table.columns().size(); ++k) {
      if (plain_column_name(table.columns()[k]) == weight_column) weight_ = k;
    }
    if (!weight_) refuse_mistyped_weight(table);
    const ParameterColumns found = parameter_columns(table.columns(), project_, file_.string(), problems_);
    fixed_.emplace(table, project_, found.site);
    for (const auto& [column, path] : found.list) {
      if (std::ranges::find(settings_of_all, path) != settings_of_all.end()) {
        problems_.add(problem(1, fmt::format("{} cannot differ between rocks", path), "all rocks of a run share it",
                              "Leave the column out"));
      } else {
        add_parameter(path, column);
      }
    }
    if (columns_.empty() && !problems_.has_errors())
      problems_.add(problem(1, "has no column of a parameter", "a column is named by the path of its setting",
                            "For example material.Scree.normal_restitution"));
  }

  void refuse_mistyped_weight(const DataTable& table) {
    for (const std::string& name : table.columns()) {
      if (!mistyped_column(plain_column_name(name), std::span(&weight_column, 1))) continue;
      problems_.add(problem(1, fmt::format("column \"{}\" is not known", name),
                            fmt::format("it would not be read, and there is no column {}", weight_column),
                            fmt::format("Name it {}, or otherwise if it is something else", weight_column)));
    }
  }

  void add_parameter(const std::string& name, std::size_t column) {
    Problem where = problem(1, "", "");
    where.where = name;
    Problems found;
    if (auto number = SettingNumber::find(project_, name, where, found)) {
      if (const auto distribution = number->distribution_in(project_);
          distribution && !is_posterior_ && !name.ends_with(".mean")) {
        where.severity = Severity::warning;
        where.what = "is the mean of a distribution in the project";
        where.why = "rocks of an ensemble also draw about its value";
        where.hint =
            fmt::format("If that is meant, name the column {}.mean; else give the project a plain number", name);
        warnings_.add(where);
      }
      sample_.numbers.push_back(*number);
      columns_.push_back(column);
    }
    for (const Problem& each : found.list()) (each.severity == Severity::error ? problems_ : warnings_).add(each);
  }

  /// A number of the current row; refuses what is none.
  std::optional<double> number(DataTable& table, std::size_t column) {
    const std::string_view text = table.text(column);
    const auto value = number_in_cell(text, table.comma_is_point());
    if (value && std::isfinite(*value)) return value;
    table.refuse(fmt::format("{} is {}", table.columns()[column], text.empty() ? "empty" : fmt::format("\"{}\"", text)),
                 "expected a finite number");
    return std::nullopt;
  }

  void read_set(DataTable& table) {
    double weight = 1;
    if (weight_) weight = number(table, *weight_).value_or(0);
    if (weight < 0) table.refuse(fmt::format("{} is {:g}", weight_column, weight), "a weight is not negative");
    std::vector<double> set;
    Project changed = project_;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const auto value = number(table, columns_[k]);
      set.push_back(value.value_or(0));
      if (!value || weight <= 0) continue;
      if (const auto why = sample_.numbers[k].set(changed, *value)) table.refuse(*why, "");
    }
    sample_.sets.push_back(std::move(set));
    sample_.weights.push_back(weight);
  }

  /// Two columns may name the same number: by its name and by *.
  void refuse_overlaps() {
    for (std::size_t k = 1; k < columns_.size(); ++k) {
      for (std::size_t before = 0; before < k; ++before) {
        if (!sample_.numbers[before].shares_a_number_with(sample_.numbers[k])) continue;
        problems_.add(problem(
            1, fmt::format("{} and {} give the same number", sample_.numbers[before].path(), sample_.numbers[k].path()),
            "it is not clear which one applies", "Leave one of them out"));
      }
    }
  }

  const Project& project_;
  Problems& warnings_;
  std::filesystem::path file_;
  Problems problems_;
  ParameterSample sample_;
  std::vector<std::size_t> columns_;  // of the numbers
  std::optional<std::size_t> weight_;
  std::optional<FixedColumns> fixed_;
  bool is_posterior_ = false;
};

/// The set of each ensemble.
std::vector<std::size_t> drawn_sets(const std::vector<double>& weights, std::size_t ensembles, std::uint64_t seed) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  const auto words = philox(seed, 0, draw_of_sets, 0);
  const double u = (static_cast<double>(words[0]) + 0.5) * 0x1p-32;
  std::vector<std::size_t> drawn;
  std::size_t last = 0;  // with a weight
  double up_to = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (weights[k] > 0) last = k;
    up_to += weights[k];
    while (drawn.size() < ensembles &&
           (static_cast<double>(drawn.size()) + u) / static_cast<double>(ensembles) * sum < up_to)
      drawn.push_back(k);
  }
  while (drawn.size() < ensembles) drawn.push_back(last);  // rounding of the sum
  return drawn;
}

void warn(const Project& project, std::string key, std::string what, std::string why, std::string hint,
          Problems& warnings) {
  warnings.add({.severity = Severity::warning,
                .file = project.file.string(),
                .where = "[sampling]",
                .what = std::move(what),
                .why = std::move(why),
                .hint = std::move(hint),
                .path = "sampling." + key});
}

/// Warns of seeders with enough rocks for all of their places, if each were of one rock.
void warn_of_places(const Project& project, const Model& model, Problems& warnings) {
  for (const talus::Seeder& seeder : model.seeders) {
    const ReleaseOrder order = release_order(seeder, model.seed);
    if (order.turns() >= order.places || order.rocks < order.places) continue;
    warnings.add({.severity = Severity::warning,
                  .file = project.file.string(),
                  .where = fmt::format("seeder \"{}\"", seeder.name),
                  .what = fmt::format("{} of {} places release no rock", order.places - order.turns(), order.places),
                  .why = fmt::format("each of {} ensembles has a rock from the same {} places", order.rocks_at_once,
                                     order.turns()),
                  .hint = fmt::format("For all places run {} rocks or a multiple, or fewer ensembles",
                                      order.places * order.rocks_at_once)});
  }
}

}  // namespace

void add_ensembles(const Project& project, Model& model, Problems& warnings) {
  const ParameterSample sample = SampleReader(project, warnings).read();
  const auto ensembles = static_cast<std::size_t>(project.sampling.ensembles);
  for (const talus::Seeder& seeder : model.seeders) {
    if (ensembles <= seeder.rocks) continue;
    throw BadInput(Problem{.file = project.file.string(),
                           .where = "[sampling]",
                           .what = fmt::format("ensembles is {}", ensembles),
                           .why = fmt::format("seeder \"{}\" has {} {}, and each ensemble needs one", seeder.name,
                                              seeder.rocks, seeder.rocks == 1 ? "rock" : "rocks"),
                           .hint = "Run more rocks, or fewer ensembles",
                           .path = "sampling.ensembles"});
  }
  warn_of_places(project, model, warnings);
  for (const SettingNumber& number : sample.numbers) model.uncertain.push_back(number.path());
  for (const std::size_t k : drawn_sets(sample.weights, ensembles, project.sampling.seed)) {
    stop_point();
    Project changed = project;
    for (std::size_t i = 0; i < sample.numbers.size(); ++i)
      static_cast<void>(sample.numbers[i].set(changed, sample.sets[k][i]));  // read_set has done it before
    Model& ensemble = model.ensembles.emplace_back(model.without_surface());
    set_properties(changed, ensemble);
    model.drawn_parameters.push_back(sample.sets[k]);
  }
  constexpr std::uint64_t few_rocks = 20;
  const std::uint64_t each = model.rocks() / ensembles;
  if (each < few_rocks)
    warn(project, "ensembles", fmt::format("an ensemble has {} of {} rocks", each, model.rocks()),
         "the parts of rocks and parameters cannot be separated", "Run more rocks, or fewer ensembles", warnings);
  const bool is_one = std::ranges::all_of(model.drawn_parameters,
                                          [&](const auto& set) { return set == model.drawn_parameters.front(); });
  if (is_one)
    warn(project, "parameters", "all ensembles have the same parameters", "one row has all of the weight", "",
         warnings);
}

}  // namespace talus::project
