// The tables of factors in docs/barrier-design.md are those that the program applies.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "support/places.hpp"
#include "talus/project/factor_set.hpp"

namespace talus::project {
namespace {

TEST(FactorTables, PageIsNotStale) {
  const std::string file = talus::places::in_source("/docs/barrier-design.md");
  std::ifstream in(file);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  std::string made = page;
  for (const FactorSet& set : factor_sets()) {
    const std::string mark = "<!-- factors of " + set.name + ", from their declaration -->\n";
    const std::string end_mark = "<!-- end of factors -->\n";
    const std::size_t begin = made.find(mark);
    ASSERT_NE(begin, std::string::npos) << set.name;
    const std::size_t from = begin + mark.size(), end = made.find(end_mark, from);
    ASSERT_NE(end, std::string::npos) << set.name;
    made = made.substr(0, from) + "\n" + factor_table(set) + "\n" + made.substr(end);
  }
  if (std::getenv("TALUS_RENEW_REFERENCE") != nullptr) std::ofstream(file) << made;
  EXPECT_TRUE(page == made) << "docs/barrier-design.md differs from the sets of factors; run this test with "
                               "TALUS_RENEW_REFERENCE=1";
}

}  // namespace
}  // namespace talus::project
