#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "results/run_summary.hpp"
#include "routes/results.hpp"
#include "routes/routes.hpp"
#include "talus/archive/run_state.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

/// The files of `talus run` and the project, without internal files of the server and the run.
std::vector<std::pair<std::string, std::uintmax_t>> files_of(const fs::path& folder) {
  std::vector<std::pair<std::string, std::uintmax_t>> files;
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator(folder, error);
       !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    const std::string name = path.lexically_relative(folder).generic_string();
    std::error_code ignored;
    if (entry->is_symlink(ignored) || !entry->is_regular_file(ignored)) continue;
    if (name == run_file_name || name == run_state_name || path.extension() == ".part" || name.starts_with('.'))
      continue;
    files.emplace_back(name, entry->file_size(ignored));
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Content-Disposition by RFC 6266, with the name in UTF-8 by RFC 8187.
std::string disposition(const std::string& name) {
  std::string text = "attachment; filename*=UTF-8''";
  for (const unsigned char c : fs::path(name).filename().string()) {
    const bool is_plain = std::isalnum(c) || c == '.' || c == '-' || c == '_';
    text += is_plain ? std::string(1, static_cast<char>(c)) : fmt::format("%{:02X}", c);
  }
  return text;
}

const char* type_of(const std::string& name) {
  if (name.ends_with(".csv")) return "text/csv; charset=utf-8";
  if (name.ends_with(".json")) return "application/json; charset=utf-8";
  return "application/octet-stream";
}

void send_file(const fs::path& path, const char* type, httplib::Response& response) {
  if (const auto why = not_an_ordinary_file(path)) throw Refusal(404, path.filename().string(), *why);
  auto file = std::make_shared<std::ifstream>(path, std::ios::binary);
  std::error_code error;
  const auto bytes = fs::file_size(path, error);
  if (!*file || error) throw Refusal(404, path.filename().string(), "cannot be read");
  if (bytes == 0) {
    response.set_content("", type);
    return;
  }
  response.set_content_provider(bytes, type, [file](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
    std::array<char, 1u << 16u> buffer;
    file->clear();
    file->seekg(static_cast<std::streamoff>(offset));
    file->read(buffer.data(), static_cast<std::streamsize>(std::min(length, buffer.size())));
    const auto read = static_cast<std::size_t>(file->gcount());
    return read > 0 && sink.write(buffer.data(), read);
  });
}

}  // namespace

void add_file_result_routes(Router& router, RunStore& runs) {
  router.stream(one_run + "/summary", [&runs](const httplib::Request& request, httplib::Response& response) {
    send_file(results_folder(runs.find(request.matches[1].str())) / "summary.json", "application/json; charset=utf-8",
              response);
  });
  router.get(one_run + "/files", [&runs](const Call& call) {
    Json list = Json::array();
    for (const auto& [name, bytes] : files_of(runs.find(call.part(1)).folder))
      list.push_back({{"name", name}, {"bytes", bytes}});
    return json_answer({{"files", std::move(list)}});
  });
  router.stream(one_run + "/files/(.+)", [&runs](const httplib::Request& request, httplib::Response& response) {
    const fs::path folder = runs.find(request.matches[1].str()).folder;
    const std::string name = request.matches[2].str();
    // Only listed names are served, so that none leads out of the folder.
    const auto files = files_of(folder);
    const bool is_listed =
        std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.first == name; });
    if (!is_listed) throw Refusal(404, name, "this run has no such file");
    response.set_header("Content-Disposition", disposition(name));
    send_file(folder / name, type_of(name), response);
  });
}

void add_result_routes(Router& router, RunStore& runs, RunModels& models, AskedRuns& asked, WhatIfJobs& what_ifs) {
  add_file_result_routes(router, runs);
  add_rock_routes(router, runs, models, asked);
  add_statistics_routes(router, runs, asked);
  add_line_routes(router, runs, asked);
  add_what_if_routes(router, runs, asked, what_ifs);
  add_map_routes(router, runs);
}

}  // namespace talus::server
