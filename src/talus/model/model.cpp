#include "talus/model/model.hpp"

#include <fmt/format.h>

#include <cmath>

#include "talus/core/degrees.hpp"
#include "talus/model/build_barrier.hpp"
#include "talus/model/build_ensembles.hpp"
#include "talus/model/build_ground.hpp"
#include "talus/model/build_seeders.hpp"
#include "talus/model/build_shapes.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/model/check_releases.hpp"
#include "talus/model/drawn.hpp"
#include "talus/model/ground_materials.hpp"
#include "talus/model/samples.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/varied_section.hpp"

namespace talus::project {

namespace {

ImpactLaw impact_law_of(const Analysis& a) {
  if (has_extent(a.model)) return RigidSphereImpact{a.tangential_crsp_damping, a.rolling_resistance_in_impacts};
  if (a.rotation) return CrspLaw{};
  return PlainImpact{};
}

Laws laws_of(const Project& project) {
  const Analysis& a = project.analysis;
  Laws laws;
  laws.model = a.model;
  laws.impact = impact_law_of(a);
  laws.gravity = {0, 0, -a.gravity_m_s2};
  laws.sliding = a.sliding;
  laws.timestep = a.max_timestep_s;
  laws.normal_velocity_cutoff = a.normal_velocity_cutoff_m_s;
  laws.grazing = std::sin(a.grazing_angle_deg * radians);
  laws.stopped_velocity = a.stopped_velocity_m_s;
  laws.max_steps = a.max_steps;
  laws.max_time = a.max_time_s;
  laws.friction_source = a.friction_angle;
  laws.roughness = a.roughness;
  if (a.scale_rn_by_velocity) laws.restitution_scaling.normal_speed = a.rn_velocity_scale_m_s;
  if (a.scale_rn_by_mass) laws.restitution_scaling.mass = a.rn_mass_scale_kg;
  laws.material_sampling = project.sampling.materials;
  laws.in_section = project.is_2d();
  return laws;
}

TerrainParts parts_as_given(const Project& project, const BuiltTerrain& terrain) {
  TerrainParts parts{terrain.parts, terrain.part_of_facet};
  if (!project.terrain.section.runs_leftwards()) return parts;
  std::vector<std::uint32_t> of_source = *terrain.part_of_facet;
  if (of_source.empty()) {
    for (std::uint32_t k = 0; k < parts.count; ++k) of_source.push_back(k);
  }
  for (std::uint32_t& part : of_source) part = static_cast<std::uint32_t>(parts.count) - 1 - part;
  parts.of_source = std::move(of_source);
  return parts;
}

double capacity_of(const Barrier& barrier) { return barrier.capacity_kJ * 1000; }  // [J]

RunoutFrame runout_frame_of(const Output& output, const LocalFrame& frame) {
  const auto local = [&](const std::array<double, 2>& p) -> Vec2 {
    return frame.local_from_global({p[0], p[1], 0}).xy();
  };
  if (output.runout_from) return RunoutFrame::from(local(*output.runout_from));
  if (output.runout_along.empty()) return {};
  std::vector<Vec2> line;
  for (const auto& point : output.runout_along) line.push_back(local(point));
  return RunoutFrame::along(std::move(line));
}

class Builder {
 public:
  Builder(const Project& project, Problems& warnings) : project_(project), warnings_(warnings) {}

  template <class F>
  auto visit(F&& f) const {
    return std::visit(std::forward<F>(f), *model_.surface);
  }

  Model build(const BuiltTerrain& terrain) {
    model_.ground = locating_problems(
        project_, "[ground]", problems_, warnings_,
        [&](Problems& problems, Problems& warnings) { return build_ground(project_, terrain, problems, warnings); });
    model_.parts = parts_as_given(project_, terrain);
    model_.surface = terrain.surface;
    model_.varying = terrain.varying;
    model_.frame = terrain.frame;
    model_.crs_wkt = terrain.crs_wkt;
    model_.terrain_report = terrain.report;
    model_.laws = laws_of(project_);
    model_.seed = project_.sampling.seed;
    model_.sampling = project_.sampling.method;
    limit_timestep();
    const double lowest = visit([](const auto& surface) { return surface.bounds().low.z(); });
    model_.energy_datum = project_.analysis.energy_datum_m.value_or(lowest + model_.frame.origin.z());
    model_.runout_frame = runout_frame_of(project_.output, model_.frame);
    add_seeders(project_, model_, problems_, warnings_);
    for (const Barrier& barrier : project_.barriers) add_barrier(barrier);
    if (problems_.has_errors()) throw BadInput(problems_.in_order_of(project_.file.string()));
    warn_of_high_releases(model_, warnings_);
    warn_of_rocks_larger_than_cells(model_, warnings_);
    return std::move(model_);
  }

 private:
  /// A rock that starts from rest could fall past the whole terrain in a longer step.
  void limit_timestep() {
    const Box bounds = visit([](const auto& surface) { return surface.bounds(); });
    const double longest = std::sqrt(2 * (bounds.high - bounds.low).norm() / model_.laws.gravity.norm());
    model_.laws.timestep = std::min(model_.laws.timestep, longest);
  }

  void report(int line, std::string where, std::string what, std::string why, std::string hint) {
    problems_.add({Severity::error, project_.file.string(), line, std::move(where), std::move(what), std::move(why),
                   std::move(hint)});
  }

  void add_barrier(const Barrier& b) {
    talus::Barrier barrier;
    barrier.name = b.name;
    barrier.is_collector = b.is_collector;
    barrier.capacity = capacity_of(b);
    if (b.normal_restitution && b.tangential_restitution) {
      barrier.restitution = Restitution{*b.normal_restitution, *b.tangential_restitution};
    }
    const BarrierFoot foot = foot_of(model_, b.line);
    barrier.set_panels(panels_along(foot, b.height_m, b.inclination_deg * radians));
    if (foot.given > 0 && foot.given < shortest_line) {
      report(b.source_line, name_in_messages(b), fmt::format("its line is {:.3g} m long", foot.given),
             fmt::format("expected at least {:g} m", shortest_line), "");
    } else if (barrier.panels().empty()) {
      report(b.source_line, name_in_messages(b), "its line does not touch the terrain",
             "a barrier stands on the ground", is_on_ground_swapped(b) ? swapped_hint : "");
    } else {
      warn_of_gaps(b, foot);
      check_on_varied_section(b);
    }
    model_.barriers.push_back(std::move(barrier));
  }

  static std::string name_in_messages(const Barrier& b) {
    return fmt::format("{} \"{}\"", b.is_collector ? "collector" : "barrier", b.name);
  }

  /// Whether a corner of the line lies on the terrain with x and y swapped.
  [[nodiscard]] bool is_on_ground_swapped(const Barrier& b) const {
    if (std::holds_alternative<Profile>(*model_.surface)) return false;
    const Vec2 origin(model_.frame.origin.x(), model_.frame.origin.y());
    return std::ranges::any_of(b.line, [&](const auto& p) { return has_ground_at(model_, Vec2(p[1], p[0]) - origin); });
  }

  void warn_of_gaps(const Barrier& b, const BarrierFoot& foot) {
    constexpr double by_rounding = 1e-3;  // [m]
    const double off = foot.given - foot.on_ground;
    if (off <= by_rounding) return;
    warnings_.add({Severity::warning, project_.file.string(), b.source_line, name_in_messages(b),
                   fmt::format("{:.6g} of {:.6g} m of its line are off the terrain", off, foot.given),
                   "its ends are cut there, and it crosses a gap in a straight line",
                   "Compare its line with the terrain's edge and holes"});
  }

  /// Checks that a section with varying vertices has ground at the barrier for every rock.
  void check_on_varied_section(const Barrier& b) {
    if (!model_.varying) return;
    const CertainStretch certain = certain_stretch(project_.terrain.section);
    const double x = b.line.front()[0];
    if (x >= certain.from && x <= certain.to) return;
    report(b.source_line, name_in_messages(b), fmt::format("x = {:.10g} may be off the terrain", x),
           why_uncertain(certain), "Move it inwards, or reduce the standard deviations in x of the end vertices");
  }

  const Project& project_;
  Problems& warnings_;
  Problems problems_;
  Model model_;
};

Model place_on_terrain(const Project& project, const BuiltTerrain& terrain, Problems& warnings) {
  Model model = Builder(project, warnings).build(terrain);
  if (!project.sampling.parameters.empty()) {
    Problems problems;
    locating_problems(project, "[sampling]", problems, warnings, [&](Problems&, Problems& doubts) {
      add_ensembles(project, model, doubts);
      return true;
    });
  }
  return model;
}

/// Blocks that were built for the shape keep their hulls.
void set_shapes(const Project& project, const Seeder& given, talus::Seeder& seeder) {
  if (project.analysis.model != RockModel::rigid_body) {
    seeder.shapes = RockShapes{};
  } else if (!seeder.shapes->kinds.empty()) {
    seeder.shapes = with_ratios(project, given.shape, *seeder.shapes);
  } else {
    std::string about;
    Problems known;
    seeder.shapes = build_shapes(project, given.shape, about, known);
  }
}

}  // namespace

void set_properties(const Project& project, Model& model) {
  std::vector<LaidForest> laid;
  for (const talus::Material& material : model.ground.materials())
    if (material.laid_forest) laid.push_back(*material.laid_forest);
  model.ground.set_materials(materials_of(project, laid));
  model.laws = laws_of(project);
  for (const Seeder& given : project.seeders) {
    for (talus::Seeder& seeder : model.seeders) {
      if (seeder.name != given.name) continue;
      set_sizes_and_velocities(given, seeder);
      set_shapes(project, given, seeder);
    }
  }
  for (std::size_t k = 0; k < model.barriers.size(); ++k) model.barriers[k].capacity = capacity_of(project.barriers[k]);
}

BuiltTerrain read_terrain(const Project& project, Problems& warnings) {
  Problems problems;
  return locating_problems(project, "[terrain]", problems, warnings,
                           [&](Problems&, Problems& doubts) { return build_terrain(project, doubts); });
}

Model build_model(const Project& project, Problems& warnings) {
  const Project with = read_samples(project, warnings);
  return place_on_terrain(with, read_terrain(with, warnings), warnings);
}

Model build_model(const Project& project, const BuiltTerrain& terrain, Problems& warnings) {
  return place_on_terrain(read_samples(project, warnings), terrain, warnings);
}

}  // namespace talus::project
