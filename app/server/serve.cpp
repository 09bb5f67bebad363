#include "serve.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "events.hpp"
#include "http/router.hpp"
#include "http/session.hpp"
#include "routes/routes.hpp"
#include "run_models.hpp"
#include "run_store.hpp"
#include "workplace.hpp"

namespace talus::server {

namespace {

using namespace std::chrono_literals;

// A page holds one stream of events and asks for a few things at a time; a slow reader holds one thread.
constexpr std::size_t threads = 64;

int bind(httplib::Server& server, int port) {
  if (port == 0) {
    if (const int any = server.bind_to_any_port("127.0.0.1"); any > 0) return any;
  } else if (server.bind_to_port("127.0.0.1", port)) {
    return port;
  }
  throw BadInput(Problem{.where = "--port",
                         .what = fmt::format("port {} cannot be had", port),
                         .why = "another program listens there, perhaps another `talus serve`",
                         .hint = "Name another one, or 0 for any that is free"});
}

}  // namespace

void serve(const ServeOptions& options) {
  std::error_code error;
  if (!std::filesystem::is_directory(options.folder, error))
    throw BadInput(Problem{.file = options.folder.string(), .what = "is no folder"});
  const Workplace workplace(options.folder);
  EventHub events;

  httplib::Server server;
  server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
  server.set_tcp_nodelay(true);
  server.set_keep_alive_max_count(10'000);
  server.set_write_timeout(30s);
  const int port = bind(server, options.port);
  Session session(options.key_file.empty() ? usual_key_file() : options.key_file, port);
  Router router(server, session, {});
  RunStore runs(workplace, events);
  RunModels run_models(workplace);
  router.listens_on(port);
  server.set_payload_max_length(router.limits().upload_bytes);

  const auto address = [&] { return fmt::format("http://127.0.0.1:{}/?token={}", port, session.new_token()); };
  add_about_routes(router, workplace, options.project);
  add_file_routes(router, workplace);
  add_project_routes(router, workplace);
  add_example_routes(router, workplace);
  ModelShelf shelf;
  add_model_routes(router, workplace, shelf);
  add_run_routes(router, runs, events);
  add_result_routes(router, runs, run_models);
  add_model_tile_routes(router, shelf);
  add_model_query_routes(router, shelf);
  add_shape_routes(router);
  add_verification_routes(router);
  add_page_routes(router, server, session, address);  // last: it takes every path that is left

  std::atomic<bool> ends{false};
  std::thread watch([&] {
    while (!ends && (options.stop == nullptr || !*options.stop)) std::this_thread::sleep_for(50ms);
    events.close();
    runs.close();
    server.stop();
  });
  // Connections are taken from the moment of binding; they are answered as soon as this thread listens.
  if (options.ready) options.ready(address());
  server.listen_after_bind();
  ends = true;
  watch.join();
}

}  // namespace talus::server
