#include "routes/routes.hpp"
#include "talus/project/document.hpp"
#include "talus/project/material_library.hpp"
#include "talus/project/schema.hpp"

namespace talus::server {

void add_about_routes(Router& router, const Workplace& workplace, const std::string& project) {
  router.get("/api/about", [&router, &workplace, project](const Call&) {
    return json_answer({{"version", TALUS_VERSION},
                        {"folder", workplace.folder().string()},
                        {"project", project.empty() ? Json() : Json(project)},
                        {"limits",
                         {{"upload_bytes", router.limits().upload_bytes}, {"project_bytes", project::most_bytes}}}});
  });
  router.get("/api/settings", [](const Call&) { return json_answer(project::schema()); });
  router.get("/api/materials", [](const Call&) {
    Json list = Json::array();
    for (const project::LibraryMaterial& material : project::material_library()) {
      list.push_back({{"key", material.key}, {"meaning", material.meaning}, {"given", material.given},
                      {"source", material.source}});
    }
    return json_answer({{"materials", list}});
  });
}

}  // namespace talus::server
