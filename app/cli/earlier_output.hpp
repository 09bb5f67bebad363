#pragma once
// Files that a command may replace.

#include <filesystem>
#include <string_view>

namespace talus::cli {

/// Throws BadInput if `file` exists and does not start with `beginning`, the start of every output of the command: then
/// it is not an earlier output, and could be anything, even a table of the run. `kind` names the output: "page".
void refuse_other_files(const std::filesystem::path& file, std::string_view beginning, std::string_view kind);

}  // namespace talus::cli
