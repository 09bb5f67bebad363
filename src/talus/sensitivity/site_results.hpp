#pragma once
// The results of a sensitivity study at one of its sites.

#include <cstddef>
#include <optional>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"
#include "talus/results/run_figures.hpp"
#include "talus/sensitivity/study.hpp"
#include "talus/study/prepared_site.hpp"

namespace talus::sensitivity {

class SiteResults {
 public:
  /// Adds a problem if the site has no line of this name.
  void add(std::size_t result, const Study& study, const project::Project& project, Problems& problems);

  /// Indices of the study's results.
  [[nodiscard]] const std::vector<std::size_t>& of() const { return of_; }
  /// Of a run, in the order of `of`; nullopt: no rock has one.
  [[nodiscard]] std::vector<std::optional<double>> values(const study::SetOutcome& outcome) const;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::vector<std::size_t> of_;
  std::vector<RunFigure> figures_;
  std::vector<std::size_t> line_of_barrier_;  // by barrier; none if no result is at it
  std::size_t lines_ = 0;
};

}  // namespace talus::sensitivity
