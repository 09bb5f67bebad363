#pragma once
// Structs as JSON objects. A struct declares its members with their keys once,
//
//   static auto fields() { return std::tuple(field("name", &Barrier::name), field_if_any("note", &Barrier::note)); }
//
// From that follow the object that is written, in this order, and the reader. The reader refuses missing values and
// values of another type, with their place. Members are numbers, texts, flags, other such structs, lists of any of
// these, objects whose keys are names (Named), and JSON that is kept as it is (SharedJson). An empty optional is null;
// an empty field_if_any() is left out. Keys that are not declared are ignored.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace talus {

using JsonValue = nlohmann::ordered_json;  // in the order of the file
/// JSON that is kept as it is; copies share it.
using SharedJson = std::shared_ptr<const JsonValue>;
/// An object whose keys are names, in their order.
template <class T>
using Named = std::vector<std::pair<std::string, T>>;

template <class Object, class Value>
struct Field {
  using Member = Value;
  const char* key;
  Value Object::*member;
  bool is_always_there;
};
template <class Object, class Value>
[[nodiscard]] constexpr Field<Object, Value> field(const char* key, Value Object::*member) {
  return {key, member, true};
}
template <class Object, class Value>
[[nodiscard]] constexpr Field<Object, Value> field_if_any(const char* key, Value Object::*member) {
  return {key, member, false};
}

class JsonPlace;
template <class T>
concept Declared = requires {
  T::fields();
};
/// Types with their own reader: T::from(json, place).
template <class T>
concept ReadsItself = requires(const JsonValue& json, const JsonPlace& place) {
  { T::from(json, place) } -> std::same_as<T>;
};

/// The place of a value in a file: "barriers/0/name".
class JsonPlace {
 public:
  JsonPlace() = default;
  JsonPlace(const JsonPlace& above, std::string_view key) : above_(&above), key_(key) {}
  JsonPlace(const JsonPlace& above, std::size_t index) : above_(&above), index_(index) {}
  [[nodiscard]] std::string text() const {
    if (above_ == nullptr) return {};
    const std::string above = above_->text(), own = index_ ? fmt::format("{}", *index_) : std::string(key_);
    return above.empty() ? own : above + "/" + own;
  }

 private:
  const JsonPlace* above_ = nullptr;  // nullptr: the whole file
  std::string_view key_;
  std::optional<std::size_t> index_;
};

/// Thrown if a value is not as declared.
struct BadField {
  std::string where, what, why;
};
/// A fault of a value of the right type: T::fault() returns one, or nullopt.
struct FieldFault {
  std::string what, why;
};

inline void expect_kind(bool is, const JsonValue& json, const JsonPlace& place, const char* expected) {
  if (!is)
    throw BadField{place.text(), fmt::format("is of type {}", json.type_name()), fmt::format("expected {}", expected)};
}

namespace json_fields {

template <class T, template <class...> class Template>
inline constexpr bool is_a = false;
template <class... Parts, template <class...> class Template>
inline constexpr bool is_a<Template<Parts...>, Template> = true;
template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t n>
inline constexpr bool is_array<std::array<T, n>> = true;
template <class T>
inline constexpr bool is_named = false;
template <class T>
inline constexpr bool is_named<Named<T>> = true;

template <class T>
[[nodiscard]] bool is_empty(const T& value) {
  if constexpr (is_a<T, std::optional> || std::same_as<T, SharedJson>) {
    return !value;
  } else if constexpr (requires { value.empty(); }) {
    return value.empty();
  } else {
    return false;
  }
}

}  // namespace json_fields

/// The entry of a name; nullptr if there is none.
template <class T>
[[nodiscard]] const T* find_named(const Named<T>& named, std::string_view name) {
  for (const auto& entry : named) {
    if (entry.first == name) return &entry.second;
  }
  return nullptr;
}

/// Calls visit(field) for each field of a struct, in their order.
template <Declared T, class Visit>
void for_fields(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, T::fields());
}

/// Whether this field of an object is written.
template <class Object, class OfField>
[[nodiscard]] bool is_there(const Object& object, const OfField& field) {
  return field.is_always_there || !json_fields::is_empty(object.*field.member);
}

template <class T>
[[nodiscard]] JsonValue json_of(const T& value) {
  using namespace json_fields;
  if constexpr (Declared<T>) {
    JsonValue json = JsonValue::object();
    for_fields<T>([&](const auto& field) {
      if (is_there(value, field)) json[field.key] = json_of(value.*field.member);
    });
    return json;
  } else if constexpr (std::same_as<T, SharedJson>) {
    return value ? *value : JsonValue(nullptr);
  } else if constexpr (is_a<T, std::optional>) {
    return value ? json_of(*value) : JsonValue(nullptr);
  } else if constexpr (is_named<T>) {
    JsonValue json = JsonValue::object();
    for (const auto& [name, entry] : value) json[name] = json_of(entry);
    return json;
  } else if constexpr (is_array<T> || is_a<T, std::vector>) {
    JsonValue json = JsonValue::array();
    for (const auto& entry : value) json.push_back(json_of(entry));
    return json;
  } else if constexpr (std::same_as<T, double>) {
    return std::isfinite(value) ? JsonValue(value) : JsonValue(nullptr);
  } else {
    return JsonValue(value);
  }
}

/// Reads a value. Throws BadField.
template <class T>
void read_json(const JsonValue& json, const JsonPlace& place, T& value);

/// Reads the fields of an object that are selected by their keys.
template <Declared T, class Wants>
void read_fields(const JsonValue& json, const JsonPlace& place, T& value, Wants&& wants) {
  expect_kind(json.is_object(), json, place, "an object");
  for_fields<T>([&](const auto& field) {
    if (!wants(std::string_view(field.key))) return;
    const JsonPlace here(place, field.key);
    const auto found = json.find(field.key);
    if (found != json.end()) {
      read_json(*found, here, value.*field.member);
    } else if (field.is_always_there) {
      throw BadField{here.text(), "is missing", "a run writes it"};
    }
  });
}

template <class T>
void read_json(const JsonValue& json, const JsonPlace& place, T& value) {
  using namespace json_fields;
  if constexpr (Declared<T>) {
    read_fields(json, place, value, [](std::string_view) { return true; });
    if constexpr (requires { value.fault(); }) {
      if (std::optional<FieldFault> fault = value.fault())
        throw BadField{place.text(), std::move(fault->what), std::move(fault->why)};
    }
  } else if constexpr (ReadsItself<T>) {
    value = T::from(json, place);
  } else if constexpr (std::same_as<T, SharedJson>) {
    expect_kind(json.is_object(), json, place, "an object");
    value = std::make_shared<const JsonValue>(json);
  } else if constexpr (is_a<T, std::optional>) {
    value.reset();
    if (!json.is_null()) read_json(json, place, value.emplace(typename T::value_type{}));
  } else if constexpr (is_named<T>) {
    expect_kind(json.is_object(), json, place, "an object");
    for (const auto& [name, entry] : json.items()) {
      value.emplace_back(name, typename T::value_type::second_type{});
      read_json(entry, JsonPlace(place, name), value.back().second);
    }
  } else if constexpr (is_array<T>) {
    expect_kind(json.is_array(), json, place, "a list");
    if (json.size() != value.size())
      throw BadField{place.text(), fmt::format("has {} entries", json.size()),
                     fmt::format("expected {}", value.size())};
    for (std::size_t k = 0; k < value.size(); ++k) read_json(json[k], JsonPlace(place, k), value[k]);
  } else if constexpr (is_a<T, std::vector>) {
    expect_kind(json.is_array(), json, place, "a list");
    value.reserve(json.size());
    for (std::size_t k = 0; k < json.size(); ++k) read_json(json[k], JsonPlace(place, k), value.emplace_back());
  } else if constexpr (std::same_as<T, std::string>) {
    expect_kind(json.is_string(), json, place, "a text");
    value = json.get<std::string>();
  } else if constexpr (std::same_as<T, bool>) {
    expect_kind(json.is_boolean(), json, place, "true or false");
    value = json.get<bool>();
  } else if constexpr (std::same_as<T, std::uint64_t>) {
    expect_kind(json.is_number_unsigned(), json, place, "a whole number, 0 or more");
    value = json.get<std::uint64_t>();
  } else {
    static_assert(std::same_as<T, double>, "no reader for this type");
    expect_kind(json.is_number(), json, place, "a number");
    value = json.get<double>();
  }
}

/// A part of a file as a declared struct. Throws BadField, which names the place `key`.
template <class Part>
[[nodiscard]] Part part_of(const JsonValue& json, const char* key) {
  Part part{};
  const JsonPlace whole;
  read_json(json, JsonPlace(whole, key), part);
  return part;
}

}  // namespace talus
