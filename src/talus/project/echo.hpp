#pragma once
// A project written back: as JSON with every default filled in, for summary.json.

#include <nlohmann/json.hpp>
#include <optional>

#include "talus/project/project.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

/// The whole project in the form of its file. Optional settings that are not set are left out; an infinite number,
/// which JSON does not have, is the text "inf". Numbers come back bit for bit.
[[nodiscard]] nlohmann::ordered_json echo(const Project& project);

/// The value of one member, or nothing where it is not set. In 2D, positions have no y.
[[nodiscard]] std::optional<nlohmann::ordered_json> written(const Slot& slot, bool two_dimensional);

/// What a setting is where the file does not have its key, or nothing where `Setting::without_it` has to say it.
[[nodiscard]] std::optional<nlohmann::ordered_json> default_of(const Table& table, const Setting& setting);

}  // namespace talus::project
