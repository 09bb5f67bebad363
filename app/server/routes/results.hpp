#pragma once
// Routes for results of a run, one file per kind.

#include <string>

#include "asked_runs.hpp"
#include "http/router.hpp"
#include "run_models.hpp"
#include "run_store.hpp"

namespace talus::server {

class WhatIfJobs;

/// The path of one run.
inline const std::string one_run = R"(/api/runs/([A-Za-z0-9._-]+))";

void add_file_result_routes(Router& router, RunStore& runs);
void add_rock_routes(Router& router, RunStore& runs, RunModels& models, AskedRuns& asked);
void add_statistics_routes(Router& router, RunStore& runs, AskedRuns& asked);
void add_line_routes(Router& router, RunStore& runs, AskedRuns& asked);
void add_what_if_routes(Router& router, RunStore& runs, AskedRuns& asked, WhatIfJobs& jobs);
void add_map_routes(Router& router, RunStore& runs);

}  // namespace talus::server
