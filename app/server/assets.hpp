#pragma once
// The page's files, and the examples, which are part of the program.

#include <string>
#include <string_view>
#include <vector>

namespace talus::server {

struct Asset {
  std::string_view path;   // relative to the page
  std::string_view type;   // as HTTP calls it
  std::string_view bytes;  // compressed by gzip
};

/// In the order of their paths.
[[nodiscard]] const std::vector<Asset>& page_assets();

struct ExampleFile {
  std::string_view path;  // FOLDER/NAME
  std::string_view bytes;
};

[[nodiscard]] const std::vector<ExampleFile>& example_files();

}  // namespace talus::server
