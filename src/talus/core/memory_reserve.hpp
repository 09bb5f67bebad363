#pragma once
// What happens when memory runs out. A program that finds none in the middle of something - in a destructor, in another
// thread, while an error is on its way - cannot say so, and is ended. So some is put aside: the first request that
// finds none is served from that, and the shortage is noted, for those who ask at a place where they can stop in good
// order.

#include <new>
#include <string>
#include <utility>

namespace talus {

/// Puts memory aside, where none is; takes back the note of a shortage. For those who begin a piece of work.
void keep_memory_reserve();

/// Whether the memory that was put aside had to be used.
[[nodiscard]] bool memory_is_short();

/// There is not enough memory, and this is what became of the work. (A bad_alloc says nothing.)
class OutOfMemory : public std::bad_alloc {
 public:
  explicit OutOfMemory(std::string what) : what_(std::move(what)) {}
  [[nodiscard]] const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::string what_;
};

}  // namespace talus
