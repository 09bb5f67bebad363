#pragma once
// The values of a PLY file after its header, as text or binary.
//
// A body returns the values of one element after another. If a value cannot be read, it adds an error to the problems
// and returns nothing; the rest of that element is then skipped.

#include <fmt/format.h>

#include <algorithm>
#include <boost/endian/conversion.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "talus/import/mesh_ply_header.hpp"
#include "talus/import/mesh_text.hpp"

namespace talus::ply {

class TextBody {
 public:
  TextBody(const Header& header, MeshProblems& problems) : lines_(header.body, header.lines), problems_(problems) {}

  // How many elements the rest of the file can contain. A value is at least a digit and a separator, except the last.
  [[nodiscard]] std::uint64_t room_for(const Element& element) const {
    return (lines_.rest().size() + 1) / (2 * element.properties.size());
  }

  void begin(const Element& element, std::uint64_t number) {
    do {
      const auto line = lines_.next();
      if (!line) {
        problems_.stop({lines_.number(), ""}, "the file ends too early",
                       fmt::format("{} {} of {} is missing", element.name, number + 1, element.count),
                       "It may have been cut short");
      }
      line_ = *line;
    } while (is_blank(line_));
    place_.line = lines_.number();
  }

  void end() {
    if (is_blank(line_)) return;
    problems_.refuse(place_, "the line has more values than the header declares", "each element has its own line");
  }

  std::optional<double> real(const Property& property) {
    const auto value = word(property);
    return value ? read_coordinate(*value, problems_, place_) : std::nullopt;
  }

  std::optional<std::int64_t> whole(const Property& property) {
    const auto value = word(property);
    if (!value) return std::nullopt;
    const auto number = whole_number(*value);
    if (!number) problems_.refuse(place_, in_quotes(*value) + " is not a whole number", "expected " + property.name);
    return number;
  }

  std::optional<std::uint64_t> length(const Property& property) {
    const auto number = whole(property);
    if (number && *number < 0) {
      problems_.refuse(place_, fmt::format("a list with {} values", *number), "a length is not negative");
      return std::nullopt;
    }
    return number;
  }

  bool skip(const Property& property, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!word(property)) return false;
    }
    return true;
  }

  void finish() {
    while (const auto line = lines_.next()) {
      if (!is_blank(*line)) {
        problems_.stop({lines_.number(), ""}, "the file continues after its last element",
                       "the header declares fewer elements than there are lines");
      }
    }
  }

  [[nodiscard]] const MeshPlace& place() const { return place_; }
  [[nodiscard]] std::uint32_t line() const { return place_.line; }

 private:
  static bool is_blank(std::string_view line) { return take_word(line).empty(); }

  std::optional<std::string_view> word(const Property& property) {
    const std::string_view next = take_word(line_);
    if (!next.empty()) return next;
    problems_.refuse(place_, "the line has fewer values than the header declares", property.name + " is missing");
    return std::nullopt;
  }

  Lines lines_;
  MeshProblems& problems_;
  MeshPlace place_;
  std::string_view line_;
};

template <boost::endian::order order>
class BinaryBody {
 public:
  BinaryBody(const Header& header, MeshProblems& problems) : rest_(header.body), problems_(problems) {}

  [[nodiscard]] std::uint64_t room_for(const Element& element) const {
    std::size_t least = 0;
    for (const Property& property : element.properties) least += bytes_of(property.length.value_or(property.type));
    return rest_.size() / least;
  }

  void begin(const Element& element, std::uint64_t number) {
    element_ = &element;
    number_ = number;
  }

  void end() {}

  std::optional<double> real(const Property& property) {
    if (property.type == Type::float64) return finite(take<double>());
    if (property.type == Type::float32) {
      const auto value = take<float>();
      if (std::isfinite(value)) largest_ = std::max(largest_, std::abs(value));
      return finite(value);
    }
    return static_cast<double>(*whole(property));
  }

  std::optional<std::int64_t> whole(const Property& property) { return whole(property.type); }

  std::optional<std::uint64_t> length(const Property& property) {
    const std::int64_t length = whole(*property.length);
    if (length < 0 || static_cast<std::uint64_t>(length) > rest_.size() / bytes_of(property.type)) {
      problems_.stop(place(), fmt::format("a list with {} values", length),
                     fmt::format("{} bytes remain in the file", rest_.size()), "The file may be damaged");
    }
    return static_cast<std::uint64_t>(length);
  }

  bool skip(const Property& property, std::uint64_t count) {
    need(count * bytes_of(property.type));
    rest_.remove_prefix(count * bytes_of(property.type));
    return true;
  }

  // Some programs end the file with a line feed or pad it with zeros.
  void finish() {
    if (rest_.find_first_not_of(std::string_view{"\0\r\n", 3}) != std::string_view::npos) {
      problems_.stop({}, fmt::format("{} bytes follow the last element", rest_.size()),
                     "the header declares fewer elements than there are");
    }
    warn_of_single_precision(largest_, problems_);
  }

  [[nodiscard]] MeshPlace place() const {
    return {0, fmt::format("{} {} of {}", element_->name, number_ + 1, element_->count)};
  }
  [[nodiscard]] std::uint32_t line() const { return 0; }

 private:
  void need(std::uint64_t bytes) {
    if (bytes <= rest_.size()) return;
    problems_.stop(place(), "the file ends too early",
                   fmt::format("{} bytes are needed, {} remain", bytes, rest_.size()), "It may have been cut short");
  }

  template <class T>
  T take() {
    need(sizeof(T));
    const auto value =
        boost::endian::endian_load<T, sizeof(T), order>(reinterpret_cast<const unsigned char*>(rest_.data()));
    rest_.remove_prefix(sizeof(T));
    return value;
  }

  std::int64_t whole(Type type) {
    switch (type) {
      case Type::int8:
        return take<std::int8_t>();
      case Type::uint8:
        return take<std::uint8_t>();
      case Type::int16:
        return take<std::int16_t>();
      case Type::uint16:
        return take<std::uint16_t>();
      case Type::int32:
        return take<std::int32_t>();
      case Type::uint32:
        return take<std::uint32_t>();
      case Type::float32:
      case Type::float64:
        break;  // refused by the check of the header
    }
    return 0;
  }

  std::optional<double> finite(double value) {
    if (std::isfinite(value)) return value;
    problems_.refuse(place(), "a coordinate is not a finite number", "expected metres");
    return 0.0;
  }

  std::string_view rest_;
  MeshProblems& problems_;
  const Element* element_ = nullptr;
  std::uint64_t number_ = 0;
  float largest_ = 0;
};

}  // namespace talus::ply
