#pragma once
// Files that a command may replace.

#include <filesystem>
#include <string_view>

namespace talus::cli {

/// Throws BadInput where a file is there that does not begin as what a command writes: it is not an earlier output of
/// it, and may be anything, even a table of the run that was asked for. `kind` says what is replaced: "page".
void refuse_other_files(const std::filesystem::path& file, std::string_view beginning, std::string_view kind);

}  // namespace talus::cli
