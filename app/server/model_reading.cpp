#include "model_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "http/answer.hpp"
#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"

namespace talus::server {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto poll_interval = 20ms;  // for checking whether a caller was stopped
constexpr auto slow = 1s;             // a read that takes longer does not count for `at_a_time`
constexpr std::size_t at_a_time = 2, at_most = 16;

}  // namespace

struct ModelReading::Job {
  std::string key;
  Clock::time_point begun = Clock::now();
  std::size_t waiting = 1;        // number of callers
  std::atomic<bool> stop{false};  // no caller is left
  bool has_ended = false;
  std::shared_ptr<const void> result;
  std::exception_ptr failure;
};

struct ModelReading::State {
  std::mutex mutex;  // guards all members below, and the jobs
  std::condition_variable changed;
  std::vector<std::shared_ptr<Job>> jobs;  // whose threads have not ended

  // The functions expect the lock.
  [[nodiscard]] std::shared_ptr<Job> find(const std::string& key) const {
    const auto found =
        std::ranges::find_if(jobs, [&](const auto& job) { return !key.empty() && job->key == key && !job->stop; });
    return found == jobs.end() ? nullptr : *found;
  }
  [[nodiscard]] bool has_room() const {
    const auto now = Clock::now();
    const auto young =
        std::ranges::count_if(jobs, [&](const auto& job) { return !job->stop && now - job->begun < slow; });
    return static_cast<std::size_t>(young) < at_a_time;
  }
};

ModelReading::ModelReading(std::chrono::milliseconds longest) : longest_(longest), state_(std::make_shared<State>()) {}

std::size_t ModelReading::threads() const {
  const std::lock_guard lock(state_->mutex);
  return state_->jobs.size();
}

std::shared_ptr<const void> ModelReading::wait_for(const std::string& key, Work work) {
  const auto until = Clock::now() + longest_;
  const auto too_long = [&] {
    return BadInput(
        Problem{.what = "the files of this project could not be read in time",
                .why = fmt::format("it took more than {:g} s", std::chrono::duration<double>(longest_).count()),
                .hint = "Check whether one of them is on a drive that does not respond, or use smaller files"});
  };
  std::unique_lock lock(state_->mutex);
  std::shared_ptr<Job> job;
  while (!(job = state_->find(key)) && !state_->has_room()) {
    if (Clock::now() > until) throw too_long();
    if (const StopScope* scope = StopScope::current(); scope != nullptr && scope->is_requested()) throw Stopped{};
    state_->changed.wait_for(lock, poll_interval);
  }
  if (job) {
    ++job->waiting;
  } else {
    if (state_->jobs.size() >= at_most)
      throw Refusal(503, "model", "cannot be read now", fmt::format("{} earlier reads have not ended", at_most),
                    "Restart the server");
    job = std::make_shared<Job>();
    job->key = key;
    state_->jobs.push_back(job);
    std::thread([state = state_, job, work = std::move(work)]() mutable {
      std::shared_ptr<const void> result;
      std::exception_ptr failure;
      try {
        const StopScope scope(&job->stop);
        result = work();
      } catch (...) {
        failure = std::current_exception();
      }
      work = nullptr;
      const std::lock_guard own(state->mutex);
      if (!job->stop) {
        job->result = std::move(result);
        job->failure = failure;
      }
      job->has_ended = true;
      std::erase(state->jobs, job);
      state->changed.notify_all();
    }).detach();
  }
  const auto leave = [&] {
    if (--job->waiting == 0) job->stop = true;
  };
  while (!job->has_ended) {
    state_->changed.wait_for(lock, poll_interval);
    if (job->has_ended) break;
    if (const StopScope* scope = StopScope::current(); scope != nullptr && scope->is_requested()) {
      leave();
      throw Stopped{};
    }
    if (Clock::now() > until) {
      leave();
      throw too_long();
    }
  }
  if (job->failure) std::rethrow_exception(job->failure);
  return job->result;
}

}  // namespace talus::server
