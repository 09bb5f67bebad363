#pragma once
// oneTBB's names, as far as Talus uses them, on the threads of the C++ library: for builds with the thread sanitizer.
//
// Debian's oneTBB is not instrumented, so the sanitizer does not see how it hands work from one thread to another, and
// takes every result that a second thread reads for a race; to suppress those would be to suppress true ones with them,
// for TBB is on every stack. Here the handing over is by mutexes and joins that it does see: what it reports is ours.

#include <algorithm>
#include <any>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace tbb {

namespace info {
/// Several also where there is one core: races are looked for.
inline int default_concurrency() { return 4; }
}  // namespace info

/// The least of those that are there holds, as in TBB.
class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t most) {
    const std::lock_guard lock(mutex());
    mine_ = all().insert(most);
    least() = *all().begin();
  }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;
  ~global_control() {
    const std::lock_guard lock(mutex());
    all().erase(mine_);
    least() = all().empty() ? default_limit() : *all().begin();
  }
  // Relaxed: to ask must not put one thread's work before another's.
  static std::size_t limit() { return least().load(std::memory_order_relaxed); }

 private:
  static std::size_t default_limit() { return static_cast<std::size_t>(info::default_concurrency()); }
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }
  static std::multiset<std::size_t>& all() {
    static std::multiset<std::size_t> limits;
    return limits;
  }
  static std::atomic<std::size_t>& least() {
    static std::atomic<std::size_t> limit{default_limit()};
    return limit;
  }
  std::multiset<std::size_t>::iterator mine_;
};

namespace threads {

/// Calls work() in as many threads as there may be, `most` at most, and waits for them. What the first throws goes on.
template <class Work>
void call(std::size_t most, const Work& work) {
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (std::size_t k = 1; k < std::min(most, global_control::limit()); ++k) others.emplace_back(guarded);
  guarded();
  for (std::thread& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

/// Calls one(k) for k = 0 to count - 1.
template <class One>
void each(std::size_t count, const One& one) {
  std::atomic<std::size_t> next{0};
  call(count, [&] {
    // Relaxed: the counter must not put one item's work before another's.
    const auto take = [&] { return next.fetch_add(1, std::memory_order_relaxed); };
    for (std::size_t k = take(); k < count; k = take()) one(k);
  });
}

}  // namespace threads

template <class Value>
class blocked_range {
 public:
  blocked_range(Value begin, Value end, std::size_t grain = 1) : begin_(begin), end_(end), grain_(grain) {}
  [[nodiscard]] Value begin() const { return begin_; }
  [[nodiscard]] Value end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  [[nodiscard]] std::size_t grainsize() const { return grain_; }

 private:
  Value begin_, end_;
  std::size_t grain_;
};

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  const std::size_t size = range.size();
  threads::each((size + range.grainsize() - 1) / range.grainsize(), [&](std::size_t k) {
    const auto begin = range.begin() + static_cast<Value>(k * range.grainsize());
    body(blocked_range<Value>(begin,
                              begin + static_cast<Value>(std::min(range.grainsize(), size - k * range.grainsize()))));
  });
}

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  threads::each(last > first ? static_cast<std::size_t>(last - first) : 0,
                [&](std::size_t k) { body(first + static_cast<Index>(k)); });
}

template <class Iterator, class Body>
void parallel_for_each(Iterator first, Iterator last, const Body& body) {
  std::vector<Iterator> places;
  for (; first != last; ++first) places.push_back(first);
  threads::each(places.size(), [&](std::size_t k) { body(*places[k]); });
}

template <class Container, class Body>
void parallel_for_each(Container&& container, const Body& body) {
  parallel_for_each(container.begin(), container.end(), body);
}

template <class... Works>
void parallel_invoke(const Works&... works) {
  // It is called within itself: not more threads than this at the same time.
  static std::atomic<int> busy{0};
  constexpr int most = 8;
  const std::vector<std::function<void()>> all{works...};
  if (busy.fetch_add(1) < most) {
    threads::each(all.size(), [&](std::size_t k) { all[k](); });
  } else {
    for (const auto& work : all) work();
  }
  --busy;
}

template <class Container>
void parallel_sort(Container&& container) {
  std::sort(container.begin(), container.end());
}

namespace this_task_arena {
template <class Work>
auto isolate(Work&& work) {
  return work();
}
}  // namespace this_task_arena

/// Threads are made anew for each piece of work, with the priority of whoever makes them.
class task_arena {
 public:
  template <class Work>
  auto execute(Work&& work) {
    return work();
  }
};

class task_scheduler_observer {
 public:
  explicit task_scheduler_observer(task_arena&) {}
  virtual ~task_scheduler_observer() = default;
  void observe(bool) {}
  virtual void on_scheduler_entry(bool) {}
};

template <class Value>
class enumerable_thread_specific {
 public:
  template <class Make>
  explicit enumerable_thread_specific(Make make) : make_(make) {}
  Value& local() {
    const std::lock_guard lock(mutex_);
    auto& value = values_[std::this_thread::get_id()];
    if (!value) value = std::make_unique<Value>(make_());
    return *value;
  }

 private:
  std::function<Value()> make_;
  std::mutex mutex_;
  std::map<std::thread::id, std::unique_ptr<Value>> values_;
};

// ---- pipelines: every thread takes an item through all stages, and waits for its turn at those that keep the order
// ----

enum class filter_mode { parallel, serial_in_order };

class flow_control {
 public:
  void stop() { is_stopped = true; }
  bool is_stopped = false;
};

namespace threads {

struct Stage {
  filter_mode mode;
  std::function<std::any(std::any&, flow_control&)> work;
};

}  // namespace threads

template <class In, class Out>
struct filter {
  std::vector<threads::Stage> stages;
};

template <class In, class Out, class Body>
filter<In, Out> make_filter(filter_mode mode, const Body& body) {
  return {{{mode, [body](std::any& in, flow_control& control) -> std::any {
              static_cast<void>(control);
              if constexpr (std::is_void_v<In>) {
                return body(control);
              } else if constexpr (std::is_void_v<Out>) {
                body(std::any_cast<In>(in));
                return {};
              } else {
                return body(std::any_cast<In>(in));
              }
            }}}};
}

template <class In, class Between, class Out>
filter<In, Out> operator&(const filter<In, Between>& first, const filter<Between, Out>& second) {
  filter<In, Out> both{first.stages};
  both.stages.insert(both.stages.end(), second.stages.begin(), second.stages.end());
  return both;
}

inline void parallel_pipeline(std::size_t tokens, const filter<void, void>& chain) {
  struct Turn {
    std::mutex mutex;
    std::condition_variable changed;
    std::uint64_t next = 0;
  };
  std::vector<Turn> turns(chain.stages.size());
  flow_control control;
  std::atomic<bool> failed{false};
  const auto fail = [&] {
    failed = true;
    for (Turn& turn : turns) {
      const std::lock_guard lock(turn.mutex);
      turn.changed.notify_all();
    }
  };
  threads::call(tokens, [&] {
    try {
      for (;;) {
        std::any item;
        std::uint64_t number = 0;
        {
          const std::lock_guard lock(turns[0].mutex);
          if (control.is_stopped || failed) return;
          std::any nothing;
          item = chain.stages[0].work(nothing, control);
          if (control.is_stopped) return;
          number = turns[0].next++;
        }
        for (std::size_t k = 1; k < chain.stages.size(); ++k) {
          if (chain.stages[k].mode == filter_mode::parallel) {
            item = chain.stages[k].work(item, control);
            continue;
          }
          std::unique_lock lock(turns[k].mutex);
          turns[k].changed.wait(lock, [&] { return turns[k].next == number || failed; });
          if (failed) return;
          item = chain.stages[k].work(item, control);
          ++turns[k].next;
          turns[k].changed.notify_all();
        }
      }
    } catch (...) {
      fail();
      throw;
    }
  });
}

}  // namespace tbb
