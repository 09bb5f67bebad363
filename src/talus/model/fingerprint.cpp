#include "talus/model/fingerprint.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <variant>

#include "talus/campaign/paths_revision.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/core/bytes.hpp"
#include "talus/files/checksum.hpp"
#include "talus/project/echo.hpp"

namespace talus::project {

namespace {

void put(ByteWriter& out, const Vec3& v) {
  for (const double x : {v.x(), v.y(), v.z()}) out.put(x);
}

void put_outlines(ByteWriter& out, const auto& surface) {
  out.count(surface.facet_count());
  for (std::uint32_t k = 0; k < surface.facet_count(); ++k) {
    out.put(surface.source({k}));
    const Outline outline = surface.outline({k});
    for (int e = 0; e < outline.edge_count; ++e) put(out, outline.edges[static_cast<std::size_t>(e)].point);
  }
}

void put(ByteWriter& out, const Profile& profile) { put_outlines(out, profile); }
void put(ByteWriter& out, const TriangleMesh& mesh) { put_outlines(out, mesh); }
void put(ByteWriter& out, const RasterSurface& raster) {
  const RasterGrid& grid = raster.grid();
  out.put(grid.columns);
  out.put(grid.rows);
  for (const double x : {grid.x0, grid.y0, grid.dx, grid.dy}) out.put(x);
  // In pieces: the writer buffers its input.
  constexpr std::size_t piece = 1U << 18;
  const std::span<const float> z(grid.z);
  for (std::size_t k = 0; k < z.size(); k += piece) out.numbers(z.subspan(k, std::min(piece, z.size() - k)));
}

void put(ByteWriter& out, const talus::Ground& ground, std::size_t sources) {
  const bool is_uniform = ground.bytes() == 0;
  out.flag(is_uniform);
  std::array<std::uint32_t, 1024> piece;
  const std::size_t count = is_uniform ? 1 : sources;
  for (std::size_t k = 0; k < count; k += piece.size()) {
    const std::size_t length = std::min(piece.size(), count - k);
    for (std::size_t i = 0; i < length; ++i) piece[i] = ground.material_of(static_cast<std::uint32_t>(k + i)).index;
    out.numbers(std::span<const std::uint32_t>(piece).first(length));
  }
}

void put(ByteWriter& out, const ReleaseLines& lines) {
  out.put(lines.length());
  constexpr int places = 256;  // together with the length, enough to detect a moved vertex
  for (int k = 0; lines.length() > 0 && k <= places; ++k) {
    const ReleaseLines::Place place = lines.at(k / static_cast<double>(places));
    put(out, place.point);
    out.put(place.source.index);
  }
}

void put(ByteWriter& out, const ReleaseCells& cells) {
  for (const double x : {cells.corner.x(), cells.corner.y(), cells.dx, cells.dy}) out.put(x);
  out.put(cells.columns);
  out.list(cells.cells);
  out.count(cells.sources.size());
  for (const ReleaseCells::Run& run : cells.sources) {
    out.put(run.first);
    out.put(run.source.index);
  }
}

void put(ByteWriter& out, const ReleaseTable& table) {
  out.count(table.count());
  table.visit_columns([&](const auto& column) {
    out.count(column.size());
    for (const auto& value : column) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Vec3>) {
        put(out, value);
      } else {
        out.put(value);
      }
    }
  });
  for (const ReleaseTable::Run& run : table.sources()) {
    out.put(run.first);
    out.put(run.source.index);
  }
}

/// The values of a sample that was read from a file. All else of a property follows from the project's text.
void put_sample(ByteWriter& out, const Sampler& sampler) {
  if (sampler.sample() == nullptr) return;
  out.list(sampler.sample()->values());
  out.list(sampler.sample()->weights_up_to());
}
void put_sample(ByteWriter& out, const std::optional<Sampler>& sampler) {
  if (sampler) put_sample(out, *sampler);
}
void put_sample(ByteWriter& out, const RoughGround& roughness) { put_sample(out, roughness.tilt()); }

template <class... Properties>
void put_samples(ByteWriter& out, const Properties&... properties) {
  (put_sample(out, properties), ...);
}

// All members are named here, so that a new one does not compile until it is decided whether it has a sample.
void put(ByteWriter& out, const talus::Material& material) {
  const auto& [name, rn, rt, friction_angle, roughness, dynamic_friction, rolling_friction, forest_drag, forest_height,
               ground_drag, friction_rise, laid_forest] = material;
  put_samples(out, rn, rt, friction_angle, roughness, dynamic_friction, rolling_friction);
}

/// Hulls may come from files. The rest of a shape, and how rocks are turned, follows from the project's text.
void put(ByteWriter& out, const RockKind& kind) {
  const auto& [share, hulls, stretch] = kind;
  for (const RockShape& hull : hulls) {
    out.count(hull.corners.size());
    for (const Vec3& corner : hull.corners) put(out, corner);
  }
  if (stretch) put_samples(out, stretch->b_over_a, stretch->c_over_b);
}

void put(ByteWriter& out, const talus::Seeder& seeder) {
  const auto& [name, source, first_rock, rocks, rocks_at_once, step, where, above_surface, size_of, size, density,
               direction, speed, horizontal, vertical, spin, shapes, turn] = seeder;
  out.text(name);
  out.put(source.index);
  out.put(first_rock);
  out.put(rocks);
  out.count(where->index());
  std::visit([&](const auto& places) { put(out, places); }, *where);
  out.flag(above_surface.has_value());
  out.put(above_surface.value_or(0));
  out.flag(direction.has_value());
  put(out, direction.value_or(Vec3{}));
  put_samples(out, size, density, horizontal, vertical, spin, speed);
  for (const RockKind& kind : shapes->kinds) put(out, kind);
}

void put(ByteWriter& out, const talus::Barrier& barrier) {
  out.text(barrier.name);
  out.count(barrier.panels().size());
  for (const Panel& panel : barrier.panels()) {
    for (const Vec3& v : {panel.foot, panel.along, panel.up}) put(out, v);
    out.put(panel.length);
    out.put(panel.height);
  }
}

/// The number of source numbers of the surface's facets; each has a material.
std::size_t sources_of(const Model& model) {
  return std::visit(
      [](const auto& surface) -> std::size_t {
        using Surface = std::decay_t<decltype(surface)>;
        if constexpr (std::is_same_v<Surface, RasterSurface>) return surface.cell_count();
        std::size_t sources = 0;
        for (std::uint32_t k = 0; k < surface.facet_count(); ++k) {
          sources = std::max(sources, std::size_t{surface.source({k})} + 1);
        }
        return sources;
      },
      *model.surface);
}

}  // namespace

std::string fingerprint_of(const nlohmann::ordered_json& project, const Model& model) {
  Checksum checksum;
  ByteWriter out([&](std::string_view piece) { checksum.add(piece); });
  out.put(paths_revision);
  out.text(without_presentation(project).dump());
  put(out, model.frame.origin);
  out.count(model.surface->index());
  std::visit([&](const auto& surface) { put(out, surface); }, *model.surface);
  put(out, model.ground, sources_of(model));
  for (const talus::Material& material : model.ground.materials()) put(out, material);
  out.count(model.seeders.size());
  for (const talus::Seeder& seeder : model.seeders) put(out, seeder);
  out.count(model.barriers.size());
  for (const talus::Barrier& barrier : model.barriers) put(out, barrier);
  for (const std::vector<double>& values : model.drawn_parameters) out.numbers(std::span<const double>(values));
  out.flush();
  return text_of(checksum.digest());
}

std::string sample_of(const Model& model) {
  Checksum checksum;
  ByteWriter out([&](std::string_view piece) { checksum.add(piece); });
  Simulator simulator(model);
  const std::uint64_t rocks = model.rocks(), count = std::min<std::uint64_t>(rocks, 16);
  for (std::uint64_t k = 0; k < count; ++k) {
    const RockRecord record = simulator.simulate(count == 1 ? 0 : rocks / count * k, false);
    const RockOutcome& outcome = record.outcome;
    put(out, outcome.start.position);
    put(out, outcome.end.position);
    for (const double x : {record.body.mass, outcome.end.time, outcome.max_kinetic_energy, outcome.max_bounce}) {
      out.put(x);
    }
    out.put(static_cast<std::int64_t>(outcome.events));
    out.put(static_cast<std::uint32_t>(outcome.reason));
  }
  out.flush();
  return text_of(checksum.digest());
}

}  // namespace talus::project
