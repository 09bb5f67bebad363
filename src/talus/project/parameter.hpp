#pragma once
// The numbers of a project that a study varies. A number is named by its path, as `--set` takes it
// (`material.Scree.normal_restitution`); `*` stands for all entries of a list (`material.*.roughness_deg`). Its meaning
// and its range come from the declaration of the settings.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"
#include "talus/project/settings.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::project {

/// What is known of a number before any observation: a distribution, truncated to what the number may be.
class Prior {
 public:
  Prior() = default;
  /// Expects a distribution that `why_unusable` accepts and that is not a constant.
  Prior(const Distribution& distribution, Bounds legal);
  /// Every value from `least` to `most` is equally probable.
  [[nodiscard]] static Prior uniform(double least, double most);

  /// The value below which lies the share u of the probability, u from 0 to 1. Increases with u.
  [[nodiscard]] double value(double u) const;
  /// The share below a value: the inverse of `value`, accurate to 1e-12.
  [[nodiscard]] double share_below(double value) const;
  /// The value that a study without observations would take: the median.
  [[nodiscard]] double middle() const { return value(0.5); }
  [[nodiscard]] const Distribution& distribution() const { return distribution_; }
  /// For tables: "0.2 to 0.6", "normal, mean 0.4, std_dev 0.1".
  [[nodiscard]] std::string text() const;

 private:
  Distribution distribution_;
  Sampler sampler_;
};

/// Whether a setting, by its path, is no part of a model, or one that set_properties() (model/model.hpp) takes from the
/// project's numbers and words: a model on the same terrain, with the same places, can get another value. False for
/// what is no setting.
[[nodiscard]] bool needs_no_terrain(std::string_view path);

/// A number of a project, found by its path.
class SettingNumber {
 public:
  /// Finds the number. If there is none, or if the project would have to be built anew for each value, adds the error
  /// to `problems`, of which `about` has the place, and returns nullopt. Adds a warning if the number has no effect
  /// in this project.
  [[nodiscard]] static std::optional<SettingNumber> find(const Project& project, std::string_view path,
                                                         const Problem& about, Problems& problems);

  /// Sets the number in this project or a copy of it. Returns why the result is not usable, for example a mean that
  /// leaves nothing of a truncated distribution; the number is then not set.
  [[nodiscard]] std::optional<std::string> set(Project& project, double value) const;
  /// Of the first entry, if there are several.
  [[nodiscard]] double value_in(const Project& project) const;

  /// The distribution of which it is the mean, of the first entry; nullopt if it is another number.
  [[nodiscard]] std::optional<Distribution> distribution_in(const Project& project) const;
  /// Whether both set one number: `*` and a name may stand for the same entry.
  [[nodiscard]] bool shares_a_number_with(const SettingNumber& other) const;

  /// The settings by which another project gets the value that this one has, as `--set` takes them.
  [[nodiscard]] std::vector<std::string> overrides(const Project& project) const;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& unit() const { return unit_; }
  /// What its setting may be.
  [[nodiscard]] const Range& range() const { return range_; }
  /// Draws of it, or of the property of which it is the mean, are within these.
  [[nodiscard]] Bounds bounds() const { return project::bounds(range_); }

 private:
  enum class Part { whole, std_dev, rel_min, rel_max };

  std::string path_, unit_;
  const Table* table_ = nullptr;
  const Setting* setting_ = nullptr;
  std::vector<std::size_t> rows_;  // of the table
  Part part_ = Part::whole;
  Range range_;
};

}  // namespace talus::project
