#pragma once
// One function of several alternatives, for std::visit.

namespace talus {

template <class... Each>
struct Overloaded : Each... {
  using Each::operator()...;
};
template <class... Each>
Overloaded(Each...) -> Overloaded<Each...>;  // clang 14 does not deduce it by itself

}  // namespace talus
