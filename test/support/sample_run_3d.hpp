#pragma once
// The folder of a small run on terrain, written by hand, for tests of files derived from it.

#include <string>

#include "support/sample_run.hpp"

namespace talus::sample_run {

/// Statistics of hits with these values at 95 %, 99 % and the maximum.
inline nlohmann::ordered_json design_statistics(double p95, double p99, double greatest) {
  nlohmann::ordered_json values = statistics(0);
  values["maximum"] = greatest;
  values["percentiles"] = {{"95", p95}, {"99", p99}};
  return values;
}

inline nlohmann::ordered_json barrier_3d(const std::string& name, const std::string& kind) {
  using Json = nlohmann::ordered_json;
  return {{"name", name},
          {"kind", kind},
          {"line_xyz", Json::array({{10, 0, 5}, {10, 20, 5.5}, {10, 50, 5}})},
          {"hits", 3},
          {"rocks_hit", 2},
          {"passed_above", 1},
          {"outcomes", {{"stopped", 2}, {"rebounded", 1}, {"broke through", 0}, {"passed", 0}}},
          {"least_clearance_m", 0.25},
          {"statistics",
           {{"ke_translational_J", design_statistics(9.5e4, 9.9e4, 1e5)},
            {"ke_total_J", design_statistics(9.6e4, 9.95e4, 1.1e5)},
            {"impact_height_m", design_statistics(1.5, 2.5, 3)},
            {"velocity_m_s", design_statistics(15, 16, 17)}}}};
}

inline nlohmann::ordered_json summary_3d() {
  using Json = nlohmann::ordered_json;
  Json collector = barrier_3d("Track", "collector");
  collector["least_clearance_m"] = nullptr;
  for (auto& quantity : collector["statistics"]) quantity = design_statistics(0, 0, 0), quantity["maximum"] = nullptr;
  Json all = summary("Terrain");
  all["rocks"] = {{"planned", 6}, {"done", 6}, {"lifted", 0}, {"with_endpoint", 6}, {"with_path", 6}};
  all["terrain"] = {{"kind", "mesh"}};
  all["barriers"] = Json::array({barrier_3d("Fence", "barrier"), collector});
  all["sources"] = Json::array({{{"name", "Wall"}, {"rocks", 4}}, {{"name", "Tower, \"old\""}, {"rocks", 2}}});
  all["releases"] = Json::array({{{"first_rock", 0},
                                  {"rocks", 6},
                                  {"rocks_at_once", 2},
                                  {"places", 3},
                                  {"step", 1},
                                  {"start", 0},
                                  {"sources", Json::array({{0, 0}, {1, 1}, {2, 0}})}}});
  all["project"] = {
      {"barrier", Json::array({{{"name", "Fence"}, {"height_m", 3}, {"inclination_deg", -10}, {"capacity_kJ", 500}}})},
      {"collector", Json::array({{{"name", "Track"}, {"height_m", 6}, {"inclination_deg", 0}}})},
      {"output", {{"endpoints", "all"}, {"paths", "all"}, {"geopackage", 10000}, {"vtk", true}}}};
  return all;
}

/// Six rocks, all with their paths.
inline void write_3d(const Folder& folder, const nlohmann::ordered_json& summary = summary_3d()) {
  std::string endpoints = endpoints_head, paths = paths_head;
  for (std::uint64_t rock = 0; rock < 6; ++rock) {
    endpoints += endpoint_row(rock, 5 + static_cast<double>(rock));
    paths += path_rows(rock);
  }
  folder.write("summary.json", summary.dump());
  folder.write("endpoints.csv", endpoints);
  folder.write("paths.csv", paths);
}

}  // namespace talus::sample_run
