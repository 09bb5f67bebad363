#include "talus/project/schema_module.hpp"

#include <fmt/format.h>

#include "talus/files/file_formats.hpp"
#include "talus/project/schema.hpp"

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;

/// Whether it is a table of settings, or a list of such tables.
bool is_table(const Json& node) {
  return node.is_object() && (node.contains("properties") || (node.contains("items") && is_table(node["items"])));
}

/// One line per setting, so that differences between versions are readable.
void write(const Json& node, const std::string& indent, std::string& out) {
  const std::string inner = indent + "  ";
  out += "{\n";
  for (const auto& [key, value] : node.items()) {
    out += inner + Json(key).dump() + ": ";
    if (is_table(value)) {
      write(value, inner, out);
    } else if (key == "properties") {
      out += "{\n";
      for (const auto& [name, setting] : value.items()) {
        out += inner + "  " + Json(name).dump() + ": ";
        if (is_table(setting)) {
          write(setting, inner + "  ", out);
        } else {
          out += setting.dump();
        }
        out += ",\n";
      }
      out += inner + "}";
    } else {
      out += value.dump();
    }
    out += ",\n";
  }
  out += indent + "}";
}

/// Of each table's settings that have it, a value of their schema, one line a table.
Json of_settings(const char* name) {
  const Json tables = schema()["properties"];
  Json found = Json::object();
  for (const auto& [key, node] : tables.items()) {
    if (!is_table(node)) continue;  // a key before the first table
    Json& of_table = found[key] = Json::object();
    const Json settings = (node.contains("items") ? node["items"] : node)["properties"];
    for (const auto& [setting, declared] : settings.items()) {
      if (declared.contains(name)) of_table[setting] = declared[name];
    }
  }
  return found;
}

void write_tables(const char* constant, const Json& tables, std::string& out) {
  out += fmt::format("\nexport const {} = {{", constant);
  const char* between = "\n";
  for (const auto& [key, of_table] : tables.items()) {
    out += fmt::format("{}  {}: {}", between, Json(key).dump(), of_table.dump());
    between = ",\n";
  }
  out += "\n};\n";
}

}  // namespace

std::string report_settings() {
  std::string out = R"(// When each setting has an effect, and its default if it is a plain value.
// Generated from the declarations of the settings (src/talus/project/settings) by schema_module.cpp; do not edit.
// To renew it: TALUS_RENEW_REFERENCE=1 and run the test ReportSettings.IsNotStale.
)";
  write_tables("settingConditions", of_settings("x-applies-when"), out);
  write_tables("settingDefaults", of_settings("default"), out);
  return out;
}

std::string schema_module() {
  std::string out =
      R"(// Generated from the declarations of the settings (src/talus/project/settings) and of the file formats
// (src/talus/files/file_formats.hpp) by schema_module.cpp; do not edit.
// To renew it: TALUS_RENEW_REFERENCE=1 and run the test SchemaModule.IsNotStale.

export const schema = )";
  write(schema(), "", out);
  out += " as const;\n\n/// The files that Talus reads, by their endings.\nexport const fileFormats = [\n";
  for (const FileFormat& format : file_formats)
    out += "  " + Json{{"ending", format.ending}, {"kind", name_of(format.kind)}}.dump() + ",\n";
  return out + "] as const;\n";
}

}  // namespace talus::project
