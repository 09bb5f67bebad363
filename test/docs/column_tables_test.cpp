// The lists of columns in the documentation and in the page's sources are those that the tables are written with.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/places.hpp"
#include "talus/archive/column_reference.hpp"
#include "talus/archive/design_tables.hpp"
#include "talus/archive/envelope_table.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/archive/uncertainty_table.hpp"
#include "talus/export/geopackage_rows.hpp"
#include "talus/lines/what_if_output.hpp"
#include "talus/maps/source_maps.hpp"
#include "talus/model/release_columns.hpp"
#include "talus/sensitivity/output.hpp"

namespace talus {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  EXPECT_TRUE(stream) << file;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void expect_fresh(const std::string& name, const std::string& made) {
  const std::string file = talus::places::in_source(name);
  if (std::getenv("TALUS_RENEW_REFERENCE") != nullptr) std::ofstream(file) << made;
  EXPECT_TRUE(text_of(file) == made) << name
                                     << " differs from the declared columns; run this test with "
                                        "TALUS_RENEW_REFERENCE=1";
}

using Tables = std::map<std::string, std::vector<ColumnText>>;

const Tables& tables() {
  static const Tables tables{{"endpoints.csv", column_texts<EndpointRow>()},
                             {"paths.csv", column_texts<PathEventRow>()},
                             {"barriers.csv", column_texts<HitRow>()},
                             {"envelopes.csv", column_texts<EnvelopeRow>()},
                             {"design.csv", column_texts<DesignRow>()},
                             {"design_ranking.csv", column_texts<RankingRow>()},
                             {"design_pairs.csv", column_texts<PairRow>()},
                             {"sensitivity.csv", column_texts<sensitivity::EffectRow>()},
                             {"what_if.csv", column_texts<what_if::WhatIfRow>()},
                             {"uncertainty.csv", column_texts<UncertaintyRow>()},
                             {"sources.csv", column_texts<SourceRow>()},
                             {"releases", project::release_column_texts()},
                             {"layer paths", column_texts<RockLayerRow>()},
                             {"layer barriers", column_texts<BarrierLayerRow>()},
                             {"impacts.csv", column_texts<ImpactRow>()},
                             {"layer design", column_texts<DesignLayerRow>()}};
  return tables;
}

/// The page with each list of columns, between its marks, made again; `seen` are the tables that it lists.
std::string with_tables(const std::string& page, std::set<std::string>& seen) {
  static const std::regex mark("<!-- columns of ([^>]*), from their declaration -->\n");
  static const std::string end_mark = "<!-- end of columns -->\n";
  std::string made;
  std::size_t at = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), mark), none; found != none; ++found) {
    const std::string name = (*found)[1];
    const auto begin = static_cast<std::size_t>(found->position() + found->length());
    const std::size_t end = page.find(end_mark, begin);
    if (!tables().contains(name) || end == std::string::npos) {
      ADD_FAILURE() << "no such table, or no end: " << name;
      return page;
    }
    seen.insert(name);
    made += page.substr(at, begin - at) + "\n" + column_table(tables().at(name)) + "\n";
    at = end;
  }
  return made + page.substr(at);
}

TEST(ColumnTables, PageIsNotStale) {
  std::set<std::string> seen;
  for (const char* name : {"/docs/outputs.md", "/docs/barrier-design.md", "/docs/gis.md", "/docs/predictions.md",
                           "/docs/sensitivity.md", "/docs/ask-the-line.md"})
    expect_fresh(name, with_tables(text_of(talus::places::in_source(name)), seen));
  EXPECT_EQ(seen.size(), tables().size()) << "every table has its columns in the documentation";
}

TEST(ColumnsModule, IsNotStale) { expect_fresh("/web/src/generated/columns.ts", columns_module()); }

// The page finds the unit of a column by its name.
TEST(Columns, OfOneNameHaveOneUnit) {
  std::map<std::string, std::string> units;
  for (const auto& [table, columns] : tables()) {
    for (const auto& [name, unit, meaning, kind] : columns) {
      EXPECT_FALSE(meaning.empty()) << table << ": " << name;
      EXPECT_EQ(meaning.find('|'), std::string::npos) << table << ": " << name;
      EXPECT_EQ(units.emplace(name, unit).first->second, unit) << table << ": " << name;
    }
  }
}

TEST(Columns, ThatAreNoQuantitiesHaveNoUnit) {
  for (const auto& [table, columns] : tables()) {
    for (const auto& [name, unit, meaning, kind] : columns)
      EXPECT_TRUE(kind == ColumnKind::quantity || unit.empty()) << table << ": " << name;
  }
}

}  // namespace
}  // namespace talus
