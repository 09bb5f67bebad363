#pragma once
// Large answers: a JSON header and arrays of numbers ("Arrays" in docs/workbench-api.md).

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "http/answer.hpp"

namespace talus::server {

class Arrays {
 public:
  /// `header`: its members other than `arrays`.
  explicit Arrays(Json header) : header_(std::move(header)) { header_["arrays"] = Json::array(); }

  void add(std::string_view name, std::span<const float> values) { add(name, "f32", values); }
  void add(std::string_view name, std::span<const double> values) { add(name, "f64", values); }
  void add(std::string_view name, std::span<const std::uint8_t> values) { add(name, "u8", values); }
  void add(std::string_view name, std::span<const std::uint16_t> values) { add(name, "u16", values); }
  void add(std::string_view name, std::span<const std::uint32_t> values) { add(name, "u32", values); }
  /// Uses the smallest integer type for values below `count`.
  void add_smallest(std::string_view name, std::span<const std::uint32_t> values, std::size_t count);

  [[nodiscard]] Answer answer() const;

 private:
  template <class T>
  void add(std::string_view name, const char* type, std::span<const T> values);

  Json header_;
  std::string bytes_;
};

}  // namespace talus::server
