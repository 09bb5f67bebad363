#pragma once
// The projects of a study, prepared, and the parameters of the study in them.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/files/checksum.hpp"
#include "talus/project/parameter.hpp"
#include "talus/study/prepared_site.hpp"
#include "talus/study/study_file.hpp"

namespace talus::study {

/// A parameter of a study: one value, at one or several sites.
struct Parameter {
  std::string name;  // its path; with `@SITE` for each of its sites if others have another one of this path
  std::string unit;
  project::Prior prior;
  std::vector<std::optional<project::SettingNumber>> at_site;  // by site; nullopt: not there
  int line = 0;                                                // of the study file
};

/// The place of problems of a parameter.
[[nodiscard]] Problem about_parameter(const StudyFile& study, const std::string& name, int line);

class PreparedSites {
 public:
  PreparedSites() = default;
  /// Reads the projects, with the study's seed and number of rocks, and builds their models; `overrides` are for all of
  /// them. Throws BadInput if one cannot be built. Parameters that cannot vary as given are added to `problems`.
  PreparedSites(const StudyFile& study, const std::vector<std::string>& overrides, Problems& problems,
                Problems& warnings);

  [[nodiscard]] const std::vector<PreparedSite>& sites() const { return sites_; }
  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// The parameters that a site has, and which of the study's they are.
  struct AtSite {
    std::vector<project::SettingNumber> numbers;
    std::vector<std::size_t> of;  // indices of parameters()
    [[nodiscard]] ParameterSet values(const ParameterSet& all) const;
  };
  [[nodiscard]] const AtSite& at_site(std::size_t site) const { return at_site_[site]; }

  /// Runs the sets at a site as PreparedSite::run does. A set has one value for each of parameters().
  void run(std::size_t site, std::span<const ParameterSet> sets, const SetRuns& how,
           const std::function<void(std::size_t, SetOutcome&&)>& take) const;
  [[nodiscard]] SetOutcome run(std::size_t site, const ParameterSet& set, const SetRuns& how = {}) const;

  /// Adds what determines the outcome of a set (sites, parameters, seed, number of rocks, the program) to a checksum.
  void add_to(Checksum& checksum) const;

 private:
  void read_sites(const StudyFile& study, const std::vector<std::string>& overrides, Problems& warnings);
  void add_parameter(const StudyFile& study, const GivenParameter& given, Problems& problems);

  std::vector<PreparedSite> sites_;
  std::vector<Parameter> parameters_;
  std::vector<AtSite> at_site_;
};

}  // namespace talus::study
