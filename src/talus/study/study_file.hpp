#pragma once
// What the files of all studies, STUDY.toml, have in common: the projects of their sites, and the parameters that vary.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/settings.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::study {

/// [[site]]
struct GivenSite {
  std::string name;               // default: "site N"
  std::filesystem::path project;  // as written in the file; relative to the study file
  std::vector<std::string> set;   // `table.key=value`, as `--set` of the command line
  int line = 0;
};

/// [[parameter]]
struct GivenParameter {
  std::string path;                   // in the projects, as in `--set`
  std::vector<double> range;          // two numbers; or
  std::optional<Distribution> prior;  // in the form of a project's distributions
  std::vector<std::string> sites;     // empty: all, which share one value
  bool each_site = false;             // every site has its own value
  int line = 0;
};

/// The part of a study file that every kind of study has. The structs of the kinds are derived from it.
struct StudyFile {
  std::filesystem::path file;  // as the user named it
  std::string name;            // default: the file's stem
  std::uint64_t seed = 1;
  std::int64_t rocks = 200;  // of each set of parameters, at each site
  std::vector<GivenSite> sites;
  std::vector<GivenParameter> parameters;
};

/// The row of a new entry of a list.
template <class Struct>
[[nodiscard]] project::Row added_row(std::vector<Struct>& list, int line) {
  list.emplace_back().line = line;
  return &list.back();
}

[[nodiscard]] project::Table site_table();
[[nodiscard]] project::Table parameter_table();

/// Collects what is wrong across several keys of a study file, each problem at its place.
class StudyProblems {
 public:
  StudyProblems(const project::Document& document, const std::unordered_set<const toml::node*>& refused,
                Problems& problems)
      : document_(document), refused_(refused), problems_(problems) {}

  /// Whether the file has the key. `table`: empty for the head; `index`: of its entries.
  [[nodiscard]] bool is_given(std::string_view table, std::size_t index, std::string_view key) const;
  /// Whether a value was given that its own setting refuses.
  [[nodiscard]] bool is_refused(std::string_view table, std::size_t index, std::string_view key) const;
  /// At the key, if it is given, or else at the table's entry.
  void refuse(std::string_view table, std::size_t index, std::string_view key, std::string what, std::string why,
              std::string hint = {});
  /// A word that is none of the known ones.
  void refuse_word(std::string_view table, std::size_t index, std::string_view key, const std::string& word,
                   const std::vector<std::string_view>& known);
  /// If the study has no site of this name.
  void check_site_name(std::string_view table, std::size_t index, std::string_view key, const std::string& name,
                       const StudyFile& study);
  /// Entries of a list must differ in their names.
  template <class Entry>
  void check_names(std::string_view table, const std::vector<Entry>& entries) {
    std::set<std::string> before;
    for (std::size_t k = 0; k < entries.size(); ++k) {
      if (!entries[k].name.empty() && !before.insert(entries[k].name).second) refuse_again(table, k, entries[k].name);
    }
  }
  void check_parameters(const StudyFile& study);

 private:
  [[nodiscard]] const toml::table* row(std::string_view table, std::size_t index) const;
  void refuse_again(std::string_view table, std::size_t index, const std::string& name);

  const project::Document& document_;
  const std::unordered_set<const toml::node*>& refused_;
  Problems& problems_;
};

/// What a kind of study adds to the reading of its file.
struct StudyReader {
  const std::vector<project::Table>& tables;
  /// The row to read the head or the next entry of a list into; not called for sites and parameters.
  std::function<project::Row(std::string_view table, int line)> row;
  /// The rules across several keys, beside those of sites and parameters.
  std::function<void(StudyProblems&)> check;
};

/// A problem if a file that a study names by `key` is not there.
[[nodiscard]] std::optional<Problem> lacking_file(const StudyFile& study, const std::filesystem::path& file,
                                                  std::string_view key, int line, std::string where);
/// The projects of the sites that are not there.
[[nodiscard]] Problems lacking_projects(const StudyFile& study);

/// Reads the text of a file of this name into `study` and returns the warnings. Throws BadInput with every problem of
/// the file, in its order. The files that it names are not read.
[[nodiscard]] Problems read_study_text(std::string_view text, const std::filesystem::path& file, StudyFile& study,
                                       const StudyReader& reader);

}  // namespace talus::study
