#include "talus/model/build_ensembles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "talus/core/random.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/csv_reader.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/model/model.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/parameter.hpp"

namespace talus::project {

namespace {

constexpr std::string_view weight_column = "weight";
constexpr std::uint32_t draw_of_sets = 0x50000001;  // a purpose of its own (core/random.hpp)
constexpr std::size_t most_sets = 1'000'000, most_problems = 20;
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
      refuse(0, "", "cannot be read", std::move(why), "");
    throw_if_any();
    refuse_special_file();
    CsvReader csv(file_);
    read_columns(csv);
    throw_if_any();
    for (int line = 2; csv.next(); ++line) {
      stop_point();
      read_set(csv, line);
      if (problems_.list().size() >= most_problems) break;
      if (sample_.sets.size() > most_sets)
        refuse(line, "", "has too many rows", fmt::format("expected at most {}", most_sets), "");
    }
    throw_if_any();
    double sum = 0;
    for (const double weight : sample_.weights) sum += weight;
    if (sample_.sets.empty()) refuse(0, "", "has no rows", "each row is a set of parameters", "");
    if (!sample_.sets.empty() && !(sum > 0))
      refuse(0, std::string(weight_column), "is 0 in all rows", "sets are drawn by weight", "");
    throw_if_any();
    return std::move(sample_);
  }

 private:
  void refuse(int line, std::string where, std::string what, std::string why, std::string hint) {
    problems_.add({.file = file_.string(),
                   .line = line,
                   .where = std::move(where),
                   .what = std::move(what),
                   .why = std::move(why),
                   .hint = std::move(hint)});
  }
  void throw_if_any() {
    if (problems_.has_errors()) throw BadInput(std::move(problems_));
  }
  void refuse_special_file() const {
    if (const auto why = not_an_ordinary_file(file_))
      throw BadInput(Problem{.file = file_.string(), .what = "cannot be read", .why = *why});
  }

  /// Columns with a point in their name are parameters; others but `weight` are notes, such as a score.
  void read_columns(const CsvReader& csv) {
    for (std::size_t k = 0; k < csv.columns().size(); ++k) {
      const std::string& name = csv.columns()[k];
      const Problem where{.file = file_.string(), .line = 1, .where = name};
      if (name == weight_column) {
        weight_ = k;
      } else if (std::ranges::find(settings_of_all, name) != settings_of_all.end()) {
        refuse(1, name, "cannot differ between rocks", "all rocks of a run share it", "Leave the column out");
      } else if (name.find('.') != std::string::npos) {
        Problems found;
        if (auto number = SettingNumber::find(project_, name, where, found)) {
          sample_.numbers.push_back(*number);
          columns_.push_back(k);
        }
        for (const Problem& problem : found.list())
          (problem.severity == Severity::error ? problems_ : warnings_).add(problem);
      }
    }
    if (columns_.empty() && !problems_.has_errors())
      refuse(1, "", "has no column of a parameter", "a column is named by the path of its setting",
             "For example material.Scree.normal_restitution");
  }

  void read_set(const CsvReader& csv, int line) {
    const double weight = weight_ ? csv.number(*weight_) : 1.0;
    if (weight < 0)
      refuse(line, std::string(weight_column), fmt::format("is {:g}", weight), "a weight is not negative", "");
    std::vector<double> set;
    Project changed = project_;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      set.push_back(csv.number(columns_[k]));
      if (weight <= 0) continue;
      if (const auto why = sample_.numbers[k].set(changed, set.back()))
        refuse(line, csv.columns()[columns_[k]], *why, "", "");
    }
    sample_.sets.push_back(std::move(set));
    sample_.weights.push_back(weight);
  }

  const Project& project_;
  Problems& warnings_;
  std::filesystem::path file_;
  Problems problems_;
  ParameterSample sample_;
  std::vector<std::size_t> columns_;  // of the numbers
  std::optional<std::size_t> weight_;
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

}  // namespace

void add_ensembles(const Project& project, Model& model, Problems& warnings) {
  const ParameterSample sample = SampleReader(project, warnings).read();
  const auto ensembles = static_cast<std::size_t>(project.sampling.ensembles);
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
