#pragma once
// The columns of a sample of parameters that apply to a project: a study of several sites names a parameter that not
// all of them share `PATH@SITE`, or `PATH@SITE@SITE` if it is that of two.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct ParameterColumn {
  std::size_t column;
  std::string path;  // in the project, without the site
};

struct ParameterColumns {
  std::vector<ParameterColumn> list;
  std::string site;  // whose columns they are; empty: all are those of all sites
};

/// The columns with the path of a setting in their name (it has a point): those of all sites, and those of one site.
/// That is `sampling.parameters_site`, or the only site of which all columns name numbers of this project. Adds a
/// problem if it is none of the sites, or if the columns of none or of several sites would do. `file`: of the columns.
[[nodiscard]] ParameterColumns parameter_columns(std::span<const std::string> names, const Project& project,
                                                 const std::string& file, Problems& problems);

}  // namespace talus::project
