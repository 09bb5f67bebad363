// The part of ValueReader for values that are a number or a word.

#include "talus/project/values.hpp"

namespace talus::project {

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

bool ValueReader::into(const Value& value, RockLimitSlot slot) {
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
  if (!value.node.is_integer()) return refuse_kind(value, "\"all\", \"none\" or a number of rocks");
  if (!into(value, &number)) return false;
  *slot.limit = number;
  return true;
}

}  // namespace talus::project
