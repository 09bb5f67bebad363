#ifdef TALUS_HAS_GDAL

#include "talus/import/dxf_file.hpp"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <memory>
#include <string_view>

#include "talus/gdal/gdal_raster.hpp"

namespace talus {

namespace {

constexpr int longest_dxf_line = 4096;            // bytes; the format has 2049
constexpr std::int64_t longest_header = 100'000;  // lines; some 300 variables of 2 to 8

struct Pair {
  int code = 0;
  std::string value;
};

/// Reads through GDAL's file system, because the file may be in an archive.
class DxfText {
 public:
  explicit DxfText(const std::filesystem::path& file) : quiet_(GdalFiles(file)), file_(VSIFOpenL(file.c_str(), "rb")) {}

  std::optional<Pair> next() {
    const auto code = line(), value = line();
    Pair pair;
    if (!code || !value) return std::nullopt;
    if (std::from_chars(code->data(), code->data() + code->size(), pair.code).ec != std::errc{}) return std::nullopt;
    pair.value = *value;
    return pair;
  }
  [[nodiscard]] std::int64_t lines() const { return lines_; }

 private:
  struct Close {
    void operator()(VSILFILE* file) const { VSIFCloseL(file); }
  };

  std::optional<std::string> line() {
    const char* text = file_ ? CPLReadLine2L(file_.get(), longest_dxf_line, nullptr) : nullptr;
    if (!text) return std::nullopt;
    ++lines_;
    const std::string_view all(text);
    const auto begin = std::min(all.find_first_not_of(" \t"), all.size());
    return std::string(all.substr(begin, all.find_last_not_of(" \t\r") + 1 - begin));
  }

  const GdalMessages quiet_;
  std::unique_ptr<VSILFILE, Close> file_;
  std::int64_t lines_ = 0;
};

}  // namespace

std::optional<int> unit_of_dxf(const std::filesystem::path& file) {
  DxfText text(file);
  while (const auto pair = text.next()) {
    if (pair->value == "ENDSEC" || text.lines() > longest_header) break;
    if (pair->code != 9 || pair->value != "$INSUNITS") continue;
    const auto unit = text.next();
    int number = 0;
    if (!unit || unit->code != 70) break;
    const auto [end, error] = std::from_chars(unit->value.data(), unit->value.data() + unit->value.size(), number);
    return error == std::errc{} ? std::optional(number) : std::nullopt;
  }
  return std::nullopt;
}

std::string name_of_dxf_unit(int unit) {
  static constexpr std::array<std::string_view, 22> names{
      "no unit",       "inches",      "feet",        "miles",      "millimetres",        "centimetres", "metres",
      "kilometres",    "microinches", "mils",        "yards",      "angstroms",          "nanometres",  "microns",
      "decimetres",    "decametres",  "hectometres", "gigametres", "astronomical units", "light years", "parsecs",
      "US survey feet"};
  if (unit < 0 || unit >= static_cast<int>(names.size())) return fmt::format("the unit {}", unit);
  return std::string(names[static_cast<std::size_t>(unit)]);
}

std::string last_entity_in_dxf(const std::filesystem::path& file, std::int64_t line) {
  DxfText text(file);
  std::string name;
  while (const auto pair = text.next()) {
    if (text.lines() > line) break;
    if (pair->code == 0) name = pair->value;
  }
  return name;
}

bool is_whole_dxf(const std::filesystem::path& file) {
  return last_entity_in_dxf(file, std::numeric_limits<std::int64_t>::max()) == "EOF";
}

}  // namespace talus

#endif
