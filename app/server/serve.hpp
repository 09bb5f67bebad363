#pragma once
// The workbench: a server on this machine for the page in the browser, and for scripts (docs/workbench-api.md).

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "http/limits.hpp"

namespace talus::server {

struct ServeOptions {
  std::filesystem::path folder = ".";  // to serve
  std::string project;                 // to open first, relative to the folder; empty: none
  int port = 8425;                     // 0: any free port
  Limits limits;
  /// Called with the address to open, once the server accepts requests.
  std::function<void(const std::string& address)> ready;
  const std::atomic<bool>* stop = nullptr;  // ends the server when set
  /// Called at the end if a thread still waits for a file that the system does not deliver. Only the end of the program
  /// can end such a thread. Everything is saved by then.
  std::function<void()> hangs;
};

/// Answers requests until `stop` is set. A run in progress is stopped then and keeps its results so far. Throws
/// BadInput if the folder does not exist or the port is not available.
void serve(const ServeOptions& options);

}  // namespace talus::server
