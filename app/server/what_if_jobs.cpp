#include "what_if_jobs.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "low_priority.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"
#include "talus/lines/side_view.hpp"
#include "talus/lines/what_if_output.hpp"

namespace talus::server {

struct WhatIfJobs::Job {
  std::string run;    // its id
  WhatIfOrder order;  // without the run and its models once it has ended
  std::atomic<bool> stop{false};

  // The rest: with the lock.
  const char* state = "running";
  std::uint64_t done = 0, planned = 0;  // rocks of each set
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  double seconds = 0;
  Json answer;  // of the rocks that are done
  Problems problems;
};

Json WhatIfJobs::json_of(const Job& job) const {
  const bool is_running = std::string_view(job.state) == "running";
  Json left;
  if (is_running && job.done > 0)
    left = job.seconds * static_cast<double>(job.planned - std::min(job.planned, job.done)) /
           static_cast<double>(job.done);
  Problems problems = job.order.warnings;
  problems.append(job.problems);
  return {{"run", job.run},
          {"question", job.order.question},
          {"overrides", job.order.overrides},
          {"state", job.state},
          {"done", job.done},
          {"planned", job.planned},
          {"seconds", job.seconds},
          {"seconds_left", std::move(left)},
          {"problems", as_json(problems)},
          {"answer", job.answer}};
}

void WhatIfJobs::end_thread() {
  {
    const std::lock_guard lock(mutex_);
    if (!jobs_.empty()) jobs_.front()->stop = true;
  }
  if (thread_.joinable()) thread_.join();
}

Json WhatIfJobs::begin(WhatIfOrder order) {
  const std::lock_guard starting(starting_);
  end_thread();
  const auto job = std::make_shared<Job>();
  job->run = order.run->id;
  job->planned = std::min(order.run->built->model.rocks(), order.options.rocks);
  job->order = std::move(order);
  const std::lock_guard lock(mutex_);
  if (is_closed_) throw Refusal(503, "", "the server is about to end");
  std::erase_if(jobs_, [&](const auto& each) { return each->run == job->run; });
  jobs_.push_front(job);
  if (jobs_.size() > most_jobs) jobs_.pop_back();
  thread_ = std::thread([this, job] { work(*job); });
  return json_of(*job);
}

void WhatIfJobs::work(Job& job) const {
  keep_memory_reserve();
  lower_priority_of_this_thread();
  what_if::WhatIf& what_if = *job.order.what_if;
  const auto tell = [&](const char* state, Json answer) {
    const std::lock_guard lock(mutex_);
    job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - job.begin).count();
    if (!answer.is_null()) job.answer = std::move(answer);
    job.state = state;
  };
  what_if::RunOptions options = job.order.options;
  options.progress = [&](std::uint64_t done, std::uint64_t planned) {
    // Intervals of percentiles take long, and follow at the end.
    Json answer = what_if::json_of(what_if, what_if.answer(0));
    {
      const std::lock_guard lock(mutex_);
      job.done = done;
      job.planned = planned;
    }
    tell("running", std::move(answer));
  };
  const auto fail = [&](const Problems& problems) {
    {
      const std::lock_guard lock(mutex_);
      job.problems = problems;
    }
    tell("failed", {});
  };
  try {
    LowPriorityArena arena;
    arena.execute([&] {
      bool is_complete = false;
      try {
        const StopScope scope(&job.stop);
        is_complete = what_if.run(options);
        if (is_complete) {
          {
            const std::lock_guard lock(mutex_);
            job.planned = job.done;
          }
          Json answer = what_if::json_of(what_if, what_if.answer());
          if (Json picture = what_if::side_view(what_if); !picture.is_null()) answer["side_view"] = std::move(picture);
          tell("done", std::move(answer));
        }
      } catch (const Stopped&) {
        is_complete = false;
      }
      if (!is_complete) tell("stopped", what_if::json_of(what_if, what_if.answer(0)));
    });
  } catch (const BadInput& bad) {
    fail(bad.problems());
  } catch (const std::exception& error) {
    Problems problems;
    problems.add(Problem{.what = "what if failed", .why = error.what()});
    fail(problems);
  }
  job.order.what_if.reset();
  job.order.run.reset();
}

std::shared_ptr<WhatIfJobs::Job> WhatIfJobs::job_of(const std::string& run) const {
  const auto found = std::ranges::find_if(jobs_, [&](const auto& job) { return job->run == run; });
  return found == jobs_.end() ? nullptr : *found;
}

Json WhatIfJobs::state_of(const std::string& run) const {
  const std::lock_guard lock(mutex_);
  const auto job = job_of(run);
  return job ? json_of(*job) : Json();
}

Json WhatIfJobs::stop(const std::string& run) {
  const std::lock_guard lock(mutex_);
  const auto job = job_of(run);
  if (!job) throw Refusal(404, run, "what if was not asked of this run", "the server keeps the last ones");
  job->stop = true;
  return json_of(*job);
}

void WhatIfJobs::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  const std::lock_guard starting(starting_);
  end_thread();
}

}  // namespace talus::server
