// Models are read in separate threads: a read that does not end blocks neither other requests nor the server's end.

#include "model_reading.hpp"

#include "server/served_runs.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <future>
#include <memory>
#include <thread>
#include <vector>

#include "http/answer.hpp"
#include "run_model.hpp"
#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"

namespace talus {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using server::ModelReading;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

/// Blocks readers until it is destroyed, like a drive that does not respond.
class Blockade {
 public:
  ~Blockade() { *has_ended_ = true; }
  [[nodiscard]] std::function<int()> reader() const {
    return [has_ended = has_ended_] {
      while (!*has_ended) std::this_thread::sleep_for(5ms);
      return 1;
    };
  }

 private:
  std::shared_ptr<std::atomic<bool>> has_ended_ = std::make_shared<std::atomic<bool>>(false);
};

struct Heavy {
  std::size_t bytes;
};

TEST(CachedModels, AreThoseThatFitTogetherAndAlwaysTheFirst) {
  const auto within = [](const std::vector<std::size_t>& bytes, std::size_t most) {
    std::vector<std::shared_ptr<const Heavy>> row;
    for (const std::size_t each : bytes) row.push_back(std::make_shared<const Heavy>(each));
    return server::count_within(row, most);
  };
  EXPECT_EQ(within({}, 10), 0U);
  EXPECT_EQ(within({11}, 10), 1U);
  EXPECT_EQ(within({11, 1}, 10), 1U);
  EXPECT_EQ(within({4, 6, 1}, 10), 2U);
  EXPECT_EQ(within({1, 1, 1, 1, 1}, 10), 5U);
}

TEST(CachedModels, IncludeBarriersInTheirSize) {
  const auto bytes = [](int collectors) {
    std::string text =
        "[terrain]\nsection = [[0, 10], [10, 0]]\nwidth_m = 20\n[[material]]\nname = \"A\"\n[[seeder]]\n"
        "position = [1, 5, \"surface\"]\nmass_kg = 1\n";
    for (int k = 0; k < collectors; ++k) {
      text += fmt::format("[[collector]]\nname = \"c{}\"\nline = [[5, {}], [5, {}]]\nheight_m = 1\n", k, k, k + 1);
    }
    return server::bytes_of(server::build(text, "slope.toml", {}).model);
  };
  EXPECT_GT(bytes(15), bytes(0) + 15 * 200);
}

TEST(ReadingModels, ReturnsTheResult) {
  ModelReading reading(10min);
  EXPECT_EQ(*reading.read<int>("a", [] { return 7; }), 7);
  EXPECT_THROW((void)reading.read<int>("a", []() -> int { throw BadInput(Problem{.what = "damaged"}); }), BadInput);
  for (int k = 0; k < 30'000 && reading.threads() > 0; ++k) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(reading.threads(), 0U);
}

TEST(ReadingModels, ReadsOnceForConcurrentCallersOfTheSameKey) {
  ModelReading reading(10min);
  std::atomic<int> readings{0};
  std::atomic<bool> may_end{false};
  std::atomic<int> asked{0};
  const auto ask = [&] {
    ++asked;
    return reading.read<int>("same", [&] {
      ++readings;
      while (!may_end) std::this_thread::sleep_for(1ms);
      return 5;
    });
  };
  auto first = std::async(std::launch::async, ask), second = std::async(std::launch::async, ask);
  while (asked < 2) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(500ms);
  may_end = true;
  EXPECT_EQ(*first.get(), 5);
  EXPECT_EQ(*second.get(), 5);
  EXPECT_EQ(readings, 1);
}

TEST(ReadingModels, IsNotBlockedBySlowReads) {
  ModelReading reading(10min);
  const Blockade blockade;
  std::atomic<bool> stop{false};
  std::vector<std::thread> waiting;
  for (const char* key : {"a", "b", "c", "d"}) {
    waiting.emplace_back([&, key] {
      const StopScope scope(&stop);
      EXPECT_THROW((void)reading.read<int>(key, blockade.reader()), Stopped);
    });
  }
  std::this_thread::sleep_for(50ms);
  const auto begin = Clock::now();
  EXPECT_EQ(*reading.read<int>("quick", [] { return 1; }), 1);
  EXPECT_LT(Clock::now() - begin, 1min);
  // Waiting callers can be stopped at once.
  stop = true;
  const auto asked = Clock::now();
  for (std::thread& each : waiting) each.join();
  EXPECT_LT(Clock::now() - asked, 1min);
  EXPECT_GE(reading.threads(), 2U);
}

TEST(ReadingModels, HasATimeLimit) {
  ModelReading reading(200ms);
  const Blockade blockade;
  try {
    (void)reading.read<int>("a", blockade.reader());
    ADD_FAILURE() << "the read ended";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.problems().text(),
              "the files of this project could not be read in time (it took more than 0.2 s). Check whether one of "
              "them is on a drive that does not respond, or use smaller files");
  }
}

TEST(ReadingModels, StopsWithoutCallers) {
  ModelReading reading(10min);
  std::atomic<bool> stop{false}, was_stopped{false};
  std::thread waiting([&] {
    const StopScope scope(&stop);
    EXPECT_THROW((void)reading.read<int>("a",
                                         [&]() -> int {
                                           try {
                                             for (;;) {
                                               stop_point();
                                               std::this_thread::sleep_for(1ms);
                                             }
                                           } catch (const Stopped&) {
                                             was_stopped = true;
                                             throw;
                                           }
                                         }),
                 Stopped);
  });
  std::this_thread::sleep_for(50ms);
  stop = true;
  waiting.join();
  for (int k = 0; k < 30'000 && reading.threads() > 0; ++k) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(reading.threads(), 0U);
  EXPECT_TRUE(was_stopped);
}

/// A file with a lease: the system delays opening it by up to 45 s.
class Leased {
 public:
  explicit Leased(const std::filesystem::path& file) {
    std::signal(SIGIO, SIG_IGN);  // the system's request to release the lease
    file_ = open(file.c_str(), O_RDWR | O_CLOEXEC);
    is_held_ = file_ >= 0 && fcntl(file_, F_SETLEASE, F_WRLCK) == 0;
  }
  ~Leased() {
    if (is_held_) fcntl(file_, F_SETLEASE, F_UNLCK);
    close(file_);
  }
  [[nodiscard]] bool is_held() const { return is_held_; }

 private:
  int file_ = -1;
  bool is_held_ = false;
};

class Hanging : public ServedRuns {
 protected:
  void SetUp() override {
    write("dem.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n9 1\n9 1\n");
    leased_.emplace(path("dem.asc"));
    if (!leased_->is_held()) GTEST_SKIP() << "this file system has no leases";
  }
  void TearDown() override { leased_.reset(); }
  static std::string on_raster() {
    return "[terrain]\nraster = \"dem.asc\"\n[[material]]\nname = \"A\"\n[[seeder]]\nposition = [5, 5, \"surface\"]\n"
           "mass_kg = 1\n";
  }
  std::optional<Leased> leased_;
};

TEST_F(Hanging, ModelBlocksNeitherOthersNorTheServersEnd) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the abandoned thread outlives this process' static objects; the program ends without destroying them";
#endif
  std::thread hanging([&] {
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(60, 0);
    const Json body{{"file", "a.toml"}, {"text", on_raster()}};
    (void)client.Post("/api/model", {{"Cookie", cookie_}}, body.dump(), "application/json");
  });
  std::this_thread::sleep_for(300ms);
  auto begin = Clock::now();
  const Reply reply = post("/api/model", {{"file", "b.toml"}, {"text", section()}});
  EXPECT_EQ(reply.status, 200);
  EXPECT_FALSE(reply.json()["model"].is_null()) << reply.body;
  EXPECT_LT(Clock::now() - begin, 30s);  // the system opens the file after 45 s
  const std::string id = ServedRuns::begin(section(), {{"rocks", 10}});
  EXPECT_EQ(wait_for(id, "done")["done"], 10);

  begin = Clock::now();
  stop();
  EXPECT_LT(Clock::now() - begin, 30s);  // the system opens the file after 45 s
  hanging.join();
  EXPECT_LT(Clock::now() - begin, 30s);  // the system opens the file after 45 s
}

class Pipes : public ServedRuns {};

TEST_F(Pipes, BesideARasterTakeNoThreads) {
  write("dem.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n9 1\n9 1\n");
  for (const char* side : {"dem.prj", "dem.asc.aux.xml", "dem.asc.ovr"}) ASSERT_EQ(mkfifo(path(side).c_str(), 0600), 0);
  for (int k = 0; k < 20; ++k) {  // more than threads that may hang
    const std::string text =
        "[terrain]\nraster = \"dem.asc\"\n[[material]]\nname = \"A\"\n[[seeder]]\nposition = [5, 5, \"surface\"]\n"
        "mass_kg = " +
        std::to_string(k + 1) + "\n";
    const Reply reply = post("/api/model", {{"file", "a.toml"}, {"text", text}});
    EXPECT_EQ(reply.status, 200);
    EXPECT_FALSE(reply.json()["model"].is_null()) << reply.body;
  }
}

}  // namespace
}  // namespace talus
