// The part of ValueReader for values that have several forms, and for tables whose keys the user chooses.

#include <fmt/format.h>

#include <charconv>

#include "talus/project/values.hpp"

namespace talus::project {

bool ValueReader::into(const Value& value, std::optional<std::vector<double>>* member) {
  std::vector<double> numbers;
  if (!into(value, &numbers)) return false;
  *member = std::move(numbers);
  return true;
}

bool ValueReader::into(const Value& value, MapCellSlot slot) {
  const auto* text = value.node.as_string();
  if (text != nullptr && text->get() == "terrain") {
    slot.size->reset();
    return true;
  }
  double number = 0;
  if (!value.node.is_number()) return refuse_kind(value, "a number or \"terrain\"");
  if (!into(value, &number)) return false;
  *slot.size = number;
  return true;
}

bool ValueReader::into(const Value& value, SizeSlot slot) {
  RockSize read{.of = slot.of, .distribution = {}};
  if (!into(value, &read.distribution)) return false;
  *slot.size = read;
  return true;
}

bool ValueReader::into(const Value& value, SectionSlot slot) {
  if (value.node.is_string()) return into(value, slot.file);
  if (!value.node.is_array()) return refuse_kind(value, "a list of vertices [x, z], or a file name in quotes");
  return into(value, slot.vertices);
}

bool ValueReader::into(const Value& value, LimitSlot slot) {
  if (const auto* text = value.node.as_string()) {
    if (text->get() == "all") {
      slot.limit->reset();
      return true;
    }
    if (text->get() == "none") {
      *slot.limit = 0;
      return true;
    }
  }
  std::int64_t number = 0;
  if (!value.node.is_integer()) {
    const std::string_view unit = value.setting.unit.empty() ? "rocks" : value.setting.unit;
    return refuse_kind(value, fmt::format("\"all\", \"none\" or a number of {}", unit));
  }
  if (!into(value, &number)) return false;
  *slot.limit = number;
  return true;
}

bool ValueReader::into(const Value& value, std::map<std::int32_t, std::string>* member) {
  const toml::table* parts = value.node.as_table();
  if (!parts || parts->empty()) return refuse_kind(value, "{ 1 = \"...\", 2 = \"...\" } with one entry or more");
  std::map<std::int32_t, std::string> read;
  bool good = true;
  for (const auto& [key, node] : *parts) {
    const std::string_view name = key.str();
    const Value entry{value.setting, node, value.row, value.where, fmt::format("{}.{}", value.name, name)};
    std::int32_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    std::string text;
    if (error != std::errc{} || end != name.data() + name.size()) {
      good = refuse(entry, fmt::format("{} has the key \"{}\"", value.name, name),
                    "a class is a whole number of at most 32 bits");
    } else if (!into(entry, &text)) {
      good = false;
    } else if (!read.emplace(number, std::move(text)).second) {
      good = refuse(entry, fmt::format("{} repeats class {}", entry.name, number), "a class has one material");
    }
  }
  if (good) *member = std::move(read);
  return good;
}

bool ValueReader::into(const Value& value, std::map<std::string, std::string>* member) {
  const toml::table* parts = value.node.as_table();
  if (!parts || parts->empty()) return refuse_kind(value, "{ a = \"...\", b = \"...\" } with one entry or more");
  std::map<std::string, std::string> read;
  bool good = true;
  for (const auto& [key, node] : *parts) {
    const std::string name(key.str());
    const Value entry{value.setting, node, value.row, value.where, fmt::format("{}.{}", value.name, name)};
    good = into(entry, &read[name]) && good;
  }
  if (good) *member = std::move(read);
  return good;
}

}  // namespace talus::project
