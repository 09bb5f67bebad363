#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "answer.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "standard_streams.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/ordinary_file.hpp"

#ifdef TALUS_HAS_SERVER
#include "server/serve.hpp"
#endif

extern char** environ;

namespace talus::cli {

namespace {

struct ServeOptions {
  std::filesystem::path project;  // or a folder; empty: the current folder
  int port = 8425;
  bool open = false;
};

}  // namespace

#ifdef TALUS_HAS_SERVER

namespace {

std::atomic<bool> shutdown_wanted{false};
extern "C" void stop_serving(int signal) {
  if (shutdown_wanted.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

/// A temporary page that redirects to the address. The address itself is not passed on a command line, which all users
/// of the machine can read. The page is in a folder that only this user may enter, and is removed with the object.
class OpeningPage {
 public:
  explicit OpeningPage(const std::string& address) {
    std::string folder = (std::filesystem::temp_directory_path() / "talus-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) return;
    folder_ = folder;
    std::ofstream(folder_ / "workbench.html") << fmt::format(
        "<!doctype html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0; url={0}\">"
        "<title>Talus</title><a href=\"{0}\">Open the workbench</a>\n",
        address);
  }
  OpeningPage(const OpeningPage&) = delete;
  OpeningPage& operator=(const OpeningPage&) = delete;
  ~OpeningPage() {
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  [[nodiscard]] std::string file() const { return folder_.empty() ? "" : (folder_ / "workbench.html").string(); }

 private:
  std::filesystem::path folder_;
};

/// Uses the system's default browser. The server works without one.
void open_in_browser(const OpeningPage& page) {
  std::string program = "xdg-open", argument = page.file();
  if (argument.empty()) return to_stderr("cannot open a browser: there is no folder for temporary files\n");
  std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    to_stderr("cannot open a browser: xdg-open is missing\n");
}

}  // namespace

static int serve(const ServeOptions& options) {
  server::ServeOptions how;
  std::error_code error;
  if (std::filesystem::is_directory(options.project, error)) {
    how.folder = options.project;
  } else if (!options.project.empty()) {
    if (not_an_ordinary_file(options.project))
      throw BadInput(Problem{.file = options.project.string(),
                             .what = "this is not a regular file",
                             .why = "expected a project file, for example slope.toml"});
    if (!std::filesystem::exists(options.project, error))
      throw BadInput(Problem{.file = options.project.string(),
                             .what = "there is no such file",
                             .hint = "`talus new` writes a project to start from"});
    const std::filesystem::path whole = std::filesystem::absolute(options.project);
    how.folder = whole.parent_path();
    how.project = whole.filename().string();
  }
  std::optional<OpeningPage> page;
  how.port = options.port;
  how.stop = &shutdown_wanted;
  how.ready = [&](const std::string& address) {
    fmt::print(
        "The workbench is at {}\nOnly this machine can reach it, and the address works once. Press Ctrl-C to stop.\n",
        address);
    flush_output();
    if (options.open) open_in_browser(page.emplace(address));
  };
  how.hangs = [&] {
    page.reset();
    std::fflush(nullptr);
    std::_Exit(done);
  };
  std::signal(SIGCHLD, SIG_IGN);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, stop_serving);
  catch_hangup(stop_serving);
  take_available_threads();
  server::serve(how);
  return done;
}

#else

static int serve(const ServeOptions&) {
  throw BadInput(Problem{.where = "serve",
                         .what = "this program was built without the workbench",
                         .hint = "Build it with -DTALUS_SERVER=ON"});
}

#endif

Command add_serve(CLI::App& app) {
  const auto options = std::make_shared<ServeOptions>();
  CLI::App* command =
      app.add_subcommand("serve", "Start the workbench: build models, run them and explore results in the browser");
  command
      ->add_option("project", options->project,
                   "Project to open first, or working folder (default: the current folder)")
      ->check(names_file)
      ->type_name("PROJECT.toml");
  command->add_option("--port", options->port, "Port on this machine (0: any free port)")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--open", options->open, "Also open the browser");
  return {command, [options] { return serve(*options); }};
}

}  // namespace talus::cli
