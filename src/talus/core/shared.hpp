#pragma once
// A value that does not change, and of which copies are free.

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace talus {

/// Copies refer to the same value. Expects not to be used after it was moved from, except to assign to it.
template <class T>
class Shared {
 public:
  Shared() : Shared(T()) {}
  template <class From>
  requires(!std::same_as<std::remove_cvref_t<From>, Shared> && std::constructible_from<T, From>)
      Shared(From&& value)  // NOLINT(google-explicit-constructor): it stands for the value
      : value_(std::make_shared<const T>(std::forward<From>(value))) {}

  [[nodiscard]] const T& operator*() const { return *value_; }
  [[nodiscard]] const T* operator->() const { return value_.get(); }

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace talus
