#pragma once
// Typed indices: the compiler refuses a material's number where a facet's is expected.

#include <compare>
#include <cstdint>

namespace talus {

template <class Tag>
struct Id {
  std::uint32_t index = 0;
  friend constexpr auto operator<=>(Id, Id) = default;
};

using FacetId = Id<struct FacetTag>;
using MaterialId = Id<struct MaterialTag>;
using SeederId = Id<struct SeederTag>;
using SourceId = Id<struct SourceTag>;
using BarrierId = Id<struct BarrierTag>;

}  // namespace talus
