#include <map>
#include <string>
#include <vector>

#include "routes/routes.hpp"
#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/material_library.hpp"
#include "talus/project/schema.hpp"

namespace talus::server {

void add_about_routes(Router& router, const Workplace& workplace, const std::string& project) {
  router.get("/api/about", [&router, &workplace, project](const Call&) {
    return json_answer(
        {{"version", TALUS_VERSION},
         {"folder", workplace.folder().string()},
         {"workplace", workplace.identity()},
         {"project", project.empty() ? Json() : Json(project)},
         {"limits", {{"upload_bytes", router.limits().upload_bytes}, {"project_bytes", project::most_bytes}}}});
  });
  router.get("/api/settings", [](const Call&) { return json_answer(project::schema()); });
  router.get("/api/materials", [](const Call&) {
    const project::MaterialLibrary& library = project::material_library();
    Json list = Json::array();
    for (const project::LibraryMaterial& entry : library.materials) {
      project::Material material = entry.material;
      Json values = Json::object();
      std::map<std::size_t, std::vector<std::string>> keys_of_source;
      for (const auto& [key, source] : entry.given) {
        values[key] = *project::written(project::setting("material", key).slot(&material), false);
        keys_of_source[source].push_back(key);
      }
      Json sources = Json::array();
      for (const auto& [number, keys] : keys_of_source) {
        const auto& [text, limits, checked] = library.sources[number];
        sources.push_back({{"keys", keys}, {"text", text}, {"limits", limits}, {"checked", checked}});
      }
      list.push_back({{"key", entry.key},
                      {"name", entry.meaning},
                      {"values", std::move(values)},
                      {"sources", std::move(sources)}});
    }
    return json_answer({{"materials", std::move(list)}});
  });
}

}  // namespace talus::server
