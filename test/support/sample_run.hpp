#pragma once
// A small run's folder, written by hand: two rocks on the first two segments of the manual's Tutorial 1 slope.

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

namespace talus::sample_run {

/// A temporary folder that is removed with the object.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path(std::filesystem::temp_directory_path() / ("talus-" + name + "-" + std::to_string(counter()++))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path / name, std::ios::binary).rdbuf();
    return text.str();
  }

  const std::filesystem::path path;

 private:
  static int& counter() {
    static int count = static_cast<int>(std::hash<std::string>{}(std::to_string(std::random_device{}())) % 1000000);
    return count;
  }
};

inline const std::string endpoints_head =
    "rock,seeder,x_m,y_m,z_m,runout_xy_m,runout_z_m,runout_total_m,lateral_m,time_s,events,end_reason,ground,mass_kg,"
    "radius_m,max_ke_J,max_bounce_m,ensemble\n";
inline const std::string paths_head =
    "rock,event,state,time_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,ke_translational_J,"
    "ke_rotational_J,pe_J\n";
inline const std::string barriers_head =
    "barrier,rock,time_s,x_m,y_m,z_m,impact_height_m,vx_m_s,vy_m_s,vz_m_s,angle_deg,ke_translational_J,ke_rotational_J,"
    "ke_total_J,outcome,ensemble,top_height_m\n";

inline std::string endpoint_row(std::uint64_t rock, double x_m = 5) {
  return std::to_string(rock) + ",seeder 1," + std::to_string(x_m) + ",0,-12.2," + std::to_string(x_m - 0.5) +
         ",12.2,13.01,,2.25,4,at rest,Type One,1000,0.4455,120000,1.5,\n";
}

/// Release, impact with a loss of 60 kJ, and a slide to rest.
inline std::string path_rows(std::uint64_t rock) {
  const std::string r = std::to_string(rock);
  return r + ",0,projectile,0,0.5,0,0,1.5,0,0,0,0,0,1125,0,119641.13\n" + r +
         ",1,impact,1.577,3.1,0,-12.2,1.5,0,-15.47,0,0,0,120766.13,0,0\n" + r +
         ",2,sliding,1.577,3.1,0,-12.2,3,0,0,0,12,0,54000,6766.13,0\n" + r +
         ",3,ended,2.25,5,0,-12.2,0,0,0,0,0,0,0,0,0\n";
}

inline nlohmann::ordered_json statistics(double base) {
  return {{"mean", base + 0.125},
          {"standard_error", 0.03125},
          {"median", base + 0.25},
          {"standard_deviation", 0.4375},
          {"sample_variance", 0.19140625},
          {"kurtosis", nullptr},
          {"skewness", -1.77},
          {"range", 2.5},
          {"minimum", base - 1},
          {"maximum", base + 1.5},
          {"sum", 2 * base + 0.75},
          {"count", 2},
          {"confidence_level_95", 0.6875},
          {"quartiles", {base - 0.5, base + 0.25, base + 1}},
          {"percentiles", {{"95", nullptr}, {"99", nullptr}}}};
}

/// Every key that a run writes, in the order of the file.
inline nlohmann::ordered_json summary(const std::string& name) {
  using Json = nlohmann::ordered_json;
  const Json histogram{{"low", 4.5}, {"width", 0.5}, {"counts", {1, 0, 1}}};
  return {
      {"talus", {{"version", "0.1.0"}}},
      {"name", name},
      {"fingerprint", "46d0eda3684e621596ce0884751bc736"},
      {"seed", 4711},
      {"rocks", {{"planned", 2}, {"done", 2}, {"lifted", 1}, {"with_endpoint", 2}, {"with_path", 2}}},
      {"interrupted", false},
      {"end_reasons", {{"at rest", 2}}},
      {"events", 8},
      {"statistics", {{"end_x_m", statistics(17)}, {"runout_xy_m", statistics(27)}, {"max_ke_J", statistics(123456)}}},
      {"histograms", {{"end_x_m", histogram}, {"runout_xy_m", histogram}}},
      {"barriers", Json::array({{{"name", "Fence"},
                                 {"kind", "barrier"},
                                 {"line_xyz", Json::array({{4.5, 0, -12.2}})},
                                 {"hits", 1},
                                 {"rocks_hit", 1},
                                 {"passed_above", 1},
                                 {"outcomes", {{"stopped", 1}, {"rebounded", 0}, {"broke through", 0}, {"passed", 0}}},
                                 {"least_clearance_m", 0.8125},
                                 {"statistics", {{"ke_translational_J", statistics(98765)}}},
                                 {"histograms", {{"ke_translational_J", histogram}}}}})},
      {"sources", Json::array({{{"name", "seeder 1"}, {"rocks", 2}}})},
      {"releases", Json::array({{{"first_rock", 0},
                                 {"rocks", 2},
                                 {"rocks_at_once", 1},
                                 {"places", 1},
                                 {"step", 1},
                                 {"start", 0},
                                 {"sources", Json::array({{0, 0}})}}})},
      {"warnings", {"1 rock was lifted onto the surface"}},
      {"notes", Json::array()},
      {"energy_datum_m", -12.2},
      {"origin_m", {0, 0, 0}},
      {"terrain", {{"kind", "section"}, {"section", Json::array({{0, 0}, {3.1, -12.2}, {6.7, -12.2}})}}},
      {"project",
       {{"name", name},
        {"analysis", {{"model", "lumped_mass"}, {"rotation", true}, {"gravity_m_s2", 9.80665}}},
        {"material",
         Json::array({{{"name", "Type One"}, {"normal_restitution", {{"mean", 0.53}, {"distribution", "none"}}}}})},
        {"ground", {{"default", "Type One"}}}}},
      {"inputs",
       {{"files", Json::array({{{"name", "tutorial.toml"}, {"bytes", 1872}, {"sha256", std::string(64, 'a')}}})}}},
      {"timings", {{"seconds", 0.375}, {"rocks_per_second", 5.25}, {"threads", 2}}}};
}

/// The whole folder, which the reader accepts.
inline void write(const Folder& folder, const std::string& name = "Tutorial 1") {
  folder.write("summary.json", summary(name).dump(1));
  folder.write("endpoints.csv", endpoints_head + endpoint_row(0) + endpoint_row(1, 5.25));
  folder.write("paths.csv", paths_head + path_rows(0) + path_rows(1));
  folder.write("barriers.csv",
               barriers_head + "Fence,1,1.9,4.5,0,-11.45,0.75,3,0,0,12.5,54000,6766.13,60766.13,stopped,,1.641\n");
}

}  // namespace talus::sample_run
