#pragma once
// A project as JSON with every default filled in, for summary.json.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "talus/project/project.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

/// The whole project in the form of its file. Optional settings that are not set are omitted. Infinity, which JSON
/// lacks, is the string "inf". Numbers are preserved bit for bit.
[[nodiscard]] nlohmann::ordered_json echo(const Project& project);

/// An echo without [report] and [[layer]], which change no result.
[[nodiscard]] nlohmann::ordered_json without_presentation(const nlohmann::ordered_json& echo);

/// An echoed project as the text of a file, which reads back as the same project.
[[nodiscard]] std::string text_of_echo(const nlohmann::ordered_json& echoed);

/// The value of one member; nullopt if it is not set. In 2D, positions have no y.
[[nodiscard]] std::optional<nlohmann::ordered_json> written(const Slot& slot, bool two_dimensional);

/// The value of a setting without its key; nullopt if it has no fixed default (see `Setting::without_it`).
/// The default with a set of laws.
[[nodiscard]] std::optional<nlohmann::ordered_json> default_of(const Table& table, const Setting& setting,
                                                               LawSet laws = LawSet::talus);

}  // namespace talus::project
