#pragma once
// The workbench: a server on this machine for the page in the browser, and for scripts (docs/workbench-api.md).

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "http/limits.hpp"

namespace talus::server {

struct ServeOptions {
  std::filesystem::path folder = ".";  // that is worked in
  std::string project;                 // to open first, relative to the folder; empty: none
  int port = 8425;                     // 0: any that is free
  Limits limits;
  /// Called once requests are answered, with the address to open.
  std::function<void(const std::string& address)> ready;
  const std::atomic<bool>* stop = nullptr;  // set from outside
  /// Called at the end if something still waits for a file that the system does not give, which nothing can end but the
  /// end of the program. Nothing is left to be kept then.
  std::function<void()> hangs;
};

/// Answers requests until it is told to stop; a run under way is stopped then, and keeps what it has. Throws BadInput
/// where the folder or the port cannot be had.
void serve(const ServeOptions& options);

}  // namespace talus::server
