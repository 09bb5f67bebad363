#pragma once
// Files embedded in the program: those of the page, and the examples.

#include <string>
#include <string_view>
#include <vector>

namespace talus::server {

struct Asset {
  std::string_view path;   // relative to the page
  std::string_view type;   // Content-Type
  std::string_view bytes;  // compressed by gzip
};

/// Sorted by path.
[[nodiscard]] const std::vector<Asset>& page_assets();

struct ExampleFile {
  std::string_view path;  // FOLDER/NAME
  std::string_view bytes;
};

[[nodiscard]] const std::vector<ExampleFile>& example_files();

}  // namespace talus::server
