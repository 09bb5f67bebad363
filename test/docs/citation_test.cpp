// CITATION.cff names this version and has the keys that CFF 1.2.0 requires.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "support/places.hpp"

namespace talus {
namespace {

using ::testing::Contains;
using ::testing::Key;

/// The keys of the file's top level with the rest of their lines.
std::map<std::string, std::string> citation() {
  std::ifstream in(talus::places::in_source("/CITATION.cff"));
  std::map<std::string, std::string> entries;
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    if (line.empty() || line.front() == ' ' || colon == std::string::npos) continue;
    const std::size_t value = line.find_first_not_of(' ', colon + 1);
    EXPECT_TRUE(entries.emplace(line.substr(0, colon), value == std::string::npos ? "" : line.substr(value)).second)
        << line << " is there twice";
  }
  return entries;
}

TEST(Citation, IsOfThisVersion) { EXPECT_EQ(citation()["version"], TALUS_VERSION); }

TEST(Citation, HasTheRequiredKeys) {
  auto entries = citation();
  EXPECT_EQ(entries["cff-version"], "1.2.0");
  EXPECT_EQ(entries["license"], "Apache-2.0");
  for (const char* key : {"message", "title", "authors"}) EXPECT_THAT(entries, Contains(Key(key)));
}

}  // namespace
}  // namespace talus
