#pragma once
// Where the tests find the repository and what was built. Their paths are compiled in one file only, so that other
// clones can take all other files of the tests from a common compiler cache.

#include <string>

namespace talus::places {

extern const char* const source_dir;  // of the repository
extern const char* const binary_dir;  // of the build
extern const char* const program;     // `talus`

/// A file of the repository, by its path from there (with a leading /).
inline std::string in_source(const std::string& file) { return source_dir + file; }

}  // namespace talus::places
