// Runs at the end of their server: by closing it, or by killing it.

#include "server/served_runs.hpp"

#include "cli/child.hpp"
#include "run_store.hpp"

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

using EndOfServer = ServedRuns;

/// A second store of the served folder.
struct Store {
  explicit Store(const std::filesystem::path& folder) : workplace(folder) {}

  server::Workplace workplace;
  server::EventHub events;
  server::ModelReading reading{std::chrono::minutes(1)};
  server::RunStore runs{workplace, events, reading};
};

TEST_F(EndOfServer, RefusesNewAndResumedRuns) {
  const std::string id = begin(section(), {{"rocks", 3'000'000}});
  (void)wait_for_rocks(id);
  (void)ask(id, "stop");
  (void)wait_for(id, "stopped");
  Store store(path(""));
  store.runs.close();
  const auto refusal = [&](const std::function<void()>& ask) -> std::string {
    try {
      ask();
    } catch (const server::Refusal& refused) {
      EXPECT_EQ(refused.status(), 503);
      return refused.what();
    }
    return "is accepted";
  };
  EXPECT_EQ(refusal([&] { store.runs.begin(server::RunOrder{.file = file_, .text = section()}); }),
            "slope.toml: cannot be run (the server is shutting down)");
  EXPECT_EQ(refusal([&] { store.runs.resume(id); }), id + ": cannot be resumed (the server is shutting down)");
  EXPECT_EQ(store.runs.list().size(), 1U);
  stop();
  start();
  EXPECT_EQ(list().size(), 1U);
  EXPECT_EQ(run(id)["state"], "stopped");
}

/// Waits for the address that a server in another process prints.
std::string address_in(const std::filesystem::path& said) {
  for (int k = 0; k < 2000; ++k, std::this_thread::sleep_for(std::chrono::milliseconds(5))) {
    std::ifstream in(said);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t begin = text.find("http://"), end = text.find('\n', begin);
    if (begin != std::string::npos && end != std::string::npos) return text.substr(begin, end - begin);
  }
  ADD_FAILURE() << "no address";
  return "";
}

TEST_F(EndOfServer, ByAKillLeavesRunsThatResumeToTheSameBytes) {
  stop();  // the server to kill runs in a process of its own
  const std::filesystem::path said = base_ / "said.txt";
  test::Child other({"serve", path("").string(), "--port", "0"}, said);
  const std::string address = address_in(said);
  const std::size_t slash = address.find("/?");
  port_ = std::stoi(address.substr(address.rfind(':') + 1));
  httplib::Client first("127.0.0.1", port_);
  const auto answer = first.Get(address.substr(slash));
  ASSERT_TRUE(answer);
  cookie_ = answer->get_header_value("Set-Cookie");
  cookie_ = cookie_.substr(0, cookie_.find(';'));

  const std::string id = begin(section(), {{"rocks", 60'000}}), waiting = begin(section());
  (void)wait_for_rocks(id);
  (void)ask(id, "stop");  // writes a checkpoint
  const std::uint64_t at_stop = wait_for(id, "stopped")["done"];
  (void)wait_for(waiting, "done");
  (void)ask(id, "resume");
  (void)wait(id, [&](const Json& now) { return now["done"] > at_stop; });
  other.signal(SIGKILL);
  (void)other.wait();

  start();
  const Json killed = run(id);
  EXPECT_EQ(killed["state"], "interrupted");
  EXPECT_EQ(killed["problems"].back()["what"], "the server ended while this run was in progress");
  EXPECT_GE(killed["done"], at_stop);
  // Its results are only written on request.
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(run(id)["has_results"], false);
  EXPECT_EQ(get("/api/runs/" + id + "/summary").status, 404);
  EXPECT_EQ(ask(id, "write").status, 202);
  Reply summary;
  for (int k = 0; k < 2000 && summary.status != 200; ++k) {
    summary = get("/api/runs/" + id + "/summary");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_EQ(summary.status, 200) << summary.body;
  EXPECT_EQ(summary.json()["rocks"]["done"], killed["done"]);
  EXPECT_EQ(get("/api/runs/" + id + "/statistics?of=x_m").json()["count"], killed["done"]);
  EXPECT_EQ(run(id)["state"], "interrupted");
  EXPECT_EQ(run(id)["has_results"], true);
  EXPECT_EQ(ask(id, "resume").status, 202);
  EXPECT_EQ(wait_for(id, "done")["done"], 60'000);
  EXPECT_EQ(test::differences(files_of(id), files_of_program(section(), " --rocks 60000")), "");
}

}  // namespace
}  // namespace talus
