#pragma once
// Runs a sensitivity study: the project's model is built once and run with many values of the inputs; the statistics of
// the results give the effects.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/sensitivity/study.hpp"
#include "talus/statistics/morris.hpp"
#include "talus/statistics/sobol.hpp"

namespace talus::sensitivity {

/// A number that varies. The last input of every study is the seed of the rocks: what it seems to cause is the noise of
/// a finite number of rocks.
struct Input {
  std::string name;          // its path, or seed_name
  std::string unit, values;  // "0.2 to 0.6"
};
inline constexpr const char* seed_name = "(seed)";

/// What an input causes in a result; of the study's method.
struct Effect {
  std::optional<ElementaryEffects> elementary;
  std::optional<SobolIndex> index;

  /// mu*, or the total index: what inputs are ordered by.
  [[nodiscard]] std::optional<Estimate> size() const;
};

struct ResultEffects {
  std::string name, unit;
  std::uint64_t defined = 0;                // runs in which it has a value
  std::optional<double> mean, least, most;  // over these
  std::vector<Effect> of_inputs;
};

/// A run: the values of the inputs (the seed last) and of the results.
struct StudyRun {
  std::vector<double> inputs;
  std::vector<std::optional<double>> results;
};

struct Analysis {
  std::vector<Input> inputs;
  std::vector<ResultEffects> results;
  std::vector<StudyRun> runs;
  Problems warnings;
};

struct AnalysisOptions {
  int threads = 0;  // 0: as many as there are cores
  /// Called with the number of finished runs, from any thread, one at a time.
  std::function<void(std::uint64_t)> progress;
};

/// A study with its project read and its model built.
class PreparedStudy {
 public:
  /// Throws BadInput with all problems of the study, its project and its paths.
  explicit PreparedStudy(const Study& study);
  ~PreparedStudy();
  PreparedStudy(const PreparedStudy&) = delete;
  PreparedStudy& operator=(const PreparedStudy&) = delete;

  [[nodiscard]] const Problems& warnings() const;
  /// The same bits on any number of threads. Throws Stopped at the request of the thread's StopScope.
  [[nodiscard]] Analysis run(const AnalysisOptions& options) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::sensitivity
