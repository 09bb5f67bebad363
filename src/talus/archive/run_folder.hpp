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
#include "talus/rocks/motion.hpp"

namespace talus::io {

/// How much of a run is kept. Rocks are chosen by the sampling rule of spread_sample.hpp, the same for the same run.
struct Limits {
  std::size_t paths = 300;
  std::size_t path_rows = 40'000;  // of all kept paths together
  std::size_t endpoints = 2'000;
  std::size_t hits = 2'000;  // of all barriers together
};

struct EndPoint {
  std::uint64_t rock = 0;
  std::string seeder{}, end_reason{};
  std::array<double, 3> position_m{};
  double runout_xy_m = 0, runout_total_m = 0, time_s = 0;
  double max_ke_J = 0, max_bounce_m = 0;
};

struct PathRow {
  std::uint64_t event = 0;
  PathState state = PathState::projectile;
  double time_s = 0;
  std::array<double, 3> position_m{}, velocity_m_s{};
  double ke_translational_J = 0, ke_rotational_J = 0, pe_J = 0;
  [[nodiscard]] double total_J() const { return ke_translational_J + ke_rotational_J + pe_J; }
};

struct Path {
  std::uint64_t rock = 0;
  std::vector<PathRow> rows{};
};

struct BarrierHit {
  std::string barrier{}, outcome{};
  std::uint64_t rock = 0;
  double time_s = 0;
  std::array<double, 3> position_m{};
  double impact_height_m = 0, angle_deg = 0;
  double ke_translational_J = 0, ke_total_J = 0;
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
  Kept<EndPoint> endpoints{};
  Kept<Path> paths{};
  Kept<BarrierHit> hits{};
  std::vector<ImpactLoss> impact_losses{};  // [0]: first impact; the first hundred are kept
  std::vector<ReportMap> maps{};
  ReportEnvelopes envelopes{};
  std::vector<std::string> notes{};  // what is not there, for the reader of the page
};

/// Reads a run's folder, whose summary may have another name while it is made. A missing table is a note; a summary
/// that is missing, or any file that is not what it should be, is BadInput, with one problem for each such file.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& folder, const Limits& limits = {},
                                        const char* summary = "summary.json");

}  // namespace talus::io
