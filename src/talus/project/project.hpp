#pragma once
// A project as given in its file: plain values in the units of the file, checked, not yet turned into a model. The keys
// and their units, ranges and meanings are declared only in settings/; the initial values below are the defaults.

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/vec.hpp"
#include "talus/ground/forest.hpp"
#include "talus/maps/map_subjects.hpp"
#include "talus/project/seeder.hpp"
#include "talus/project/shape.hpp"
#include "talus/project/terrain.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus::project {

/// Whose laws rocks obey: Talus' own, or those of RocFall2 and RocFall3, which the published tables need.
enum class LawSet { talus, rocfall };

/// [analysis]
struct Analysis {
  LawSet laws = LawSet::talus;  // the defaults of the rest: of_laws()
  RockModel model = RockModel::lumped_mass;
  bool rotation = true;
  double gravity_m_s2 = standard_gravity;
  SlidingMethod sliding = SlidingMethod::stepped;
  double max_timestep_s = 0.01;
  double normal_velocity_cutoff_m_s = 0.1;
  double grazing_angle_deg = 15;
  double stopped_velocity_m_s = 0.1;
  std::int64_t max_steps = 10000;
  double max_time_s = 600;
  std::optional<double> energy_datum_m;
  FrictionSource friction_angle = FrictionSource::material;
  RoughnessLaw roughness = RoughnessLaw::faces;
  bool scale_rn_by_velocity = true;
  double rn_velocity_scale_m_s = 9.144;
  bool scale_rn_by_mass = false;
  double rn_mass_scale_kg = 1000;
  bool tangential_crsp_damping = true;        // rigid sphere only
  bool rolling_resistance_in_impacts = true;  // rigid sphere only

  /// Whether `roughness_amplitude_m` of materials has an effect.
  [[nodiscard]] bool has_heights_of_roughness() const { return has_extent(model) || roughness == RoughnessLaw::faces; }
  /// The defaults with these laws.
  [[nodiscard]] static Analysis of_laws(LawSet laws) {
    Analysis analysis;
    if (laws == LawSet::rocfall) {
      analysis.laws = laws;
      analysis.grazing_angle_deg = 0;
      analysis.roughness = RoughnessLaw::tilts;
      analysis.scale_rn_by_velocity = false;
      analysis.tangential_crsp_damping = false;
      analysis.rolling_resistance_in_impacts = false;
    }
    return analysis;
  }
};

/// [sampling]
struct Sampling {
  std::uint64_t seed = 1;
  SamplingMethod method = SamplingMethod::monte_carlo;
  MaterialSampling materials = MaterialSampling::per_impact;
  std::filesystem::path parameters;  // CSV, a sample of uncertain parameters; empty: none
  std::string parameters_site;       // of a sample of several sites; empty: the only one that it may be
  std::int64_t ensembles = 50;       // with `parameters`
};

/// [[material]]
struct Material {
  std::string name;
  std::string like;  // library material with the values that the file does not give
  Distribution normal_restitution = constant(0.35);
  Distribution tangential_restitution = constant(0.85);
  Distribution friction_angle_deg = constant(30);
  Distribution roughness_deg = constant(0);  // a plain number is the standard deviation of the tilt
  double roughness_spacing_m = 5;
  double roughness_amplitude_m = 0;
  Distribution dynamic_friction = constant(0.5);
  Distribution rolling_friction = constant(0.1);
  Forest forest = Forest::none;  // or forest_drag_kg_s; either needs forest_height_m
  std::optional<double> forest_drag_kg_s;
  std::optional<double> forest_height_m;
  double ground_drag_per_s = 0;
  std::optional<double> max_friction, friction_rise_per_m, friction_decay_per_s;  // all or none

  /// b of its forest, as given or by its density [kg/s]; 0: no forest.
  [[nodiscard]] double forest_drag() const { return forest_drag_kg_s.value_or(talus::forest_drag(forest)); }
};

/// [ground]
struct Ground {
  std::string default_material;                 // key `default`; the only material if it is not given
  std::vector<std::string> segments;            // section: names, one per segment
  std::vector<std::int64_t> triangles;          // mesh: zero-based material numbers, one per triangle
  std::filesystem::path raster;                 // of classes; as written in the file, relative to the project file
  std::map<std::int32_t, std::string> classes;  // of that raster, with their materials
  std::filesystem::path polygons;               // on plan; as written in the file, relative to the project file
  std::string layer;                            // of that file
  std::string attribute;                        // of the polygons, which gives the material
  std::map<std::string, std::string> values;  // of that attribute, with their materials; empty: they are material names
};

/// [[area]]: a part of the ground with another material than [ground] gives it; 3D only.
struct Area {
  std::string name;  // default: "area N"
  std::string material;
  std::vector<std::array<double, 2>> polygon;  // on plan
  int line = 0;                                // in the project file, for later messages
};

/// [[forest]]: a forest over the ground; 3D only.
struct ForestArea {
  std::string name;               // default: "forest N"
  Forest density = Forest::none;  // or drag_kg_s; neither: a clearing
  std::optional<double> drag_kg_s;
  std::optional<double> height_m;              // needed if there is a drag
  std::vector<std::array<double, 2>> polygon;  // on plan; or those of a file:
  std::filesystem::path polygons;              // as written in the project's file, relative to it
  std::string layer;                           // of that file
  std::string attribute;                       // of its polygons; empty: all polygons belong to the forest
  std::vector<std::string> values;             // of that attribute: those that belong to the forest
  int line = 0;                                // in the project file, for later messages

  /// b, as given or by its density [kg/s]; 0: a clearing.
  [[nodiscard]] double drag() const { return drag_kg_s.value_or(talus::forest_drag(density)); }
};

/// [[barrier]] and [[collector]]
struct Barrier {
  std::string name;
  bool is_collector = false;
  std::vector<std::array<double, 2>> line;  // on plan; 2D: one point (x, 0)
  double height_m = 0;
  double inclination_deg = 0;  // from the vertical; positive to the right of the line's direction (2D: towards +x)
  double capacity_kJ = std::numeric_limits<double>::infinity();
  std::optional<double> normal_restitution;  // both or neither; neither: it holds the rocks it stops
  std::optional<double> tangential_restitution;
  int source_line = 0;
};

/// [output]
struct Output {
  // Keys `endpoints`, `paths` and `impacts`: nullopt is "all", 0 is "none", else a number of rocks.
  std::optional<std::int64_t> endpoint_limit;
  std::optional<std::int64_t> path_limit = 300;  // as many as a report shows
  std::optional<std::int64_t> impact_limit = 0;  // key `impacts`
  // Of the store, a sample unless one of the two is given; the other is "all" then.
  std::optional<std::int64_t> stored_limit = 10'000;  // key `trajectories`, as `paths`
  std::optional<std::int64_t> trajectories_MB = 16;
  // On plan, in the project's coordinates; 2D: (x, 0). At most one of them is given.
  std::optional<std::array<double, 2>> runout_from;
  std::vector<std::array<double, 2>> runout_along;
  MapSubjects maps = all_map_subjects;  // `true` is all, `false` none
  bool maps_by_source = false;
  // With sampling.parameters: of the maps, those whose range between ensembles is mapped.
  MapSubjects bands = only(MapCount::reach_share);
  // nullopt is "terrain", the cells of the terrain's raster; 0 means not given, until reading is complete.
  std::optional<double> raster_cell_m = 0;
  std::optional<std::vector<double>> percentiles;        // in maps: 95; along a section: 50, 95 and 99
  bool means = false;                                    // in maps; a section has them
  std::optional<std::int64_t> geopackage_limit = 10000;  // key `geopackage`, as `paths`; 3D only
  bool vtk = false;
  bool report = true;
};

enum class DesignStandard { uni_11211_4, onr_24810, none };
enum class DesignLevel { mel, sel };
enum class DesignEnergy { translational, total };

/// Least share of its height that a kit keeps after an impact at its MEL: A half, B 30 %, C less.
enum class ResidualHeight { unknown, a, b, c };

/// [[kit]]: a barrier kit on the market, as its assessment describes it.
struct Kit {
  std::string name;
  std::vector<double> heights_m;  // nominal
  double mel_kJ = 0;
  std::optional<double> sel_kJ;
  std::optional<double> tested_height_m;
  std::optional<double> elongation_m;
  ResidualHeight residual_height = ResidualHeight::unknown;
  std::optional<double> cost_per_m;
};

/// [design]
struct Design {
  std::vector<std::string> lines;  // of barriers and collectors, by name; empty: all
  std::string protect;             // one of them; empty: none
  double section_m = 10;
  double free_end_m = 0;
  std::optional<double> clearance_m;
  bool pairs = false;
  std::vector<double> percentiles{50, 95, 99};
  double confidence = 0.95;
  DesignStandard standard = DesignStandard::uni_11211_4;
  std::filesystem::path standard_file;  // in place of the standard; as written in the file
  // Factors of the standard, its percentile and its clearance: nullopt is the value of its set (factor_set.hpp).
  std::optional<double> design_percentile;
  std::optional<double> trajectory_factor, topography_factor, volume_factor, density_factor, risk_factor;
  std::optional<double> action_energy_factor, action_height_factor;
  DesignLevel energy_level = DesignLevel::mel;
  std::optional<double> energy_factor, elongation_factor;
  DesignEnergy energy = DesignEnergy::translational;
  std::optional<double> block_mass_kg;
  std::optional<double> upper_clearance_m;
  double catch_share = 0.95;
  std::vector<double> heights_m{2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9, 10};
  std::vector<double> energies_kJ{100, 250, 500, 1000, 1500, 2000, 3000, 4500};
  double cost_height_exponent = 1;
  double cost_energy_exponent = 0.5;
};

enum class Paper { a4, a3 };
enum class ReportUnits { metric, us };  // us: US customary

/// [report]: the title block of the report. It changes no result.
struct TitleBlock {
  std::string client, project, number, author, checked, revision;
  std::string date;            // as it is to be printed; empty: that of the run
  std::string text;            // any further text
  std::filesystem::path logo;  // a PNG or JPEG picture; as written in the file, relative to the project file
  Paper paper = Paper::a4;
  ReportUnits units = ReportUnits::metric;
};

/// [[layer]]: a raster or vector file that is drawn over the terrain for reference. It changes no result.
struct Layer {
  std::string name;            // default: the file's name without its ending
  std::filesystem::path file;  // as written in the file, relative to the project file
  std::string layer;           // of a vector file
  std::string name_attribute;  // of its features; empty: `name`, if there is one
  std::string colour = "#d95f02";
  double opacity = 1;
  bool visible = true;
};

/// The text that a project was read from.
struct ProjectText {
  std::uint64_t bytes = 0;
  std::string sha256;  // as printed by sha256sum
};

/// An input file that a project names.
struct NamedFile {
  std::filesystem::path file;  // as written, relative to the project file
  std::string named_in;        // the project file, or the option
  int line = 0;                // 0 in an option
  std::string where, key;      // the row as named in problems, for example "[terrain]", and its key
  std::string path;            // of the setting: `terrain.raster`

  /// Whether it is drawn only, and no input of results.
  [[nodiscard]] bool is_layer() const { return path.starts_with("layer."); }
};

struct Project {
  std::filesystem::path file;  // as the user named it
  ProjectText source;
  std::string name;  // default: the file's stem
  Analysis analysis;
  Sampling sampling;
  Terrain terrain;
  std::vector<Material> materials;
  Ground ground;
  std::vector<Area> areas;
  std::vector<ForestArea> forests;
  std::vector<Shape> shapes;
  std::vector<Seeder> seeders;
  std::vector<Barrier> barriers;  // collectors too
  std::vector<Kit> kits;
  std::optional<Design> design;  // nullopt: no barrier is designed
  Output output;
  TitleBlock title_block;
  std::vector<Layer> layers;
  std::vector<NamedFile> named_files;

  [[nodiscard]] bool is_2d() const { return !terrain.section.vertices.empty() && !terrain.section.width_m; }
  [[nodiscard]] std::uint64_t rocks() const;
  /// The shape of this name, of [[shape]] or built in; null for the sphere and for unknown names.
  [[nodiscard]] const Shape* shape_named(std::string_view shape) const;
  /// The index of the material of this name, if any.
  [[nodiscard]] std::optional<std::uint32_t> number_of_material(std::string_view material) const {
    for (std::uint32_t number = 0; number < materials.size(); ++number) {
      if (materials[number].name == material) return number;
    }
    return std::nullopt;
  }
};

}  // namespace talus::project
