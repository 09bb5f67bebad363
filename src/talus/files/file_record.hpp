#pragma once
// files.json: which files a run left in its folder, so that one that was lost, cut or changed since is noticed.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace talus {

inline constexpr const char* file_record_name = "files.json";

/// Of each file its size and its checksum (XXH3, 128 bits, as `xxhsum -H2` gives it); of a GeoPackage, which programs
/// write to when they look into it, the size alone. Names are relative to the folder; a file that still has the name
/// `NAME.part` is recorded under its final one. Throws BadInput where one cannot be read, or the record not be written.
void write_file_record(const std::filesystem::path& folder, std::span<const std::string> names);

/// The first file that is not as it was recorded; the record itself where there is none. Nothing where all are.
[[nodiscard]] std::optional<std::string> changed_file(const std::filesystem::path& folder);

/// The names in the record, of those that stay in the folder; none where there is no record that can be read.
[[nodiscard]] std::vector<std::string> recorded_files(const std::filesystem::path& folder);

/// Removes the files of the record that are not among those `kept`: results of an earlier run that the present one does
/// not make. Only plain files go, and none through a link to another folder; the record itself stays.
void remove_recorded_files_but(const std::filesystem::path& folder, std::span<const std::string> kept);

/// Records one file anew, where there is a record that has it.
void renew_in_record(const std::filesystem::path& folder, const std::string& name);

}  // namespace talus
