#pragma once
// files.json: the files that a run wrote to its folder, so that lost, truncated or changed ones are detected.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace talus {

inline constexpr const char* file_record_name = "files.json";

/// Records the size and checksum of each file (XXH3, 128 bits, as printed by `xxhsum -H2`); of a GeoPackage, which
/// programs modify when they read it, only the size. Names are relative to the folder; a file still named `NAME.part`
/// is recorded under its final name. Throws BadInput if a file cannot be read or the record cannot be written.
void write_file_record(const std::filesystem::path& folder, std::span<const std::string> names);

/// The first file that is not as recorded, or the record itself if there is none. nullopt if all files are as recorded.
[[nodiscard]] std::optional<std::string> changed_file(const std::filesystem::path& folder);

/// The names in the record that are in the folder; none if no record can be read.
[[nodiscard]] std::vector<std::string> recorded_files(const std::filesystem::path& folder);

/// Removes the recorded files that are not in `kept`: results of an earlier run that the present one does not write.
/// Removes only regular files, and none through a link to another folder; the record itself stays.
void remove_recorded_files_but(const std::filesystem::path& folder, std::span<const std::string> kept);

/// Updates one file in the record, if it is recorded.
void renew_in_record(const std::filesystem::path& folder, const std::string& name);

}  // namespace talus
