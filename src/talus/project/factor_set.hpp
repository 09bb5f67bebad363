#pragma once
// Sets of partial factors for the check of a barrier, as data: what each factor multiplies, its usual values, where
// they are from and what could not be read there. Those of standards/ are embedded in the program; a project may name a
// file of its own in the same form (`design.standard_file`).

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/project.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

/// What a factor can multiply: the velocity (and with its square the energy), the height and the mass (and with it the
/// energy) of the rocks, their energy, the energy that a kit needs for it, the kit's elongation.
inline constexpr std::array<std::string_view, 6> multiplied_quantities{"velocity", "height",   "mass",
                                                                       "energy",   "capacity", "elongation"};
/// The keys of [design] that give the value of the factor of the same key.
inline constexpr std::array<std::string_view, 9> factor_keys{
    "trajectory_factor", "topography_factor",    "volume_factor",        "density_factor",   "risk_factor",
    "energy_factor",     "action_energy_factor", "action_height_factor", "elongation_factor"};
[[nodiscard]] bool is_factor_key(std::string_view key);

/// Where values are from.
struct FactorSource {
  std::string key;      // by which factors refer to it
  std::string text;     // the publication
  std::string checked;  // what of it was read
  int line = 0;
};

struct Factor {
  std::string key;     // if it is one of factor_keys, the project may give the value
  std::string symbol;  // in the source
  std::vector<std::string> multiplies;
  std::optional<double> value;           // nullopt: the project must give it
  std::optional<double> value_with_sel;  // if the check is of the SEL; nullopt: the same
  std::string meaning;
  std::string usual;     // values
  std::string source;    // key
  std::string not_read;  // in the source
  int line = 0;

  [[nodiscard]] bool multiplies_only(std::string_view quantity) const {
    return multiplies.size() == 1 && multiplies.front() == quantity;
  }
};

struct FactorSet {
  std::string name, title;
  std::string not_read;                     // what could not be read of the whole
  std::optional<double> design_percentile;  // nullopt: the project must give it [%]
  double upper_clearance_m = 0;
  bool clears_half_the_block = false;
  std::string clearance_source;  // key
  std::string clearance_not_read;
  std::vector<FactorSource> sources;
  std::vector<Factor> factors;

  /// Null: there is none.
  [[nodiscard]] const Factor* find(std::string_view key) const;
  [[nodiscard]] const FactorSource* find_source(std::string_view key) const;
};

/// A file of standards/.
struct StandardFile {
  std::string_view path, text;
};
/// Sorted by path.
[[nodiscard]] const std::vector<StandardFile>& standard_files();

/// The embedded sets, in the order of their files.
[[nodiscard]] const std::vector<FactorSet>& factor_sets();

/// The tables of such a file and all their settings.
[[nodiscard]] const std::vector<Table>& factor_set_tables();

/// Reads a set. Throws BadInput with every problem found.
[[nodiscard]] FactorSet read_factor_set(const Document& document);

/// The set that a project is checked by; nullopt if it has no [design], or with `standard = "none"`. Throws BadInput if
/// its file cannot be read or is not such a set.
[[nodiscard]] std::optional<FactorSet> factor_set_of(const Project& project);
/// Of [design] in a project of this folder.
[[nodiscard]] std::optional<FactorSet> factor_set_of(const Design& design, const std::filesystem::path& folder);

/// The values of a factor in the project and in the set; nullopt: neither gives it.
[[nodiscard]] std::optional<double> value_of(const Factor& factor, const Design& design);

/// The rows of a set for the documentation: factors with symbol, values, source and what could not be read.
[[nodiscard]] std::string factor_table(const FactorSet& set);

}  // namespace talus::project
