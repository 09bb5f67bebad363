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

#include "events.hpp"
#include "http/router.hpp"
#include "http/session.hpp"
#include "http/web_server.hpp"
#include "model_reading.hpp"
#include "routes/routes.hpp"
#include "run_models.hpp"
#include "run_store.hpp"
#include "talus/core/memory.hpp"
#include "workplace.hpp"

namespace talus::server {

namespace {

using namespace std::chrono_literals;

// A page asks for a few things at a time. Whoever has a session and reads slowly holds a thread for a while, and must
// not keep others waiting.
constexpr std::size_t most_threads = 500;

constexpr std::size_t share_of_models = 8;  // of the memory: for models that are looked at, and for those of runs
constexpr auto time_to_end = 1s;            // for requests under way

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
  router.listens_on(port);
  server.set_payload_max_length(std::max(router.limits().upload_bytes, router.limits().json_bytes));

  const auto address = [&] { return fmt::format("http://127.0.0.1:{}/?token={}", port, session.new_token()); };
  add_about_routes(router, workplace, options.project);
  add_file_routes(router, workplace);
  add_project_routes(router, workplace);
  add_example_routes(router, workplace);
  ModelShelf shelf(reading, usable_memory() / share_of_models);
  add_model_routes(router, workplace, shelf);
  add_run_routes(router, runs, events);
  add_result_routes(router, runs, run_models);
  add_model_tile_routes(router, shelf);
  add_model_query_routes(router, shelf);
  add_shape_routes(router);
  add_verification_routes(router);
  add_page_routes(router, server, session, address);  // it takes every path that is left
  router.refuse_the_rest();

  const std::jthread watch([&](const std::stop_token& over) {
    const auto wait_until = [&](const auto& is) {
      while (!over.stop_requested() && !is()) std::this_thread::sleep_for(50ms);
    };
    wait_until([&] { return options.stop != nullptr && *options.stop; });
    events.close();
    runs.close();
    wait_until([&] { return server.is_running(); });  // a stop that comes before is forgotten
    server.stop();
    server.end_connections();
    const auto end = std::chrono::steady_clock::now() + time_to_end;
    wait_until([&] { return std::chrono::steady_clock::now() > end; });
    // All that is to be kept is on the disk, and a thread waits for what the system does not give.
    if (!over.stop_requested() && options.hangs) options.hangs();
  });
  struct Ending {
    WebServer& server;
    ModelReading& reading;
    ~Ending() {
      server.end_connections();
      server.wait();
      const auto end = std::chrono::steady_clock::now() + time_to_end;
      while (reading.left_alone() > 0 && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(10ms);
    }
  };
  std::optional<Ending> ending(std::in_place, server, reading);  // before what requests need goes
  // Connections are taken from the moment of binding; they are answered as soon as this thread listens.
  if (options.ready) options.ready(address());
  server.listen_after_bind();
  ending.reset();
  if (reading.left_alone() > 0 && options.hangs) options.hangs();
}

}  // namespace talus::server
