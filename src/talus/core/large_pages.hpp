#pragma once
// Memory for large tables with random access: in large pages, if the system has them, so that the processor does not
// have to look up the address of each page of 4 KiB.

#include <sys/mman.h>

#include <cstddef>
#include <new>

namespace talus {

/// An allocator for std::vector. Linux provides large pages on request (transparent_hugepage: madvise); if it does not,
/// only the speed differs.
template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class Other>
  explicit LargePages(const LargePages<Other>&) {}

  [[nodiscard]] T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* const place = ::operator new(bytes, alignment(bytes));
    if (is_large(bytes)) (void)madvise(place, bytes, MADV_HUGEPAGE);
    return static_cast<T*>(place);
  }
  void deallocate(T* place, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    ::operator delete(place, bytes, alignment(bytes));
  }
  friend bool operator==(const LargePages&, const LargePages&) { return true; }

 private:
  static constexpr std::size_t page = std::size_t{2} << 20U;
  [[nodiscard]] static bool is_large(std::size_t bytes) { return bytes >= 4 * page; }
  [[nodiscard]] static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{is_large(bytes) ? page : alignof(T)};
  }
};

}  // namespace talus
