#include "serve.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>

#include "asked_runs.hpp"
#include "drawn_layers.hpp"
#include "events.hpp"
#include "http/router.hpp"
#include "http/session.hpp"
#include "http/web_server.hpp"
#include "model_reading.hpp"
#include "project_files.hpp"
#include "routes/routes.hpp"
#include "run_models.hpp"
#include "run_store.hpp"
#include "talus/core/memory.hpp"
#include "what_if_jobs.hpp"
#include "workplace.hpp"

namespace talus::server {

namespace {

using namespace std::chrono_literals;

// A page sends a few requests at a time. A client that reads slowly holds a thread for a while and must not block
// others.
constexpr std::size_t most_threads = 500;

constexpr std::size_t share_of_models = 8;  // an eighth of the memory each for models of pages, of runs, and layers
constexpr auto time_to_end = 1s;            // for requests in progress

// The library's own settings are a backlog of five connections, and a port that another server may share.
constexpr int most_waiting = 512;

int bind(httplib::Server& server, int port) {
  const auto listening = std::make_shared<int>(-1);
  server.set_socket_options([listening](int socket) {
    *listening = socket;
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  errno = 0;
  const int bound = port == 0                                ? server.bind_to_any_port("127.0.0.1")
                    : server.bind_to_port("127.0.0.1", port) ? port
                                                             : -1;
  const int why = errno;
  if (bound > 0 && listen(*listening, most_waiting) == 0) return bound;
  const std::string what = fmt::format("cannot listen on port {}", port);
  if (why == EACCES || why == EPERM) {
    throw BadInput(Problem{.where = "--port",
                           .what = what,
                           .why = std::system_category().message(why),
                           .hint = "Ports from 1024 on need no special rights"});
  }
  throw BadInput(Problem{.where = "--port",
                         .what = what,
                         .why = "another program uses it, perhaps another `talus serve`",
                         .hint = "Choose another port, or 0 for any free one"});
}

}  // namespace

void serve(const ServeOptions& options) {
  std::error_code error;
  if (!std::filesystem::is_directory(options.folder, error))
    throw BadInput(Problem{.file = options.folder.string(), .what = "is not a folder"});
  const Workplace workplace(options.folder);
  EventHub events;

  WebServer server(options.limits, most_threads);
  server.set_tcp_nodelay(true);
  const int port = bind(server, options.port);
  Session session(port);
  Router router(server, session, options.limits);
  ModelReading reading(options.limits.reading_time);
  RunStore runs(workplace, events, reading);
  RunModels run_models(workplace, reading, usable_memory() / share_of_models);
  AskedRuns asked(run_models);
  WhatIfJobs what_ifs;
  router.set_port(port);
  server.set_payload_max_length(std::max(router.limits().upload_bytes, router.limits().json_bytes));

  const auto address = [&] { return fmt::format("http://127.0.0.1:{}/?token={}", port, session.new_token()); };
  add_about_routes(router, workplace, options.project);
  add_file_routes(router, workplace);
  add_project_routes(router, workplace);
  ProjectFiles projects(workplace, runs);
  add_projects_routes(router, workplace, projects);
  add_example_routes(router, workplace);
  ModelShelf shelf(reading, usable_memory() / share_of_models);
  add_model_routes(router, workplace, shelf);
  add_run_routes(router, runs, events);
  add_calibration_routes(router, runs);
  add_observation_routes(router, workplace, shelf, runs, reading);
  add_result_routes(router, runs, run_models, asked, what_ifs);
  add_model_tile_routes(router, shelf);
  add_model_query_routes(router, shelf);
  add_line_file_routes(router, workplace, shelf, reading);
  DrawnLayers layers(reading, usable_memory() / share_of_models);
  add_layer_routes(router, workplace, shelf, layers, reading);
  add_shape_routes(router);
  add_verification_routes(router);
  add_page_routes(router, server, session, address);  // last: it matches every remaining path
  router.refuse_other_bodies();

  const std::jthread watch([&](const std::stop_token& has_ended) {
    const auto wait_until = [&](const auto& condition) {
      while (!has_ended.stop_requested() && !condition()) std::this_thread::sleep_for(50ms);
    };
    wait_until([&] { return options.stop != nullptr && *options.stop; });
    events.close();
    what_ifs.close();
    runs.close();
    wait_until([&] { return server.is_running(); });  // the library ignores an earlier stop
    server.stop();
    server.end_connections();
    const auto end = std::chrono::steady_clock::now() + time_to_end;
    wait_until([&] { return std::chrono::steady_clock::now() > end; });
    // Everything is saved, but a thread still waits for the system.
    if (!has_ended.stop_requested() && options.hangs) options.hangs();
  });
  struct Ending {
    WebServer& server;
    ModelReading& reading;
    Ending(WebServer& of_requests, ModelReading& of_models) : server(of_requests), reading(of_models) {}
    Ending(const Ending&) = delete;
    Ending& operator=(const Ending&) = delete;
    ~Ending() {
      server.end_connections();
      server.wait();
      const auto end = std::chrono::steady_clock::now() + time_to_end;
      while (reading.threads() > 0 && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(10ms);
    }
  };
  std::optional<Ending> ending(std::in_place, server, reading);  // destroyed before the objects that requests use
  // The system accepts connections since bind(); they are answered as soon as this thread listens.
  if (options.ready) options.ready(address());
  server.listen_after_bind();
  ending.reset();
  if (reading.threads() > 0 && options.hangs) options.hangs();
}

}  // namespace talus::server
