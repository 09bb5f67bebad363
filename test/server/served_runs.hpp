#pragma once
// A server with runs.

#include "server/served.hpp"

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>

#include "cli/program.hpp"

namespace talus::testing_tools {

class ServedRuns : public Served {
 protected:
  using Served::Served;

  static std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Tutorial 1 in section, without what takes long to write.
  static std::string section() { return text_of(test::tutorial("2d")) + "\n[output]\npaths = 20\nreport = false\n"; }

  /// Asks for a run; gives its id.
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

  /// The run, as soon as it is so.
  Json wait(const std::string& id, const std::function<bool(const Json&)>& is) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(10);
    for (;;) {
      Json now = run(id);
      if (is(now)) return now;
      if (std::chrono::steady_clock::now() > end) {
        ADD_FAILURE() << "it never came to that: " << now.dump();
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

  std::string file_ = "slope.toml";
};

}  // namespace talus::testing_tools
