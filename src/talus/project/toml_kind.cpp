#include "talus/project/toml_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace talus::project {

namespace {

struct Kind {
  TomlKind kind;
  std::vector<std::string_view> tables;  // that no other kind has
  const char* name;
  const char* use;  // the hint where it is not expected
};

const std::array<Kind, 3>& kinds() {
  static const std::array<Kind, 3> list{{
      {TomlKind::project, {"terrain", "seeder"}, "a project", "Name it in a study, as project of a [[site]]"},
      {TomlKind::calibration, {"observations"}, "the study of a calibration", "Use talus calibrate"},
      {TomlKind::sensitivity, {"result"}, "the study of a sensitivity analysis", "Use talus sensitivity"},
  }};
  return list;
}

bool has_any(const Document& document, const Kind& kind) {
  return std::ranges::any_of(kind.tables, [&](std::string_view table) { return document.root().contains(table); });
}

}  // namespace

void expect_kind(const Document& document, TomlKind expected) {
  const Kind* found = nullptr;
  const Kind* wanted = nullptr;
  for (const Kind& each : kinds()) {
    if (each.kind == expected) wanted = &each;
    if (!has_any(document, each)) continue;
    if (found != nullptr) return;
    found = &each;
  }
  if (found == nullptr || found == wanted) return;
  throw BadInput(Problem{.file = document.file(),
                         .what = fmt::format("this is {}", found->name),
                         .why = fmt::format("expected {}", wanted->name),
                         .hint = found->use});
}

}  // namespace talus::project
