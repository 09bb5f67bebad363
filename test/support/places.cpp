#include "support/places.hpp"

namespace talus::places {

constinit const char* const source_dir = TALUS_SOURCE_DIR;
constinit const char* const binary_dir = TALUS_BINARY_DIR;
constinit const char* const program = TALUS_PROGRAM;

}  // namespace talus::places
