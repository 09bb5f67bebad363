#include "talus/project/model.hpp"

#include <fmt/format.h>

#include <numbers>

#include "talus/ground/forest.hpp"
#include "talus/project/build_ground.hpp"
#include "talus/project/build_seeders.hpp"
#include "talus/project/build_terrain.hpp"
#include "talus/project/drawn.hpp"
#include "talus/project/named_files.hpp"

namespace talus::project {

namespace {

constexpr double radians = std::numbers::pi / 180;

talus::Material material_of(const Material& m) {
  talus::Material material;
  material.name = m.name;
  material.normal_restitution = sampler_of("normal_restitution", m.normal_restitution);
  material.tangential_restitution = sampler_of("tangential_restitution", m.tangential_restitution);
  material.friction_angle = sampler_of("friction_angle_deg", m.friction_angle_deg, radians);
  material.roughness = sampler_of("roughness_deg", m.roughness_deg, radians);
  material.roughness_spacing = m.roughness_spacing_m;
  material.roughness_amplitude = m.roughness_amplitude_m;
  material.dynamic_friction = sampler_of("dynamic_friction", m.dynamic_friction);
  material.rolling_friction = sampler_of("rolling_friction", m.rolling_friction);
  if (m.forest_drag_kg_s) {
    material.forest_drag = *m.forest_drag_kg_s;
  } else if (m.forest != Forest::none) {
    material.forest_drag = forest_drag(m.forest == Forest::open     ? ForestDensity::open
                                       : m.forest == Forest::medium ? ForestDensity::medium
                                                                    : ForestDensity::dense);
  }
  material.forest_height = m.forest_height_m.value_or(0);
  material.ground_drag = m.ground_drag_per_s;
  return material;
}

Laws laws_of(const Project& project) {
  const Analysis& a = project.analysis;
  Laws laws;
  laws.model = a.model == RockModel::rigid_sphere ? talus::RockModel::rigid_sphere : talus::RockModel::lumped_mass;
  laws.rotation = a.rotation;
  laws.gravity = {0, 0, -a.gravity_m_s2};
  laws.sliding =
      a.sliding == SlidingMethod::stepped ? talus::SlidingMethod::stepped : talus::SlidingMethod::closed_form;
  laws.timestep = a.max_timestep_s;
  laws.normal_velocity_cutoff = a.normal_velocity_cutoff_m_s;
  laws.stopped_velocity = a.stopped_velocity_m_s;
  laws.max_steps = a.max_steps;
  laws.max_time = a.max_time_s;
  switch (a.friction_angle) {
    case FrictionSource::material:
      laws.friction_source = talus::FrictionSource::material;
      break;
    case FrictionSource::tangential_restitution:
      laws.friction_source = talus::FrictionSource::tangential_restitution;
      break;
    case FrictionSource::zero:
      laws.friction_source = talus::FrictionSource::zero;
      break;
  }
  if (a.scale_rn_by_velocity) laws.restitution_scaling.normal_speed = a.rn_velocity_scale_m_s;
  if (a.scale_rn_by_mass) laws.restitution_scaling.mass = a.rn_mass_scale_kg;
  laws.tangential_crsp_damping = a.tangential_crsp_damping;
  laws.material_sampling = project.sampling.materials == MaterialSampling::per_rock
                               ? talus::MaterialSampling::per_rock
                               : talus::MaterialSampling::per_impact;
  laws.in_section = project.is_2d();
  return laws;
}

TerrainParts parts_as_given(const Project& project, BuiltTerrain& terrain) {
  TerrainParts parts{terrain.parts, std::move(terrain.part_of_facet)};
  const auto& section = project.terrain.section;
  if (section.empty() || section.front()[0] < section.back()[0]) return parts;
  // It was walked from left to right.
  if (parts.of_source.empty()) {
    for (std::uint32_t k = 0; k < parts.count; ++k) parts.of_source.push_back(k);
  }
  for (std::uint32_t& part : parts.of_source) part = static_cast<std::uint32_t>(parts.count) - 1 - part;
  return parts;
}

class Builder {
 public:
  Builder(const Project& project, Problems& warnings) : project_(project), warnings_(warnings) {}

  template <class F>
  auto visit(F&& f) const {
    return std::visit(std::forward<F>(f), model_.surface);
  }

  Model build() {
    BuiltTerrain terrain =
        naming_files(project_, "[terrain]", problems_, warnings_,
                     [&](Problems&, Problems& warnings) { return build_terrain(project_, warnings); });
    std::vector<talus::Material> materials;
    for (const Material& material : project_.materials) materials.push_back(material_of(material));
    model_.ground =
        naming_files(project_, "[ground]", problems_, warnings_, [&](Problems& problems, Problems& warnings) {
          return build_ground(project_, std::move(materials), terrain, problems, warnings);
        });
    model_.parts = parts_as_given(project_, terrain);
    model_.surface = std::move(terrain.surface);
    model_.varying = std::move(terrain.varying);
    model_.frame = terrain.frame;
    model_.crs_wkt = std::move(terrain.crs_wkt);
    model_.terrain_report = std::move(terrain.report);
    model_.laws = laws_of(project_);
    model_.seed = project_.sampling.seed;
    model_.sampling = project_.sampling.method;
    const double lowest = visit([](const auto& surface) { return surface.bounds().low.z(); });
    model_.energy_datum = project_.analysis.energy_datum_m.value_or(lowest + model_.frame.origin.z());
    add_seeders(project_, model_, problems_, warnings_);
    for (const Barrier& barrier : project_.barriers) add_barrier(barrier);
    if (problems_.has_errors()) throw BadInput(problems_.in_order_of(project_.file.string()));
    return std::move(model_);
  }

 private:
  void complain(int line, std::string where, std::string what, std::string why, std::string hint) {
    problems_.add({Severity::error, project_.file.string(), line, std::move(where), std::move(what), std::move(why),
                   std::move(hint)});
  }

  void add_barrier(const Barrier& b) {
    talus::Barrier barrier;
    barrier.name = b.name;
    barrier.is_collector = b.is_collector;
    barrier.capacity = b.capacity_kJ * 1000;
    if (b.normal_restitution && b.tangential_restitution) {
      barrier.restitution = Restitution{*b.normal_restitution, *b.tangential_restitution};
    }
    barrier.stand(panels_over(foot_of(b), b.height_m, b.inclination_deg * radians));
    if (barrier.panels().empty()) {
      complain(b.source_line, fmt::format("{} \"{}\"", b.is_collector ? "collector" : "barrier", b.name),
               "its line does not touch the terrain", "a barrier stands on the ground", "");
    }
    model_.barriers.push_back(std::move(barrier));
  }

  // The barrier's line laid on the ground. In 2D it runs along y, across the section.
  std::vector<Vec3> foot_of(const Barrier& b) const {
    std::vector<Vec3> foot;
    if (const auto* profile = std::get_if<Profile>(&model_.surface)) {
      const double x = b.line.front()[0] - model_.frame.origin.x();
      if (const auto z = profile->elevation(x)) foot = {Vec3(x, -1, *z), Vec3(x, 1, *z)};
      return foot;
    }
    const Vec2 origin(model_.frame.origin.x(), model_.frame.origin.y());
    const auto drape = [&](const Vec2& from, const Vec2& to) {
      if (const auto* raster = std::get_if<RasterSurface>(&model_.surface)) return raster->draped(from, to);
      return std::get<TriangleMesh>(model_.surface).draped(from, to);
    };
    for (std::size_t k = 0; k + 1 < b.line.size(); ++k) {
      for (const Vec3& p :
           drape(Vec2(b.line[k][0], b.line[k][1]) - origin, Vec2(b.line[k + 1][0], b.line[k + 1][1]) - origin)) {
        const bool repeats = !foot.empty() && (p - foot.back()).squaredNorm() < 1e-12;
        if (!repeats) foot.push_back(p);
      }
    }
    return foot;
  }

  const Project& project_;
  Problems& warnings_;
  Problems problems_;
  Model model_;
};

}  // namespace

Model build_model(const Project& project, Problems& warnings) { return Builder(project, warnings).build(); }

}  // namespace talus::project
