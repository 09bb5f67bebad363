#include "model_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/campaign/simulate.hpp"
#include "talus/import/survey_crs.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/words.hpp"

namespace talus::server {

namespace {

constexpr std::uint64_t most_places = 2'000;  // shown per seeder

const char* kind_of(const Profile&) { return "section"; }
const char* kind_of(const TriangleMesh&) { return "mesh"; }
const char* kind_of(const RasterSurface&) { return "raster"; }

Json crs_json(const std::string& wkt) {
  if (wkt.empty()) return nullptr;
  // The first quoted text of WKT is the full name; EPSG:NUMBER, if known, is put in front.
  const std::size_t begin = std::min(wkt.find('"'), wkt.size() - 1) + 1;
  const std::string title = wkt.substr(begin, wkt.find('"', begin) - begin);
  const auto known = crs_in_words(wkt);
  if (!known || known->name == title) return title;
  return known->name + ' ' + title;
}

class Describer {
 public:
  explicit Describer(const ShelvedModel& shelved) : project_(shelved.project), model_(shelved.model) {}

  [[nodiscard]] Json place(const Vec3& local) const { return as_json(model_.frame.global_from_local(local)); }

  [[nodiscard]] Json bounds() const {
    const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *model_.surface);
    return {{"min", place(box.low)}, {"max", place(box.high)}};
  }

  /// Release places of its first turns, which are spread evenly over all.
  [[nodiscard]] Json places(const Seeder& seeder) const {
    const bool is_point = std::holds_alternative<Vec3>(*seeder.where);
    const ReleaseOrder order = release_order(seeder, model_.seed);
    const std::uint64_t count = is_point ? 1 : std::min(order.turns(), most_places);
    Json list = Json::array();
    for (std::uint64_t turn = 0; turn < count; ++turn)
      list.push_back(place(start_of(model_, seeder.first_rock + turn * order.rocks_at_once)));
    return list;
  }

  [[nodiscard]] Json lines(const Seeder& seeder) const {
    Json list = Json::array();
    const auto* lines = std::get_if<ReleaseLines>(&*seeder.where);
    for (std::size_t k = 0; lines != nullptr && k < lines->count(); ++k) list.push_back(line(seeder, *lines, k));
    return list;
  }

  [[nodiscard]] Json seeders() const {
    Json list = Json::array();
    for (const Seeder& seeder : model_.seeders) {
      const auto in_file = std::find_if(project_.seeders.begin(), project_.seeders.end(),
                                        [&](const project::Seeder& s) { return s.name == seeder.name; });
      list.push_back({{"name", seeder.name},
                      {"type", project::word(in_file->type)},
                      {"path", fmt::format("seeder.{}", in_file - project_.seeders.begin())},
                      {"rocks", seeder.rocks},
                      {"first_rock", seeder.first_rock},
                      {"lines", lines(seeder)},
                      {"points", places(seeder)}});
    }
    return list;
  }

  [[nodiscard]] Json areas() const {
    Json list = Json::array();
    for (std::size_t k = 0; k < project_.areas.size(); ++k) {
      const project::Area& area = project_.areas[k];
      list.push_back({{"name", area.name},
                      {"path", fmt::format("area.{}", k)},
                      {"material", *project_.number_of_material(area.material)},
                      {"sides", sides(area.polygon)}});
    }
    return list;
  }

  /// Those that are drawn on plan, not those of files.
  [[nodiscard]] Json forests() const {
    Json list = Json::array();
    for (std::size_t k = 0; k < project_.forests.size(); ++k) {
      const project::ForestArea& forest = project_.forests[k];
      if (forest.polygon.empty()) continue;
      list.push_back({{"name", forest.name}, {"path", fmt::format("forest.{}", k)}, {"sides", sides(forest.polygon)}});
    }
    return list;
  }

  [[nodiscard]] Json barriers() const {
    Json list = Json::array();
    std::size_t count = 0, collectors = 0;
    for (const Barrier& barrier : model_.barriers) {
      const char* kind = barrier.is_collector ? "collector" : "barrier";
      Json foot = Json::array(), top = Json::array();
      const auto add = [&](const Vec3& at, const Panel& panel) {
        const bool is_flat = model_.laws.in_section;
        const Vec3 of_plane = is_flat ? Vec3(1, 0, 1) : Vec3(1, 1, 1);
        Json low = place(at.times(of_plane));
        Json high = place((at + panel.height * panel.up).times(of_plane));
        if (!foot.empty() && (is_flat || (foot.back() == low && top.back() == high))) return;
        foot.push_back(std::move(low));
        top.push_back(std::move(high));
      };
      for (const Panel& panel : barrier.panels()) {
        add(panel.foot, panel);
        add(panel.foot + panel.length * panel.along, panel);
      }
      list.push_back({{"name", barrier.name},
                      {"kind", kind},
                      {"path", fmt::format("{}.{}", kind, barrier.is_collector ? collectors++ : count++)},
                      {"height_m", barrier.panels().empty() ? 0 : barrier.panels().front().height},
                      {"capacity_kJ",
                       barrier.is_collector || std::isinf(barrier.capacity) ? Json() : Json(barrier.capacity / 1000)},
                      {"foot", std::move(foot)},
                      {"top", std::move(top)}});
    }
    return list;
  }

 private:
  /// A polygon's outline on the ground: a line per side, without the sides beyond the terrain.
  [[nodiscard]] Json sides(const std::vector<std::array<double, 2>>& polygon) const {
    const Vec2 origin = model_.frame.origin.xy();
    Json list = Json::array();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
      Json side = Json::array();
      for (const Vec3& p : on_ground(Vec2(from[0], from[1]) - origin, Vec2(to[0], to[1]) - origin)) {
        side.push_back(place(p));
      }
      if (!side.empty()) list.push_back(std::move(side));
    }
    return list;
  }

  /// A line as given, or draped over the ground if its rocks start at a height above it.
  [[nodiscard]] Json line(const Seeder& seeder, const ReleaseLines& lines, std::size_t number) const {
    Json list = Json::array();
    const auto points = lines.points_of(number);
    if (!seeder.above_surface) {
      for (const Vec3& p : points) list.push_back(place(p));
      return list;
    }
    const Vec3 above(0, 0, *seeder.above_surface);
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      for (const Vec3& p : on_ground(points[k].xy(), points[k + 1].xy())) list.push_back(place(p + above));
    return list;
  }

  [[nodiscard]] std::vector<Vec3> on_ground(const Vec2& from, const Vec2& to) const {
    if (const auto* mesh = std::get_if<TriangleMesh>(&*model_.surface)) return mesh->draped(from, to);
    if (const auto* raster = std::get_if<RasterSurface>(&*model_.surface)) return raster->draped(from, to);
    return on_profile(std::get<Profile>(*model_.surface), from.x(), to.x());
  }

  static std::vector<Vec3> on_profile(const Profile& profile, double from, double to) {
    std::vector<double> bends{from, to};
    for (std::uint32_t k = 0; k < profile.facet_count(); ++k) {
      const double x = profile.point_of({k}).x();
      if (x > std::min(from, to) && x < std::max(from, to)) bends.push_back(x);
    }
    std::sort(bends.begin(), bends.end());
    if (from > to) std::reverse(bends.begin(), bends.end());
    std::vector<Vec3> line;
    for (const double x : bends)
      if (const auto z = profile.elevation(x)) line.emplace_back(x, 0, *z);
    return line;
  }

  const project::Project& project_;
  const Model& model_;
};

}  // namespace

Json as_json(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Json description_of(const ShelvedModel& shelved) {
  const Model& model = shelved.model;
  const Describer describer(shelved);
  Json materials = Json::array();
  for (const Material& material : model.ground.materials()) materials.push_back(material.name);
  return {{"id", shelved.id},
          {"files", shelved.files},
          {"dimension", shelved.project.is_2d() ? 2 : 3},
          {"kind", std::visit([](const auto& surface) { return kind_of(surface); }, *model.surface)},
          {"rocks", model.rocks()},
          {"crs", crs_json(model.crs_wkt)},
          {"facets", std::visit([](const auto& surface) { return surface.facet_count(); }, *model.surface)},
          {"bounds", describer.bounds()},
          {"terrain_report", model.terrain_report},
          {"seeder_report", model.seeder_report},
          {"materials", std::move(materials)},
          {"areas", describer.areas()},
          {"forests", describer.forests()},
          {"seeders", describer.seeders()},
          {"barriers", describer.barriers()},
          {"project", project::echo(shelved.project)}};
}

}  // namespace talus::server
