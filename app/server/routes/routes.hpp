#pragma once
// The routes of the API, one file per subject; docs/workbench-api.md documents the requests.

#include <functional>
#include <string>

#include "http/router.hpp"
#include "model_shelf.hpp"
#include "workplace.hpp"

namespace talus::server {

class AskedRuns;
class DrawnLayers;
class EventHub;
class ProjectFiles;
class RunModels;
class RunStore;
class WhatIfJobs;

/// The page itself, and the start of a session. `address` returns one with a new token.
void add_page_routes(Router& router, httplib::Server& server, Session& session,
                     const std::function<std::string()>& address);
/// `project`: to open first; empty: none.
void add_about_routes(Router& router, const Workplace& workplace, const std::string& project);
void add_file_routes(Router& router, const Workplace& workplace);
void add_project_routes(Router& router, const Workplace& workplace);
/// Names, deletion and pictures of projects.
void add_projects_routes(Router& router, const Workplace& workplace, ProjectFiles& projects);
void add_example_routes(Router& router, const Workplace& workplace);
void add_model_routes(Router& router, const Workplace& workplace, ModelShelf& shelf);
void add_run_routes(Router& router, RunStore& runs, EventHub& events);
void add_calibration_routes(Router& router, RunStore& runs);
/// Observed blocks and marks beside a model and beside a run.
void add_observation_routes(Router& router, const Workplace& workplace, const ModelShelf& shelf, RunStore& runs,
                            ModelReading& reading);
void add_result_routes(Router& router, RunStore& runs, RunModels& models, AskedRuns& asked, WhatIfJobs& what_ifs);
void add_model_tile_routes(Router& router, const ModelShelf& shelf);
void add_model_query_routes(Router& router, const ModelShelf& shelf);
/// Lines and areas from vector files, in the coordinates of a model.
void add_line_file_routes(Router& router, const Workplace& workplace, const ModelShelf& shelf, ModelReading& reading);
/// Reference layers of a model, and contours of its terrain.
void add_layer_routes(Router& router, const Workplace& workplace, const ModelShelf& shelf, DrawnLayers& layers,
                      ModelReading& reading);
/// Geometry and distributions without a model.
void add_shape_routes(Router& router);
void add_verification_routes(Router& router);

}  // namespace talus::server
