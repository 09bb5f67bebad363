#ifdef TALUS_HAS_GDAL

#include "talus/import/dxf_file.hpp"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <compare>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

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

// ---- the kinds of entities ----

/// The kinds that GDAL 3.6 reads, and viewports, which show other entities.
bool is_read_by_gdal(std::string_view kind) {
  static constexpr std::array<std::string_view, 22> read{
      "3DFACE",   "ARC",    "ATTDEF", "CIRCLE",     "DIMENSION", "ELLIPSE", "HATCH",       "HELIX",
      "INSERT",   "LEADER", "LINE",   "LWPOLYLINE", "MLINE",     "MTEXT",   "MULTILEADER", "POINT",
      "POLYLINE", "SPLINE", "SOLID",  "TEXT",       "TRACE",     "VIEWPORT"};
  return std::ranges::find(read, kind) != read.end() || kind == "MLEADER";
}

/// Parts of other entities, and the ends of lists.
bool is_part(std::string_view kind) {
  static constexpr std::array<std::string_view, 6> parts{"VERTEX", "SEQEND", "ATTRIB", "ENDBLK", "ENDSEC", "EOF"};
  return std::ranges::find(parts, kind) != parts.end();
}

/// One entity while its pairs are read.
struct DxfEntity {
  std::string kind, layer, block;  // `block`: that an INSERT refers to
  std::int64_t line = 0;
  bool is_on_paper = false, has_heights = false, is_uneven = false;
  std::optional<double> z;  // of the first point
  int flags = 0;

  /// Of the kinds that GDAL reads without their heights.
  [[nodiscard]] bool is_curve() const { return kind == "SPLINE" || kind == "HELIX"; }

  void take(const Pair& pair) {
    constexpr int block_name = 2, layer_name = 8, paper_space = 67, flag = 70, z_of_point = 30;
    switch (pair.code) {
      case layer_name:
        if (layer.empty()) layer = pair.value;
        break;
      case block_name:
        block = pair.value;
        break;
      case paper_space:
        is_on_paper = std::atoi(pair.value.c_str()) != 0;
        break;
      case flag:
        flags = std::atoi(pair.value.c_str());
        break;
      case z_of_point: {  // of a control point; curves through fit points alone are unreadable anyway
        if (!is_curve()) break;
        const double height = std::strtod(pair.value.c_str(), nullptr);
        has_heights = has_heights || height != 0;
        is_uneven = is_uneven || (z && *z != height);
        z = z.value_or(height);
        break;
      }
      default:
        break;
    }
  }
};

/// Entities of one kind on one layer of the model or of a block; of INSERT by the block that they refer to.
struct DxfGroup {
  std::string layer, kind, block;
  auto operator<=>(const DxfGroup&) const = default;
};

class DxfScan {
 public:
  explicit DxfScan(const std::filesystem::path& file) : text_(file) {}

  DxfContents contents() {
    while (const auto pair = text_.next()) {
      if (pair->code == 0) {
        end_entity();
        begin(pair->value);
      } else if (is_new_section_ && pair->code == 2) {
        section_ = pair->value;
        is_new_section_ = false;
      } else {
        entity_.take(*pair);
        if (section_ == "TABLES" && pair->code == 62) colour_ = std::atoi(pair->value.c_str());
      }
    }
    end_entity();
    add_inserted();
    return std::move(out_);
  }

 private:
  void begin(const std::string& kind) {
    is_new_section_ = kind == "SECTION";
    entity_ = {};
    entity_.kind = kind;
    entity_.line = text_.lines() - 1;
    colour_ = 0;
    if (kind == "ENDBLK") block_.clear();
  }

  void end_entity() {
    constexpr int is_frozen = 1, is_polygon_mesh = 16;
    DxfEntity& e = entity_;
    if (section_ == "TABLES") {
      if (e.kind == "LAYER" && (colour_ < 0 || (e.flags & is_frozen) != 0)) out_.hidden_layers.insert(e.block);
      return;
    }
    if (section_ == "BLOCKS" && e.kind == "BLOCK") {
      block_ = e.block;
      return;
    }
    if ((section_ != "ENTITIES" && section_ != "BLOCKS") || e.kind == "SECTION" || is_part(e.kind) || e.is_on_paper)
      return;
    if (e.kind == "POLYLINE" && (e.flags & is_polygon_mesh) != 0) e.kind = "polygon mesh";
    if (is_read_by_gdal(e.kind) && !e.is_curve() && e.kind != "INSERT") return;
    if (e.kind != "INSERT") e.block.clear();
    of_block_[section_ == "BLOCKS" ? block_ : ""][{e.layer, e.kind, e.block}].add(
        {.count = 1, .line = e.line, .has_heights = e.has_heights, .is_uneven = e.is_uneven});
  }

  /// Adds the entities of the model and of the blocks that are inserted in it, each block once for each layer.
  void add_inserted() {
    using Inserted = std::pair<std::string, std::string>;  // the block ("": the model) and the layer of its INSERT
    std::set<Inserted> seen{{"", ""}};
    std::vector<Inserted> next(seen.begin(), seen.end());
    while (!next.empty()) {
      const auto [block, layer] = std::move(next.back());
      next.pop_back();
      for (const auto& [group, found] : of_block_[block]) {
        // Entities on the layer 0 of a block are on that of the INSERT.
        const std::string& on = !block.empty() && group.layer == "0" ? layer : group.layer;
        if (group.kind == "INSERT") {
          if (!group.block.empty() && seen.insert({group.block, on}).second) next.emplace_back(group.block, on);
        } else {
          const bool is_curve = is_read_by_gdal(group.kind);
          (is_curve ? out_.curves : out_.unread)[{on, group.kind}].add(found);
        }
      }
    }
  }

  DxfText text_;
  std::string section_, block_;
  bool is_new_section_ = false;
  DxfEntity entity_;
  int colour_ = 0;                                               // of a layer; negative if it is off
  std::map<std::string, std::map<DxfGroup, DxfKind>> of_block_;  // "": the model
  DxfContents out_;
};

}  // namespace

void DxfKind::add(const DxfKind& more) {
  if (count == 0) line = more.line;
  count += more.count;
  has_heights = has_heights || more.has_heights;
  is_uneven = is_uneven || more.is_uneven;
}

DxfContents contents_of_dxf(const std::filesystem::path& file) { return DxfScan(file).contents(); }

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
