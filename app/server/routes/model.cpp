#include <fmt/format.h>

#include <array>
#include <unordered_map>
#include <vector>

#include "http/arrays.hpp"
#include "model_description.hpp"
#include "model_shelf.hpp"
#include "routes/routes.hpp"
#include "run_model.hpp"
#include "talus/project/problem_paths.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_cells = 250'000;  // of a raster; larger ones are sent as tiles, not as triangles

Answer answer_of(const Workplace& workplace, const fs::path& file, const std::string& text, const Problems& problems,
                 Json model) {
  return json_answer({{"problems", as_json(seen_from(workplace.folder(), project::with_paths(problems, text, file)))},
                      {"model", std::move(model)}});
}

Json profile_json(const Model& model, const Profile& profile) {
  Json vertices = Json::array(), materials = Json::array(), segments = Json::array();
  const auto add = [&](const Vec3& local) {
    const Vec3 p = model.frame.global_from_local(local);
    vertices.push_back({p.x(), p.z()});
  };
  for (std::uint32_t k = 0; k < profile.facet_count(); ++k) {
    const Outline outline = profile.outline({k});
    if (k == 0) add(outline.edges[0].point);
    add(outline.edges[1].point);
    materials.push_back(model.ground.material_of(profile.source({k})).index);
    segments.push_back(model.parts.of(profile.source({k})));
  }
  return {{"vertices", std::move(vertices)}, {"materials", std::move(materials)}, {"segments", std::move(segments)}};
}

/// Triangles with shared vertices: equal corners become one vertex.
class SharedVertices {
 public:
  explicit SharedVertices(std::size_t triangles) {
    numbers_.reserve(triangles / 2 + 3);
    triangles_.reserve(3 * triangles);
    parts_.reserve(triangles);
    materials_.reserve(triangles);
  }
  void add(const Triangle& triangle, std::uint32_t part, MaterialId material) {
    for (const Vec3& corner : triangle) triangles_.push_back(vertex(corner));
    parts_.push_back(part);
    materials_.push_back(material.index);
  }
  [[nodiscard]] Answer answer(const Model& model) const {
    Arrays arrays(Json{{"origin", as_json(model.frame.origin)}, {"parts", model.parts.count}});
    arrays.add("positions", std::span<const float>(positions_));
    arrays.add("triangles", std::span<const std::uint32_t>(triangles_));
    arrays.add("parts", std::span<const std::uint32_t>(parts_));
    arrays.add_smallest("materials", materials_, model.ground.materials().size());
    return arrays.answer();
  }

 private:
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& p) const {
      std::size_t hash = 0;
      for (const double x : p) hash = hash * 0x9e3779b97f4a7c15U + std::hash<double>()(x);
      return hash;
    }
  };
  std::uint32_t vertex(const Vec3& p) {
    const auto [found, is_new] = numbers_.try_emplace({p.x(), p.y(), p.z()}, numbers_.size());
    if (is_new)
      for (const double x : coordinates(p)) positions_.push_back(static_cast<float>(x));
    return found->second;
  }

  std::unordered_map<std::array<double, 3>, std::uint32_t, Hash> numbers_;
  std::vector<float> positions_;
  std::vector<std::uint32_t> triangles_, parts_, materials_;
};

Answer mesh_answer(const Model& model) {
  SharedVertices vertices(std::visit([](const auto& surface) { return surface.facet_count(); }, *model.surface));
  const auto add = [&](const auto& surface, FacetId facet) {
    const std::uint32_t source = surface.source(facet);
    vertices.add(surface.triangle(facet), model.parts.of(source), model.ground.material_of(source));
  };
  if (const auto* mesh = std::get_if<TriangleMesh>(&*model.surface)) {
    for (std::uint32_t k = 0; k < mesh->facet_count(); ++k) add(*mesh, {k});
    return vertices.answer(model);
  }
  const auto* raster = std::get_if<RasterSurface>(&*model.surface);
  if (raster == nullptr) throw Refusal(404, "mesh", "this model is a section", "", "Request its profile");
  if (raster->cell_count() > most_cells) {
    throw Refusal(404, "mesh", fmt::format("the raster has {} cells", raster->cell_count()),
                  fmt::format("only rasters up to {} are sent as triangles", most_cells), "Request its tiles");
  }
  const std::size_t columns = raster->grid().columns - 1;
  for (std::uint32_t k = 0; k < raster->facet_count(); ++k)
    if (raster->has_data(k / 2 % columns, k / 2 / columns)) add(*raster, {k});
  return vertices.answer(model);
}

}  // namespace

void add_model_routes(Router& router, const Workplace& workplace, ModelShelf& shelf) {
  router.post("/api/model", [&](const Call& call) {
    call.only({"file", "text"});
    const std::string text = call.text("text");
    const fs::path file = workplace.project(call.text("file"));
    try {
      const ModelShelf::Held held = shelf.build(file, text);
      return answer_of(workplace, file, text, held->warnings, description_of(*held));
    } catch (const BadInput& bad) {
      return answer_of(workplace, file, text, bad.problems(), nullptr);
    }
  });
  router.get("/api/models/([0-9a-f]+)/profile", [&](const Call& call) {
    const ModelShelf::Held held = shelf.find(call.part(1));
    const auto* profile = std::get_if<Profile>(&*held->model.surface);
    if (profile == nullptr) throw Refusal(404, "profile", "this model is not a section", "", "Request its mesh");
    return json_answer(profile_json(held->model, *profile));
  });
  router.get("/api/models/([0-9a-f]+)/mesh",
             [&](const Call& call) { return mesh_answer(shelf.find(call.part(1))->model); });
}

}  // namespace talus::server
