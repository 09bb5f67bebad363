#pragma once
// A reserve for when memory runs out. If an allocation fails in the middle of something - in a destructor, in another
// thread, while an exception propagates - the program is terminated without a message. So some memory is reserved: the
// first failing allocation is served from it, and the shortage is recorded, to be checked where the program can stop in
// good order.

#include <new>
#include <string>
#include <utility>

namespace talus {

/// Makes the reserve, if there is none, and clears the record of a shortage. To be called at the beginning of a piece
/// of work.
void keep_memory_reserve();

/// Whether the reserve has been used.
[[nodiscard]] bool memory_is_short();

/// Not enough memory; the message says what became of the work. (std::bad_alloc has no message.)
class OutOfMemory : public std::bad_alloc {
 public:
  explicit OutOfMemory(std::string what) : what_(std::move(what)) {}
  [[nodiscard]] const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string what_;
};

}  // namespace talus
