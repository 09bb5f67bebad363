#pragma once
// The contents of a run's folder for display: the whole summary, and as much of the tables as a page can show. Tables
// are streamed: a folder of any size takes the same memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/convergence.hpp"
#include "talus/archive/report_envelopes.hpp"
#include "talus/archive/report_maps.hpp"
#include "talus/archive/run_summary.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/archive/uncertainty.hpp"

namespace talus {

/// Limits of what is kept of a run. Rocks are sampled by spread_sample.hpp, the same ones each time.
struct Limits {
  std::size_t paths = 300;
  std::size_t path_rows = 40'000;  // of all kept paths together
  std::size_t endpoints = 2'000;
  std::size_t hits = 2'000;  // of all barriers together
};

struct Path {
  std::uint64_t rock = 0;
  std::vector<PathEventRow> rows{};  // without spin
};

/// Energy lost at the k-th impact on the ground, over all rocks in paths.csv with that many.
struct ImpactLoss {
  std::uint64_t count = 0;
  double sum_J = 0, least_J = 0, most_J = 0;
};

/// The kept items of a table, and the total number of such items.
template <class Item>
struct Kept {
  bool has_file = false;
  std::uint64_t total = 0;    // rocks with a path, end points or hits in the file
  std::vector<Item> items{};  // in the order of rock numbers
};

struct RunFolder {
  std::filesystem::path folder;
  RunSummary summary{};  // with the barriers with the most hits, and without long lists in the project
  std::string date{};    // of the file (UTC)
  Kept<EndpointRow> endpoints{};
  Kept<Path> paths{};
  Kept<HitRow> hits{};
  std::vector<ImpactLoss> impact_losses{};  // [0]: first impact; the first hundred are kept
  std::vector<ReportMap> maps{};
  ReportEnvelopes envelopes{};
  Convergence convergence{};
  Uncertainty uncertainty{};
  std::vector<std::string> notes{};  // on missing parts, for the reader of the page
};

/// Reads a run's folder; its summary may have another name while it is being made. A missing table is a note. A missing
/// summary, or a damaged file, is BadInput with one problem for each such file.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& folder, const Limits& limits = {},
                                        const char* summary = "summary.json");

}  // namespace talus
