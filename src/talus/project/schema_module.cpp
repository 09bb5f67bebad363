#include "talus/project/schema_module.hpp"

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

}  // namespace

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
