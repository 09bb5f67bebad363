#include "pdf_printing.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "stop_signals.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/output_file.hpp"

extern char** environ;

namespace talus::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes patience(5);

std::optional<fs::path> program_on_path(std::string_view name) {
  const char* const path = std::getenv("PATH");
  std::string_view left = path != nullptr ? path : "";
  while (!left.empty()) {
    const std::size_t colon = left.find(':');
    const std::string_view folder = left.substr(0, colon);
    left = colon == std::string_view::npos ? std::string_view() : left.substr(colon + 1);
    if (folder.empty()) continue;  // the current folder is not searched
    fs::path program = fs::path(folder) / name;
    std::error_code error;
    if (fs::is_regular_file(program, error) && access(program.c_str(), X_OK) == 0) return program;
  }
  return std::nullopt;
}

fs::path browser() {
  if (const char* const named = std::getenv("CHROME"); named != nullptr && *named != '\0') {
    const std::string_view name(named);
    if (name.find('/') == std::string_view::npos) {
      if (auto program = program_on_path(name)) return *program;
    } else if (access(named, X_OK) == 0) {
      return named;
    }
    throw BadInput(Problem{.where = "--pdf",
                           .what = fmt::format("the environment variable CHROME is \"{}\"", name),
                           .why = "there is no such program",
                           .hint = "Set it to the path of Chromium or Chrome, or unset it"});
  }
  for (const char* name : {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"}) {
    if (auto program = program_on_path(name)) return *program;
  }
  throw BadInput(Problem{.where = "--pdf",
                         .what = "there is no browser to print the report with",
                         .why = "neither Chromium nor Chrome is on the PATH",
                         .hint = "Install one (Debian: apt install chromium) or name it in the environment variable "
                                 "CHROME; or open report.html in any browser and print it to a file"});
}

/// A file as an address, with every byte escaped that has a meaning there.
std::string address_of(const fs::path& file) {
  std::string address = "file://";
  for (const char c : fs::absolute(file).string()) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("/-_.~", c) != nullptr;
    address += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return address;
}

/// The process and all that it starts, as a process group.
class BrowserProcess {
 public:
  /// What it prints goes to the file `said`.
  BrowserProcess(std::vector<std::string> words, const fs::path& said) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    error_ = posix_spawn(&process_, words.front().c_str(), &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error_ != 0) process_ = -1;
  }
  BrowserProcess(const BrowserProcess&) = delete;
  BrowserProcess& operator=(const BrowserProcess&) = delete;
  ~BrowserProcess() {
    if (process_ <= 0) return;
    kill(-process_, SIGKILL);
    while (!has_ended_ && waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  }

  [[nodiscard]] int error() const { return error_; }
  [[nodiscard]] bool has_ended() {
    if (has_ended_) return true;
    const pid_t ended = waitpid(process_, nullptr, WNOHANG);
    has_ended_ = ended == process_ || (ended < 0 && errno == ECHILD);  // the caller may have set SIGCHLD to be ignored
    return has_ended_;
  }

 private:
  pid_t process_ = -1;
  int error_ = 0;
  bool has_ended_ = false;
};

/// The last line of what the browser said about an error.
std::string last_error(const fs::path& said) {
  std::ifstream in(said);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  constexpr std::size_t most = 300;
  return last.substr(0, most);
}

/// Whether the file begins and ends as a PDF file does: a browser that is killed leaves a part.
bool is_whole_pdf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff bytes = in.tellg();
  constexpr std::streamoff tail = 32;
  if (!in || bytes < tail) return false;
  std::string begin(5, '\0'), end(static_cast<std::size_t>(tail), '\0');
  in.seekg(0).read(begin.data(), 5);
  in.seekg(bytes - tail).read(end.data(), tail);
  return in && begin == "%PDF-" && end.find("%%EOF") != std::string::npos;
}

}  // namespace

PdfPrinting::PdfPrinting(const fs::path& pdf) : browser_(browser()), pdf_(place_of_file(pdf)) {
  // Beside the result, not in /tmp: a browser from a confined package may read the user's folders only.
  std::string pattern = pdf_.string() + ".XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) {
    throw BadInput(Problem{.file = pdf.string(), .what = "cannot be written", .why = std::strerror(errno)});
  }
  folder_ = pattern;
}

PdfPrinting::~PdfPrinting() {
  // A process of the browser that is just being killed may still write.
  std::error_code error;
  for (int k = 0; k < 50; ++k) {
    fs::remove_all(folder_, error);
    if (!error && !fs::exists(folder_, error)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

bool PdfPrinting::print() const {
  const fs::path printed = folder_ / "report.pdf", said = folder_ / "said";
  std::vector<std::string> words{browser_.string(),
                                 "--headless",
                                 "--disable-gpu",
                                 "--disable-dev-shm-usage",  // small in containers
                                 "--disable-extensions",
                                 "--disable-sync",
                                 "--disable-background-networking",
                                 "--disable-component-update",
                                 "--host-resolver-rules=MAP * ~NOTFOUND",
                                 "--no-first-run",
                                 "--no-pdf-header-footer",
                                 fmt::format("--user-data-dir={}", fs::absolute(folder_ / "profile").string()),
                                 fmt::format("--print-to-pdf={}", fs::absolute(printed).string())};
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // which Chromium refuses to set up for root
  words.push_back(address_of(page()));
  const auto fail = [&](std::string why) {
    throw BadInput(Problem{.where = "--pdf",
                           .what = fmt::format("{} did not print the report", browser_.string()),
                           .why = std::move(why),
                           .hint = "Open report.html in a browser and print it to a file"});
  };
  {
    BrowserProcess process(std::move(words), said);
    if (process.error() != 0) fail(std::strerror(process.error()));
    const auto begin = std::chrono::steady_clock::now();
    while (!process.has_ended()) {
      if (stop_wanted()) return false;
      if (std::chrono::steady_clock::now() - begin > patience) fail("it took longer than five minutes");
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  if (!is_whole_pdf(printed)) fail(last_error(said));
  finish_file(printed, pdf_);
  return true;
}

}  // namespace talus::cli
