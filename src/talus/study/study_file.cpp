#include "talus/study/study_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "talus/core/nearest.hpp"
#include "talus/core/utf8.hpp"
#include "talus/project/read_table.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/toml_kind.hpp"
#include "talus/project/values.hpp"

namespace talus::study {

namespace {

using project::declared::member;

constexpr const char* site_key = "site";
constexpr const char* parameter_key = "parameter";

/// Whether two parameters have a site in common.
bool overlap(const GivenParameter& one, const GivenParameter& other) {
  const auto is_shared = [&](const std::string& site) { return std::ranges::count(other.sites, site) > 0; };
  return one.sites.empty() || other.sites.empty() || std::ranges::any_of(one.sites, is_shared);
}

}  // namespace

project::Table site_table() {
  return {
      .key = site_key,
      .repeated = true,
      .required = true,
      .meaning = "A project that the study runs.",
      .settings = {
          {.key = "name",
           .slot = member(&GivenSite::name),
           .without_it = "\"site N\"",
           .meaning = "Name that other tables refer to.",
           .source = "Talus"},
          {.key = "project",
           .slot = member(&GivenSite::project),
           .required = true,
           .meaning = "The project file, relative to the study file.",
           .source = "Talus"},
          {.key = "set",
           .slot = member(&GivenSite::set),
           .most_entries = 100,
           .meaning = "Settings that override the project's, as `--set` does: `[\"analysis.grazing_angle_deg=5\"]`.",
           .source = "Talus"},
      }};
}

project::Table parameter_table() {
  using Given = GivenParameter;
  return {
      .key = parameter_key,
      .repeated = true,
      .required = true,
      .meaning = "A number of the projects that varies.",
      .settings =
          {
              {.key = "path",
               .slot = member<Given>(&Given::path),
               .required = true,
               .meaning = "Its path in the project, as in `--set`: `material.Scree.normal_restitution`; `*` for all "
                          "names.",
               .source = "Talus"},
              {.key = "range",
               .slot = member<Given>(&Given::range),
               .most_entries = 2,
               .meaning = "Least and greatest value; all between are equally probable.",
               .source = "Talus"},
              {.key = "prior",
               .slot = member<Given>(&Given::prior),
               .without_it = "given by `range`",
               .meaning = "Its distribution: `{ mean = 0.4, distribution = \"normal\", std_dev = 0.1 }`.",
               .source = "Talus"},
              {.key = "sites",
               .slot = member<Given>(&Given::sites),
               .without_it = "all sites",
               .meaning = "The sites that have this parameter; they share its value.",
               .source = "Talus"},
              {.key = "each_site",
               .slot = member<Given>(&Given::each_site),
               .meaning = "Each site has its own value.",
               .source = "Talus"},
          },
      .choices = {{{"range"}, {"prior"}}}};
}

const toml::table* StudyProblems::row(std::string_view table, std::size_t index) const {
  if (table.empty()) return &document_.root();
  const toml::array* list = document_.root()[table].as_array();
  return list != nullptr && index < list->size() ? list->get(index)->as_table() : nullptr;
}

bool StudyProblems::is_given(std::string_view table, std::size_t index, std::string_view key) const {
  const toml::table* from = row(table, index);
  return from != nullptr && from->contains(key);
}

bool StudyProblems::is_refused(std::string_view table, std::size_t index, std::string_view key) const {
  return is_given(table, index, key) && refused_.contains(row(table, index)->get(key));
}

void StudyProblems::refuse(std::string_view table, std::size_t index, std::string_view key, std::string what,
                           std::string why, std::string hint) {
  const toml::table* from = row(table, index);
  const toml::node* node = from != nullptr && !key.empty() ? from->get(key) : nullptr;
  Problem problem = node != nullptr   ? document_.at(*node)
                    : from != nullptr ? document_.at(*from)
                                      : document_.nowhere(table);
  if (!table.empty()) problem.where = fmt::format("[[{}]] {}", table, index + 1);
  problem.what = std::move(what);
  problem.why = std::move(why);
  problem.hint = std::move(hint);
  problems_.add(std::move(problem));
}

void StudyProblems::refuse_word(std::string_view table, std::size_t index, std::string_view key,
                                const std::string& word, const std::vector<std::string_view>& known) {
  const auto near = nearest(word, known);
  refuse(table, index, key, fmt::format("{} is \"{}\"", key, word), fmt::format("expected {}", fmt::join(known, ", ")),
         near ? fmt::format("Did you mean \"{}\"?", *near) : "");
}

void StudyProblems::refuse_again(std::string_view table, std::size_t index, const std::string& name) {
  refuse(table, index, "name", fmt::format("name \"{}\" is given twice", name), "names must be unique");
}

void StudyProblems::check_site_name(std::string_view table, std::size_t index, std::string_view key,
                                    const std::string& name, const StudyFile& study) {
  std::vector<std::string_view> known;
  for (const GivenSite& site : study.sites) known.push_back(site.name);
  if (std::ranges::find(known, name) != known.end()) return;
  const auto near = nearest(name, known);
  refuse(table, index, key, fmt::format("there is no site \"{}\"", name), "",
         near ? fmt::format("Did you mean \"{}\"?", *near) : "");
}

void StudyProblems::check_parameters(const StudyFile& study) {
  constexpr const char* table = parameter_key;
  for (std::size_t k = 0; k < study.parameters.size(); ++k) {
    const GivenParameter& each = study.parameters[k];
    for (const std::string& site : each.sites) check_site_name(table, k, "sites", site, study);
    if (each.range.empty() && !each.prior && !is_refused(table, k, "range") && !is_refused(table, k, "prior")) {
      refuse(table, k, "", "range or prior is missing", "a parameter varies within what is known of it",
             "Write range = [least, greatest]");
    }
    if (!each.range.empty() && each.range.size() != 2) {
      refuse(table, k, "range", fmt::format("range has {}", project::counted(each.range.size(), "number", "numbers")),
             "expected [least, greatest]");
    } else if (each.range.size() == 2 && !(each.range[0] < each.range[1])) {
      refuse(table, k, "range", fmt::format("range is [{:g}, {:g}]", each.range[0], each.range[1]),
             "expected [least, greatest]", each.range[0] > each.range[1] ? "Exchange the two" : "");
    }
    if (each.prior && each.prior->kind == DistributionKind::none) {
      refuse(table, k, "prior", "prior is a single value", "it would not vary",
             "Add distribution = \"normal\" and std_dev, or write range = [least, greatest]");
    }
    for (std::size_t other = 0; other < k; ++other) {
      const GivenParameter& before = study.parameters[other];
      if (each.path.empty() || each.path != before.path || !overlap(each, before)) continue;
      refuse(table, k, "path", fmt::format("path \"{}\" is given twice", each.path), "a parameter has one prior");
    }
  }
}

std::optional<Problem> lacking_file(const StudyFile& study, const std::filesystem::path& file, std::string_view key,
                                    int line, std::string where) {
  std::error_code error;
  const std::filesystem::path place = study.file.parent_path() / file;
  if (file.empty() || place.string().starts_with("/vsi") || std::filesystem::exists(place, error) || error)
    return std::nullopt;
  return Problem{.file = study.file.string(),
                 .line = line,
                 .where = std::move(where),
                 .what = fmt::format("{} is \"{}\"", key, file.string()),
                 .why = "there is no such file",
                 .hint = "Paths are relative to the study file"};
}

Problems lacking_projects(const StudyFile& study) {
  Problems problems;
  for (const GivenSite& site : study.sites) {
    if (auto lacking = lacking_file(study, site.project, "project", site.line, fmt::format("site \"{}\"", site.name)))
      problems.add(std::move(*lacking));
  }
  return problems;
}

Problems read_study_text(std::string_view text, const std::filesystem::path& file, StudyFile& study,
                         const StudyReader& reader) {
  Problems problems;
  const project::Document document(text, file.string());
  const bool is_calibration = std::ranges::count(reader.tables, "observations", &project::Table::key) > 0;
  expect_kind(document, is_calibration ? project::TomlKind::calibration : project::TomlKind::sensitivity);
  study.file = file;
  project::ValueReader values(document, problems, reader.tables);
  for (const project::Table& table : reader.tables) {
    const auto row = [&](int line) {
      if (table.key == site_key) return added_row(study.sites, line);
      if (table.key == parameter_key) return added_row(study.parameters, line);
      return reader.row(table.key, line);
    };
    project::read_table(table, document, values, row, "a study", problems);
  }
  if (study.name.empty()) study.name = as_utf8(file.stem().string());
  for (std::size_t k = 0; k < study.sites.size(); ++k) {
    if (study.sites[k].name.empty()) study.sites[k].name = fmt::format("site {}", k + 1);
  }
  StudyProblems across(document, values.refused(), problems);
  across.check_names(site_key, study.sites);
  across.check_parameters(study);
  reader.check(across);
  problems = problems.in_order_of(document.file());
  if (problems.has_errors()) throw BadInput(std::move(problems));
  return problems;
}

}  // namespace talus::study
