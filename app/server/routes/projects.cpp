// Projects as files: names, deletion, pictures.

#include "project_files.hpp"
#include "project_picture.hpp"
#include "routes/routes.hpp"

namespace talus::server {

namespace {

// The ids that new_folder() makes; no dots, which would lead out of the folder.
const std::string one_deleted = "/api/deleted/([0-9-]+)";

Json json_of(const DeletedProject& project) {
  return {{"id", project.id}, {"file", project.file}, {"deleted", project.when}, {"runs", project.runs}};
}

}  // namespace

void add_projects_routes(Router& router, const Workplace& workplace, ProjectFiles& projects) {
  router.patch("/api/projects/(.+)", [&projects](const Call& call) {
    call.only({"name"});
    return json_answer({{"file", projects.rename(call.part(1), call.text("name"))}});
  });
  router.remove("/api/projects/(.+)",
                [&projects](const Call& call) { return json_answer(json_of(projects.remove(call.part(1)))); });
  router.get("/api/deleted", [&projects](const Call&) {
    Json list = Json::array();
    for (const DeletedProject& project : projects.deleted()) list.push_back(json_of(project));
    return json_answer({{"deleted", std::move(list)}});
  });
  router.post(one_deleted + "/restore", [&projects](const Call& call) {
    call.only({});
    return json_answer({{"file", projects.restore(call.part(1))}});
  });
  router.remove(one_deleted, [&projects](const Call& call) {
    projects.erase(call.part(1));
    return json_answer({{"id", call.part(1)}});
  });
  router.get("/api/pictures/(.+)", [&workplace](const Call& call) { return picture_of(workplace, call.part(1)); });
  router.upload("/api/pictures/(.+)",
                [&workplace](const httplib::Request& request, const httplib::ContentReader& content) {
                  save_picture(workplace, request.matches[1].str(), content);
                  return json_answer(Json::object());
                });
}

}  // namespace talus::server
