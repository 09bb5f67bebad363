#include "answer.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>

#include "exit_codes.hpp"
#include "standard_streams.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/core/problems.hpp"

namespace talus::cli {

namespace {

int output_error = 0;  // errno of a failed write to standard output: stdio keeps only the fact of a failure

int internal(const std::exception& error) {
  to_stderr("talus: internal error: {}\n", error.what());
  return internal_error;
}

}  // namespace

int answer(const std::function<int()>& work) {
  keep_memory_reserve();
  try {
    return work();
  } catch (const BadInput& bad) {
    to_stderr("{}\n", bad.problems().text());
    return bad_input;
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) {
      to_stderr("talus: cannot start a thread: {}\n", error.code().message());
      return bad_input;
    }
    if (std::ferror(stdout) == 0) return internal(error);
    output_error = error.code().value();
    return bad_input;  // finish_output() prints the reason
  } catch (const OutOfMemory& error) {
    to_stderr("talus: {}\n", error.what());
    return internal_error;
  } catch (const std::bad_alloc&) {
    to_stderr("talus: not enough memory\n");
    return internal_error;
  } catch (const std::exception& error) {
    return internal(error);
  }
}

void flush_output() {
  if (std::fflush(stdout) != 0) output_error = errno;
}

int finish_output(int code) {
  flush_output();
  if (std::ferror(stdout) == 0) return code;
  if (output_error == EPIPE) end_by_closed_pipe();
  const Problem problem{.where = "standard output",
                        .what = "the output is incomplete",
                        .why = output_error != 0 ? std::strerror(output_error) : "",
                        .hint = "Free some space, or redirect it elsewhere"};
  to_stderr("{}\n", problem.text());
  return code == done || code == check_failed ? bad_input : code;
}

}  // namespace talus::cli
