#pragma once
// The variations of a what-if: numbers of a project that are changed together by a share, up and down, and other rock
// models.

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::what_if {

/// What a share is of: of a distribution its mean alone moves, or the whole of it is scaled.
enum class Moves { mean, whole };

struct FactorKind {
  std::string_view key;  // on the command line and in files
  std::string_view title;
  double usual_step;  // share of the value
  Moves moves;
};
/// In the order of tables. Sizes are steps of the mass: a diameter has its cube root.
inline constexpr std::array<FactorKind, 8> factor_kinds{{
    {"normal_restitution", "Normal restitution", 0.10, Moves::mean},
    {"tangential_restitution", "Tangential restitution", 0.10, Moves::mean},
    {"friction_angle", "Friction angle", 0.10, Moves::mean},
    {"dynamic_friction", "Dynamic friction", 0.10, Moves::mean},
    {"rolling_friction", "Rolling friction", 0.10, Moves::mean},
    {"roughness", "Roughness", 0.25, Moves::whole},
    {"forest_drag", "Forest drag", 0.25, Moves::whole},
    {"mass", "Rock mass", 0.25, Moves::whole},
}};

struct Step {
  std::string key;   // of a kind
  double share = 0;  // 0.1: plus and minus 10 %; in (0, 1)
};
/// Which factors, by how much.
struct FactorChoice {
  /// Nullopt: the usual ones of all factors that the project has. May be empty if there are models.
  std::optional<std::vector<Step>> steps{};
  std::string material{};  // of the ground's properties: of this material alone; empty: of all
  bool models = false;     // also the other rock models
};

/// One value that a variation changes.
struct Change {
  std::string table, key;  // of the project file
  std::size_t row = 0;     // of the table, from 0
  std::string name;        // of that row
  /// In the form of the file; nullopt: the key is not given. The project of the variation has `after`.
  std::optional<nlohmann::ordered_json> before, after;
};

struct Variation {
  std::optional<RockModel> model{};  // another rock model; the values stay as they are
  std::size_t kind = 0;              // of factor_kinds, without a model
  double factor = 1;                 // of the values, 1.1 or 0.9; of the mass for sizes
  project::Project project;
  std::vector<Change> changes;
  std::string clipped;  // which values ended at the limit of their range; empty: none
};

/// "normal_restitution", or "model"
[[nodiscard]] std::string_view key_of(const Variation& variation);
[[nodiscard]] std::string_view title_of(const Variation& variation);
/// By how much, without the digits of rounding: 10, -25; nullopt of a model.
[[nodiscard]] std::optional<double> percent_of(const Variation& variation);
/// "+10 %", or "rigid sphere"
[[nodiscard]] std::string step_text(const Variation& variation);
/// "Scree 0.35 to 0.385, Rock 0.5 to 0.55"; of a model "lumped mass to rigid body with the shape block"
[[nodiscard]] std::string changes_text(const Variation& variation);
/// The path of a changed setting, as --set takes it: "material.0.normal_restitution".
[[nodiscard]] std::string path_of(const Change& change);

/// The project with the values of a factor multiplied, clipped to their ranges. `material`: as in FactorChoice.
[[nodiscard]] Variation vary(const project::Project& project, std::size_t kind, double factor,
                             const std::string& material);

/// The factors that the project has, by their place in factor_kinds, in its order. `material`: as in FactorChoice.
/// Throws BadInput if there is no such material, which `where` names.
[[nodiscard]] std::vector<std::size_t> kinds_of(const project::Project& project, const std::string& material,
                                                std::string_view where);

/// The same variation of another project: what `vary` or the other rock model makes of it.
[[nodiscard]] project::Project applied(const Variation& variation, const project::Project& to,
                                       const std::string& material);

/// The other rock models, then for each factor the variation down and that up. `project`: with the samples of its
/// distributions. Throws BadInput with all problems of the choice, which `where` names: an unknown factor or material,
/// a step out of range, a factor that the project does not have. What a factor cannot change (sizes from a table), and
/// the materials whose friction in another model is the default, are added to `warnings`.
[[nodiscard]] std::vector<Variation> variations_of(const project::Project& project, const FactorChoice& choice,
                                                   std::string_view where, Problems& warnings);

}  // namespace talus::what_if
