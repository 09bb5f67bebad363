#pragma once
// A server with runs of a small project.

#include "server/served.hpp"

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <thread>

#include "cli/program.hpp"
#include "cli/run_files.hpp"

namespace talus::testing_tools {

class ServedRuns : public Served {
 protected:
  using Served::Served;

  static std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Tutorial 1 in section, without the results that take long to write.
  static std::string section() { return text_of(test::tutorial("2d")) + "\n[output]\npaths = 20\nreport = false\n"; }

  /// Requests a run; returns its id.
  [[nodiscard]] std::string begin(const std::string& text, Json more = Json::object()) const {
    more["file"] = file_;
    more["text"] = text;
    const Reply reply = post("/api/runs", more);
    EXPECT_EQ(reply.status, 202) << reply.body;
    return reply.status == 202 ? reply.json()["id"].get<std::string>() : "";
  }
  [[nodiscard]] Json run(const std::string& id) const { return get("/api/runs/" + id).json(); }
  [[nodiscard]] Json list() const { return get("/api/runs").json()["runs"]; }
  [[nodiscard]] Reply ask(const std::string& id, const char* what) const {
    return post("/api/runs/" + id + "/" + what, Json::object());
  }

  /// Waits until the condition is true of the run, and returns the run.
  Json wait(const std::string& id, const std::function<bool(const Json&)>& condition) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(10);
    for (;;) {
      Json now = run(id);
      if (condition(now)) return now;
      if (std::chrono::steady_clock::now() > end) {
        ADD_FAILURE() << "still not true: " << now.dump();
        return now;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  Json wait_for(const std::string& id, const std::string& state) const {
    return wait(id, [&](const Json& now) { return now["state"] == state || now["state"] == "failed"; });
  }
  Json wait_for_rocks(const std::string& id) const {
    return wait(id, [](const Json& now) { return now["state"] != "waiting" && now["done"] > 0; });
  }
  [[nodiscard]] std::filesystem::path folder_of(const std::string& id) const {
    return path(run(id)["folder"].get<std::string>());
  }
  /// The files of a run's folder without those that only the server writes.
  [[nodiscard]] std::map<std::string, std::string> files_of(const std::string& id) const {
    auto files = test::files_of(folder_of(id));
    EXPECT_EQ(files.erase("run.json") + files.erase("project.toml"), 2U);
    return files;
  }
  /// The files that `talus run` writes for the project.
  [[nodiscard]] std::map<std::string, std::string> files_of_program(const std::string& text,
                                                                    const std::string& more = "") const {
    write("slope.toml", text);
    const test::Said said =
        test::talus_says("run " + path("slope.toml").string() + " --quiet -o " + (base_ / "expected").string() + more);
    EXPECT_EQ(said.exit_code, 0) << said.text;
    return test::files_of(base_ / "expected");
  }

  std::string file_ = "slope.toml";
};

}  // namespace talus::testing_tools
