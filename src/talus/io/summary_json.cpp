#include "talus/io/summary_json.hpp"

#include <cmath>

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> x) { return x && std::isfinite(*x) ? Json(*x) : Json(nullptr); }

Json histogram_json(const Tally& tally) {
  const auto histogram = tally.histogram(40);
  if (!histogram) return nullptr;
  const BinEdges& edges = histogram->edges();
  return {{"low", edges.edge(0)},
          {"width", (edges.edge(edges.bins) - edges.edge(0)) / static_cast<double>(edges.bins)},
          {"counts", histogram->counts()}};
}

Json terrain_json(const Model& model, const Profile& profile) {
  Json section = Json::array();
  const auto point = [&](const Vec3& local) {
    const Vec3 p = model.frame.global_from_local(local);
    section.push_back({p.x(), p.z()});
  };
  for (std::uint32_t k = 0; k < profile.facet_count(); ++k) {
    const Outline outline = profile.outline({k});
    point(outline.edges[0].point);
    if (k + 1 == profile.facet_count()) point(outline.edges[1].point);
  }
  return {{"kind", "section"}, {"section", section}};
}

// The terrain from above as a coarse grid of elevations, for pictures.
template <class Surface>
Json relief_json(const Model& model, const Surface& surface) {
  constexpr double most_cells_a_side = 160;
  const Vec3 size = surface.bounds().high - surface.bounds().low;
  const double cell = std::max(size.x(), size.y()) / most_cells_a_side;
  const auto columns = static_cast<int>(std::ceil(size.x() / cell - 1e-9));
  const auto rows = static_cast<int>(std::ceil(size.y() / cell - 1e-9));
  const Vec3 low = surface.bounds().low + Vec3(0.5 * cell, 0.5 * cell, 0);
  Json z = Json::array();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto ground = surface.elevation(low.x() + column * cell, low.y() + row * cell);
      z.push_back(ground ? Json(std::round((*ground + model.frame.origin.z()) * 1000) / 1000) : Json(nullptr));
    }
  }
  const Vec3 first = model.frame.global_from_local(low);
  return {{"x0", first.x()}, {"y0", first.y()}, {"cell_m", cell}, {"columns", columns}, {"rows", rows}, {"z_m", z}};
}

template <class Surface>
Json surface_json(const Model& model, const Surface& surface, const char* kind) {
  const Vec3 low = model.frame.global_from_local(surface.bounds().low);
  const Vec3 high = model.frame.global_from_local(surface.bounds().high);
  return {{"kind", kind},
          {"bounds", {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}}},
          {"triangles", surface.facet_count()},
          {"relief", relief_json(model, surface)}};
}

Json terrain_json(const Model& model, const TriangleMesh& mesh) { return surface_json(model, mesh, "mesh"); }
Json terrain_json(const Model& model, const RasterSurface& raster) { return surface_json(model, raster, "raster"); }

Json barrier_json(const Barrier& barrier, const BarrierTally& tally) {
  Json outcomes = Json::object();
  for (int k = 0; k < barrier_outcome_count; ++k) {
    const auto kind = static_cast<BarrierOutcome>(k);
    outcomes[name(kind)] = tally.outcomes[static_cast<std::size_t>(k)];
  }
  return {{"name", barrier.name},
          {"kind", barrier.is_collector ? "collector" : "barrier"},
          {"hits", tally.translational_energy.count()},
          {"rocks_hit", tally.rocks_hit},
          {"passed_above", tally.rocks_passed_above},
          {"outcomes", outcomes},
          {"least_clearance_m", number(tally.least_clearance)},
          {"statistics",
           {{"ke_translational_J", statistics_json(tally.translational_energy)},
            {"ke_total_J", statistics_json(tally.total_energy)},
            {"impact_height_m", statistics_json(tally.height)},
            {"velocity_m_s", statistics_json(tally.velocity)}}},
          {"histograms",
           {{"ke_translational_J", histogram_json(tally.translational_energy)},
            {"impact_height_m", histogram_json(tally.height)}}}};
}

}  // namespace

Json statistics_json(const Tally& tally) {
  const Descriptive d = tally.describe();
  const auto quartile = [&](double p) { return number(tally.sketch().quantile(p)); };
  return {{"mean", number(d.mean)},
          {"standard_error", number(d.standard_error)},
          {"median", number(d.median)},
          {"standard_deviation", number(d.standard_deviation)},
          {"sample_variance", number(d.sample_variance)},
          {"kurtosis", number(d.kurtosis)},
          {"skewness", number(d.skewness)},
          {"range", number(d.range)},
          {"minimum", number(d.minimum)},
          {"maximum", number(d.maximum)},
          {"sum", number(d.sum)},
          {"count", d.count},
          {"confidence_level_95", number(d.confidence_half_width_95)},
          {"quartiles", {quartile(0.25), quartile(0.5), quartile(0.75)}}};
}

Json summary_json(const RunDescription& description, const Model& model, const Summary& summary,
                  const CampaignOutcome& outcome) {
  Json ends = Json::object();
  for (int k = 0; k < end_reason_count; ++k) {
    const auto count = summary.ends[static_cast<std::size_t>(k)];
    if (count > 0) ends[name(static_cast<EndReason>(k))] = count;
  }
  Json barriers = Json::array();
  for (std::size_t b = 0; b < model.barriers.size(); ++b) {
    barriers.push_back(barrier_json(model.barriers[b], summary.barriers[b]));
  }
  Json json;
  json["talus"] = {{"version", TALUS_VERSION}};
  json["name"] = description.name;
  json["seed"] = model.seed;
  json["rocks"] = {{"planned", summary.planned}, {"done", summary.done}, {"lifted", summary.lifted}};
  json["interrupted"] = outcome.interrupted;
  json["end_reasons"] = ends;
  json["events"] = summary.events;
  json["statistics"] = {{"end_x_m", statistics_json(summary.end_x)},
                        {"runout_xy_m", statistics_json(summary.runout_plan)},
                        {"runout_total_m", statistics_json(summary.runout_total)},
                        {"max_ke_J", statistics_json(summary.max_kinetic_energy)},
                        {"max_bounce_m", statistics_json(summary.max_bounce)}};
  json["histograms"] = {{"end_x_m", histogram_json(summary.end_x)},
                        {"runout_xy_m", histogram_json(summary.runout_plan)}};
  json["barriers"] = barriers;
  json["warnings"] = description.warnings;
  json["energy_datum_m"] = model.energy_datum;
  json["terrain"] = std::visit([&](const auto& surface) { return terrain_json(model, surface); }, model.surface);
  json["project"] = description.project;
  json["timings"] = {
      {"seconds", outcome.seconds},
      {"rocks_per_second", outcome.seconds > 0 ? static_cast<double>(outcome.done) / outcome.seconds : 0},
      {"threads", outcome.threads}};
  return json;
}

}  // namespace talus
