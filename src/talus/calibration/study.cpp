#include "talus/calibration/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

#include "talus/core/nearest.hpp"
#include "talus/core/utf8.hpp"
#include "talus/project/document.hpp"
#include "talus/project/read_table.hpp"

namespace talus::calibration {

namespace {

using project::Document;
using project::Row;
using project::RowElsewhere;

/// The row to read the next table into.
Row added(Study& study, std::string_view table, int line) {
  const auto with_line = [line](auto& list) {
    list.emplace_back().line = line;
    return Row(RowElsewhere(&list.back()));
  };
  if (table == "site") return with_line(study.sites);
  if (table == "observations") return with_line(study.observations);
  if (table == "parameter") return with_line(study.parameters);
  if (table == "model") return with_line(study.models);
  return RowElsewhere(&study);
}

/// The rules across several keys.
class StudyCheck {
 public:
  StudyCheck(Study& study, const Document& document, const std::unordered_set<const toml::node*>& refused,
             Problems& problems)
      : study_(study), document_(document), refused_(refused), problems_(problems) {}

  void check() {
    names("site", study_.sites);
    names("observations", study_.observations);
    names("model", study_.models);
    for (std::size_t k = 0; k < study_.observations.size(); ++k) check_observations(k);
    for (std::size_t k = 0; k < study_.parameters.size(); ++k) check_parameter(k);
    if (study_.folds == 1) {
      refuse("", 0, "folds", "folds is 1", "nothing would be left to learn from", "Use 0 for none, or 2 or more");
    }
    if (study_.hold_out_sites && study_.sites.size() < 2) {
      refuse("", 0, "hold_out_sites", "hold_out_sites is true", "the study has only one site", "");
    }
    if (study_.models.size() == 1) {
      refuse("model", 0, "", "there is only one [[model]]", "models are compared with each other",
             "Add another, or give its settings to the sites");
    }
    if (study_.models.size() > 1 && study_.folds == 0 && !study_.hold_out_sites) {
      refuse("model", 0, "", "models are compared by what they predict", "the study has no folds", "Write folds = 5");
    }
  }

 private:
  const toml::table* row(std::string_view table, std::size_t index) const {
    if (table.empty()) return &document_.root();
    const toml::array* list = document_.root()[table].as_array();
    return list != nullptr && index < list->size() ? list->get(index)->as_table() : nullptr;
  }
  bool is_refused(std::string_view table, std::size_t index, std::string_view key) const {
    const toml::table* from = row(table, index);
    return from != nullptr && from->contains(key) && refused_.contains(from->get(key));
  }
  void refuse(std::string_view table, std::size_t index, std::string_view key, std::string what, std::string why,
              std::string hint) {
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

  template <class Item>
  void names(std::string_view table, const std::vector<Item>& items) {
    std::set<std::string> before;
    for (std::size_t k = 0; k < items.size(); ++k) {
      if (items[k].name.empty() || before.insert(items[k].name).second) continue;
      refuse(table, k, "name", fmt::format("name \"{}\" is given twice", items[k].name), "names must be unique", "");
    }
  }

  void check_site_name(std::string_view table, std::size_t index, std::string_view key, const std::string& name) {
    std::vector<std::string_view> known;
    for (const StudySite& site : study_.sites) known.push_back(site.name);
    if (std::ranges::find(known, name) != known.end()) return;
    const auto near = nearest(name, known);
    refuse(table, index, key, fmt::format("there is no site \"{}\"", name), "",
           near ? fmt::format("Did you mean \"{}\"?", *near) : "");
  }

  void check_observations(std::size_t k) {
    constexpr const char* table = "observations";
    StudyObservations& each = study_.observations[k];
    if (each.site.empty() && study_.sites.size() == 1) each.site = study_.sites.front().name;
    if (each.site.empty() && !study_.sites.empty()) {
      refuse(table, k, "site", "site is missing", "the study has several sites", "");
    } else if (!each.site.empty()) {
      check_site_name(table, k, "site", each.site);
    }
    const bool has_file = !each.file().empty();
    if (!has_file && !is_refused(table, k, "stops") && !is_refused(table, k, "marks") &&
        !is_refused(table, k, "values") && !is_refused(table, k, "zones")) {
      refuse(table, k, "", "stops, marks, values or zones is missing", "observations come from a file",
             "Write stops = \"stops.csv\"");
    }
    if (!each.values.empty() && each.at.empty() && !is_refused(table, k, "at")) {
      refuse(table, k, "values", "at is missing", "values are observed at a collector or barrier of the project", "");
    }
    if (each.values.empty() && has_file && !each.at.empty()) {
      refuse(table, k, "at", "at is given without values", "only values have a line", "Leave it out");
    }
    for (const char* key : {"released", "blocks", "relative_accuracy"}) {
      const toml::table* from = row(table, k);
      if (!each.zones.empty() || !has_file || from == nullptr || !from->contains(key)) continue;
      refuse(table, k, key, fmt::format("{} is given without zones", key), "only deposits by zone have it",
             "Leave it out");
    }
    if (each.name.empty()) each.name = as_utf8(each.file().stem().string());
  }

  void check_parameter(std::size_t k) {
    constexpr const char* table = "parameter";
    const StudyParameter& each = study_.parameters[k];
    for (const std::string& site : each.sites) check_site_name(table, k, "sites", site);
    const bool was_refused = is_refused(table, k, "range") || is_refused(table, k, "prior");
    if (each.range.empty() && !each.prior && !was_refused) {
      refuse(table, k, "", "range or prior is missing", "a parameter is sought within what is known of it",
             "Write range = [least, greatest]");
    }
    if (!each.range.empty() && each.range.size() != 2) {
      refuse(table, k, "range", fmt::format("range has {} numbers", each.range.size()), "expected [least, greatest]",
             "");
    } else if (each.range.size() == 2 && !(each.range[0] < each.range[1])) {
      refuse(table, k, "range", fmt::format("range is [{:g}, {:g}]", each.range[0], each.range[1]),
             "expected [least, greatest]", each.range[0] > each.range[1] ? "Exchange the two" : "");
    }
    if (each.prior && each.prior->kind == DistributionKind::none) {
      refuse(table, k, "prior", "prior is a single value", "there would be nothing to seek",
             "Add distribution = \"normal\" and std_dev, or write range = [least, greatest]");
    }
    for (std::size_t other = 0; other < k; ++other) {
      const StudyParameter& before = study_.parameters[other];
      const auto is_shared = [&](const std::string& site) { return std::ranges::count(before.sites, site) > 0; };
      const bool overlaps = each.sites.empty() || before.sites.empty() || std::ranges::any_of(each.sites, is_shared);
      if (each.path.empty() || each.path != before.path || !overlaps) continue;
      refuse(table, k, "path", fmt::format("path \"{}\" is given twice", each.path), "a parameter is sought once", "");
    }
  }

  Study& study_;
  const Document& document_;
  const std::unordered_set<const toml::node*>& refused_;
  Problems& problems_;
};

}  // namespace

StudyReading read_study_text(std::string_view text, const std::filesystem::path& file) {
  Problems problems;
  const Document document(text, file.string());
  StudyReading reading;
  Study& study = reading.study;
  study.file = file;
  project::ValueReader reader(document, problems, study_tables());
  for (const project::Table& table : study_tables()) {
    project::read_table(
        table, document, reader, [&](int line) { return added(study, table.key, line); }, "a study", problems);
  }
  if (study.name.empty()) study.name = as_utf8(file.stem().string());
  for (std::size_t k = 0; k < study.sites.size(); ++k) {
    if (study.sites[k].name.empty()) study.sites[k].name = fmt::format("site {}", k + 1);
  }
  StudyCheck(study, document, reader.refused(), problems).check();
  study.named_files = reader.named_files();
  problems = problems.in_order_of(document.file());
  if (problems.has_errors()) throw BadInput(std::move(problems));
  reading.warnings = std::move(problems);
  return reading;
}

StudyReading read_study(const std::filesystem::path& file) {
  return read_study_text(project::text_of_file(file), file);
}

}  // namespace talus::calibration
