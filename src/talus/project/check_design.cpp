#include "talus/project/check_design.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "talus/core/nearest.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/values.hpp"
#include "talus/results/design_plan.hpp"

namespace talus::project {

void DesignRules::check() const {
  if (barriers.empty() && collectors.empty() && !asks_a_line) {
    report(&row, "there is no line to design for", "the project has no barrier and no collector",
           "Add a [[collector]] with a line and a height_m", Severity::error);
    return;
  }
  check_lines();
  check_sections();
  check_lists();
  check_standard();
  check_factors();
  check_pairs();
  check_barriers_before_protected_line();
}

std::optional<std::vector<std::string>> DesignRules::names() const {
  std::vector<std::string> list;
  for (const auto& [kind, rows] : {std::pair("barrier", &barriers), std::pair("collector", &collectors)}) {
    for (std::size_t i = 0; i < rows->size(); ++i) {
      const toml::table* each = (*rows)[i];
      const toml::node* name = accepted(each, "name");
      if (each == nullptr || (each->contains("name") && name == nullptr)) return std::nullopt;
      list.push_back(name != nullptr ? *name->value<std::string>() : fmt::format("{} {}", kind, i + 1));
    }
  }
  return list;
}

void DesignRules::check_lines() const {
  const auto known = names();
  if (!known) return;
  if (const auto* lines = accepted(&row, "lines")) {
    if (design.lines.empty()) {
      report(lines, "lines is empty", "without a line there is nothing to design for",
             "Leave it out to take all barriers and collectors", Severity::error);
    }
    for (std::size_t i = 0; i < design.lines.size(); ++i) {
      const toml::node& node = *lines->as_array()->get(i);
      const std::string key = fmt::format("lines[{}]", i);
      check_name(node, key, design.lines[i], *known);
      if (std::find(design.lines.begin(), design.lines.begin() + static_cast<std::ptrdiff_t>(i), design.lines[i]) !=
          design.lines.begin() + static_cast<std::ptrdiff_t>(i)) {
        report(&node, fmt::format("{} is {}", key, quoted(node)), "it is listed twice", "Leave it out",
               Severity::error);
      }
    }
  }
  if (const auto* protect = accepted(&row, "protect")) check_name(*protect, "protect", design.protect, *known);
}

void DesignRules::check_name(const toml::node& node, const std::string& key, const std::string& name,
                             const std::vector<std::string>& known) const {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  std::string list;
  for (const std::string& each : known) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", each);
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const auto near = nearest(name, candidates);
  report(&node, fmt::format("{} is {}", key, quoted(node)),
         fmt::format("no barrier or collector has this name; the project has {}", list),
         near ? fmt::format("Did you mean \"{}\"?", *near) : "", Severity::error);
}

void DesignRules::check_sections() const {
  const auto* node = accepted(&row, "section_m");
  if (is_2d == true) return;
  for (const Barrier& barrier : project.barriers) {
    const bool is_candidate =
        design.lines.empty() || std::find(design.lines.begin(), design.lines.end(), barrier.name) != design.lines.end();
    if (!is_candidate) continue;
    double length = 0;
    for (std::size_t k = 1; k < barrier.line.size(); ++k) {
      length += std::hypot(barrier.line[k][0] - barrier.line[k - 1][0], barrier.line[k][1] - barrier.line[k - 1][1]);
    }
    if (length <= design.section_m * DesignPlan::most_sections) continue;
    report(node ? node : &row, fmt::format("section_m is {}", number_text(design.section_m)),
           fmt::format("line \"{}\", {:.0f} m long, would have more than {} sections", barrier.name, length,
                       DesignPlan::most_sections),
           fmt::format("Write {} or more", number_text(std::ceil(length / DesignPlan::most_sections))),
           Severity::error);
    return;
  }
}

void DesignRules::check_lists() const {
  for (const auto& [key, list] :
       {std::pair("heights_m", &design.heights_m), std::pair("energies_kJ", &design.energies_kJ)}) {
    const auto* node = accepted(&row, key);
    if (node && list->empty()) {
      report(node, fmt::format("{} is empty", key), "there would be no kit to choose from", "Leave it out",
             Severity::error);
    }
  }
  if (const auto* node = accepted(&row, "percentiles")) {
    for (const std::size_t i : repeated(design.percentiles)) {
      report(node->as_array()->get(i), fmt::format("percentiles[{}] is {}", i, number_text(design.percentiles[i])),
             "it is listed twice", "Leave it out", Severity::error);
    }
  }
}

void DesignRules::check_standard() const {
  const auto lacks_service_level = [](double energy_kJ) { return energy_kJ * 1000 < least_energy_with_service; };
  if (const auto* energies = accepted(&row, "energies_kJ");
      energies && design.standard != DesignStandard::none && design.energy_level == DesignLevel::sel &&
      !design.energies_kJ.empty() && std::ranges::all_of(design.energies_kJ, lacks_service_level)) {
    report(energies, fmt::format("energies_kJ has no value of {:.0f} kJ or more", least_energy_with_service / 1000),
           "energy_level is \"SEL\", and kits of class 0 are not tested at that level", "", Severity::error);
  }
}

void DesignRules::check_factors() const {
  const auto* file = accepted(&row, "standard_file");
  if (row.contains("standard_file") && file == nullptr) return;
  if (file != nullptr) {
    if (const std::string why = why_unreadable(project, design.standard_file); !why.empty()) {
      report(file, fmt::format("standard_file is {}", quoted(*file)), why, "The path is relative to the project file",
             Severity::error);
      return;
    }
    std::error_code none;
    if (!std::filesystem::exists(project.file, none)) return;  // a text without a folder
  }
  try {
    const auto set = factor_set_of(project);
    if (set) check_factors(*set);
    check_kits(set ? &*set : nullptr);
  } catch (const BadInput& bad) {
    report_of_file(bad.problems());
  }
}

void DesignRules::check_factors(const FactorSet& set) const {
  std::vector<std::string> names;
  for (const Factor& factor : set.factors) names.push_back(fmt::format("{} ({})", factor.key, factor.symbol));
  for (const std::string_view key : factor_keys) {
    const auto* given = accepted(&row, key);
    if (given == nullptr || set.find(key) != nullptr) continue;
    report(given, fmt::format("{} has no effect", key),
           fmt::format("{} has no such factor; it has {}", set.name, fmt::join(names, ", ")), "", Severity::warning);
  }
  const auto require = [&](std::string_view key, std::string_view symbol, const std::string& not_read) {
    if (row.contains(key)) return;  // given, or refused
    report(&row, fmt::format("{} is missing", key),
           fmt::format("{} needs {}, and has no value for it: {}", set.name, symbol,
                       not_read.empty() ? "it is an input" : not_read),
           "Take it from the edition that binds you", Severity::error);
  };
  if (!set.design_percentile) require("design_percentile", "it", "the 95th or the 99th are used");
  for (const Factor& factor : set.factors) {
    if (!factor.value && !factor.multiplies_only("elongation")) require(factor.key, factor.symbol, factor.not_read);
  }
}

void DesignRules::check_barriers_before_protected_line() const {
  const auto* protect = accepted(&row, "protect");
  if (!protect || barriers.empty()) return;
  report(protect, "protect is given, and there are barriers",
         "rocks that a [[barrier]] stops never reach the protected line and are not counted",
         "Make the candidates [[collector]]s", Severity::warning);
}

}  // namespace talus::project
