#include "serve.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <memory>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>

#include "events.hpp"
#include "http/router.hpp"
#include "http/session.hpp"
#include "http/thread_pool.hpp"
#include "routes/routes.hpp"
#include "run_models.hpp"
#include "run_store.hpp"
#include "workplace.hpp"

namespace talus::server {

namespace {

using namespace std::chrono_literals;

// A page asks for a few things at a time. A connection that is silent, or that reads slowly, holds a thread for a
// while, and must not keep others waiting.
constexpr std::size_t most_threads = 2'000;

// The library lets five connections wait to be taken, and another server take the same port.
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
  const std::string what = fmt::format("port {} cannot be had", port);
  if (why == EACCES || why == EPERM) {
    throw BadInput(Problem{.where = "--port",
                           .what = what,
                           .why = std::system_category().message(why),
                           .hint = "Ports from 1024 on are free for all users"});
  }
  throw BadInput(Problem{.where = "--port",
                         .what = what,
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
  server.new_task_queue = [] { return new ThreadPool(most_threads); };
  server.set_tcp_nodelay(true);
  server.set_keep_alive_max_count(10'000);
  server.set_keep_alive_timeout(1);  // [s]: the program ends when the last connection that is silent is closed
  server.set_write_timeout(30s);
  const int port = bind(server, options.port);
  Session session(options.key_file.empty() ? usual_key_file() : options.key_file, port);
  Router router(server, session, options.limits);
  std::mutex building;  // models can be large: of those that requests have built, one at a time
  RunStore runs(workplace, events, building);
  RunModels run_models(workplace);
  router.listens_on(port);
  server.set_payload_max_length(std::max(router.limits().upload_bytes, router.limits().json_bytes));

  const auto address = [&] { return fmt::format("http://127.0.0.1:{}/?token={}", port, session.new_token()); };
  add_about_routes(router, workplace, options.project);
  add_file_routes(router, workplace);
  add_project_routes(router, workplace);
  add_example_routes(router, workplace);
  ModelShelf shelf(building);
  add_model_routes(router, workplace, shelf);
  add_run_routes(router, runs, events);
  add_result_routes(router, runs, run_models);
  add_model_tile_routes(router, shelf);
  add_model_query_routes(router, shelf);
  add_shape_routes(router);
  add_verification_routes(router);
  add_page_routes(router, server, session, address);  // last: it takes every path that is left

  const std::jthread watch([&](const std::stop_token& over) {
    const auto wait_until = [&](const auto& is) {
      while (!over.stop_requested() && !is()) std::this_thread::sleep_for(50ms);
    };
    wait_until([&] { return options.stop != nullptr && *options.stop; });
    events.close();
    runs.close();
    wait_until([&] { return server.is_running(); });  // a stop that comes before is forgotten
    server.stop();
  });
  // Connections are taken from the moment of binding; they are answered as soon as this thread listens.
  if (options.ready) options.ready(address());
  server.listen_after_bind();
}

}  // namespace talus::server
