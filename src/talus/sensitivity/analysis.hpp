#pragma once
// Runs a sensitivity study: the models of its sites are built once and run with many values of the inputs; the
// statistics of the results give the effects.

#include <functional>
#include <memory>
#include <optional>
#include <span>
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
  std::string name;          // of the study's parameter, or seed_name
  std::string unit, values;  // "0.2 to 0.6"
  int line = 0;              // of the study file
};
inline constexpr const char* seed_name = "(seed)";

/// What an input causes in a result; of the study's method.
struct Effect {
  std::optional<ElementaryEffects> elementary;
  std::optional<SobolIndex> index;

  /// mu*, or the total index: what inputs are ordered by.
  [[nodiscard]] std::optional<Estimate> size() const;
};

/// Of a result at a site.
struct ResultEffects {
  std::size_t result = 0, site = 0;  // of the study
  std::string title;                 // the result's name; with `@SITE` if there are several sites
  std::string unit;
  std::uint64_t defined = 0;                // runs in which it has a value
  std::optional<double> mean, least, most;  // over these
  std::vector<Effect> of_inputs;            // empty ones of parameters that the site does not have
};

/// The results of a run at all sites, site by site; nullopt: no rock reaches the line.
using RunResults = std::vector<std::optional<double>>;

/// A run at all sites: the values of the inputs (the seed last) and of the results at the sites.
struct StudyRun {
  std::vector<double> inputs;
  RunResults results;
};

struct Analysis {
  std::vector<Input> inputs;
  std::vector<ResultEffects> results;
  std::vector<StudyRun> runs;
  Problems warnings;
};

struct AnalysisOptions {
  int threads = 0;  // 0: as many as there are cores
  /// Called with the number of finished runs at one site, among them known ones, from any thread, one at a time.
  std::function<void(std::uint64_t)> progress{};
  /// Returns the results of a run that an earlier analysis has made.
  std::function<std::optional<RunResults>(std::size_t run)> known{};
  /// Called with runs that are finished, in their order.
  std::function<void(std::size_t first, std::span<const StudyRun> runs)> finished{};
};

/// A study with its projects read and their models built.
class PreparedStudy {
 public:
  /// Throws BadInput with all problems of the study, its projects and its paths; doubts are added to
  /// `warnings`.
  PreparedStudy(const Study& study, Problems& warnings);
  ~PreparedStudy();
  PreparedStudy(const PreparedStudy&) = delete;
  PreparedStudy& operator=(const PreparedStudy&) = delete;

  /// Runs of the whole study at each site: each has one set of values of all inputs.
  [[nodiscard]] std::uint64_t runs() const;
  /// Identifies the runs: the study, its projects and the program.
  [[nodiscard]] const std::string& fingerprint() const;
  /// The same bits on any number of threads. Throws Stopped at the request of the thread's StopScope.
  [[nodiscard]] Analysis run(const AnalysisOptions& options) const;

 private:
  struct Parts;
  class Runs;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::sensitivity
