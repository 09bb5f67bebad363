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
    Json list = Json::array();
    for (const project::LibraryMaterial& entry : project::material_library()) {
      project::Material material = entry.material;
      Json values = Json::object();
      for (const std::string& key : entry.given)
        values[key] = *project::written(project::setting("material", key).slot(&material), false);
      list.push_back({{"key", entry.key},
                      {"name", entry.meaning},
                      {"values", std::move(values)},
                      {"source", entry.source},
                      {"checked", entry.checked}});
    }
    return json_answer({{"materials", list}});
  });
}

}  // namespace talus::server
