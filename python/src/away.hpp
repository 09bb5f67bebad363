#pragma once
// Long work without the interpreter's lock.

#include <atomic>
#include <exception>
#include <functional>

namespace talus::python {

/// Does work in a thread of its own, inside a StopScope of `stop`, while this thread waits without the interpreter's
/// lock. From time to time this thread takes the lock, handles signals and calls `report` (may be empty); if either
/// raises an exception, for example KeyboardInterrupt, it requests the work to stop, waits for its end and returns that
/// exception. Rethrows what the work throws, unless it was stopped so. Expects to be called with the lock. Work of
/// other threads stops, too, when the interpreter ends. Throws std::runtime_error in a process that was forked while
/// work was under way: the threads that it needs are not there.
std::exception_ptr do_away(const std::function<void(const std::atomic<bool>& stop)>& work,
                           const std::function<void()>& report = {});

/// The same for work without a result if it is stopped: throws.
void do_away_or_throw(const std::function<void(const std::atomic<bool>& stop)>& work);

/// Makes the end of the interpreter and forks of the process known to work. Expects to be called once, by the module.
void watch_process();

}  // namespace talus::python
