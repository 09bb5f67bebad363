#pragma once
// What a run left in its folder, read for showing: the summary whole, and of the tables as much as a page can hold.
// Tables are streamed, so a folder of any size takes the same memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/report_envelopes.hpp"
#include "talus/archive/report_maps.hpp"
#include "talus/archive/run_summary.hpp"
#include "talus/archive/table_columns.hpp"

namespace talus {

/// How much of a run is kept. Rocks are chosen by the sampling rule of spread_sample.hpp, the same for the same run.
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

/// Energy lost at the k-th impact on the ground, over all rocks in paths.csv that got that far.
struct ImpactLoss {
  std::uint64_t count = 0;
  double sum_J = 0, least_J = 0, most_J = 0;
};

/// A table's kept part and how many there were of its kind.
template <class Item>
struct Kept {
  bool has_file = false;
  std::uint64_t total = 0;    // rocks with a path, end points or hits in the file
  std::vector<Item> items{};  // in the order of rock numbers
};

struct RunFolder {
  std::filesystem::path folder;
  RunSummary summary{};  // of barriers those with the most hits; of the project no long lists
  std::string date{};    // when its file was written (UTC)
  Kept<EndpointRow> endpoints{};
  Kept<Path> paths{};
  Kept<HitRow> hits{};
  std::vector<ImpactLoss> impact_losses{};  // [0]: first impact; the first hundred are kept
  std::vector<ReportMap> maps{};
  ReportEnvelopes envelopes{};
  std::vector<std::string> notes{};  // what is not there, for the reader of the page
};

/// Reads a run's folder, whose summary may have another name while it is made. A missing table is a note; a summary
/// that is missing, or any file that is not what it should be, is BadInput, with one problem for each such file.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& folder, const Limits& limits = {},
                                        const char* summary = "summary.json");

}  // namespace talus
