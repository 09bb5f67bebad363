#ifdef TALUS_HAS_GDAL

#include "talus/import/dxf_entities.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <string_view>
#include <vector>

#include "talus/files/names_in_words.hpp"
#include "talus/import/dxf_file.hpp"

namespace talus {

namespace {

constexpr int no_unit = 0, metres = 6;

/// GDAL makes the colour of entities on layers that are off or frozen transparent: "PEN(c:#ff000000)".
bool is_hidden(const OGRFeature& entity) {
  const char* style = entity.GetStyleString();
  constexpr std::string_view before = "c:#", transparent = "00";
  constexpr std::size_t colour = 6;
  const std::string_view text = style ? style : "";
  const std::size_t at = text.find(before);
  if (at == std::string_view::npos || text.size() < at + before.size() + colour + transparent.size()) return false;
  return text.substr(at + before.size() + colour).starts_with(transparent);
}

/// Names the entity from GDAL's "error at line 7586 of plan.dxf", which gives the line where it ends.
std::string unreadable_entity(const std::filesystem::path& file, const std::string& failure) {
  constexpr std::string_view before = "error at line ";
  const std::size_t at = failure.find(before);
  std::int64_t line = 0;
  if (at != std::string::npos) {
    std::from_chars(failure.data() + at + before.size(), failure.data() + failure.size(), line);
  }
  const std::string name = line > 0 ? last_entity_in_dxf(file, line) : "";
  return name.empty() ? failure : fmt::format("the first is the {} that ends at line {}", name, line);
}

void check_unit(RasterProblems& problems) {
  const int unit = unit_of_dxf(problems.file()).value_or(no_unit);
  if (unit == no_unit || unit == metres) return;
  problems.refuse(
      fmt::format("is in {}", name_of_dxf_unit(unit)),
      fmt::format("its header has $INSUNITS = {}; Talus needs metres", unit),
      "Scale the drawing to metres and set its unit to metres; if its numbers are metres already, only set the unit");
}

}  // namespace

DxfEntities::DxfEntities(OGRLayer& all, const VectorRequest& request, RasterProblems& problems)
    : problems_(problems),
      wanted_(request.layer == all.GetName() ? "" : request.layer),
      layer_key_(request.layer_key),
      layer_column_(all.GetLayerDefn()->GetFieldIndex("Layer")),
      paper_column_(all.GetLayerDefn()->GetFieldIndex("PaperSpace")),
      contents_(contents_of_dxf(problems.file())) {
  check_unit(problems);
  if (request.heights_are_used) refuse_curves(request);
}

bool DxfEntities::is_wanted(const std::string& layer) const {
  return wanted_.empty() ? !contents_.hidden_layers.contains(layer) : layer == wanted_;
}

void DxfEntities::refuse_curves(const VectorRequest& request) {
  for (const auto& [place, curves] : contents_.curves) {
    const auto& [layer, kind] = place;
    if (!is_wanted(layer) || !(request.level_lines_are_drawn ? curves.is_uneven : curves.has_heights)) continue;
    problems_.refuse(
        fmt::format("has {} {}{} with heights on layer \"{}\"", curves.count, kind, curves.count == 1 ? "" : "s",
                    layer),
        fmt::format("the first begins at line {}; GDAL reads such curves without their heights", curves.line),
        "Convert them to 3D polylines");
  }
}

bool DxfEntities::is_text(const OGRFeature& entity) {
  const char* style = entity.GetStyleString();
  return style && std::string_view(style).starts_with("LABEL(");
}

std::string DxfEntities::unread_kinds() const {
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [place, found] : contents_.unread) {
    if (is_wanted(place.first)) counts[place.second] += found.count;
  }
  std::string words;
  for (const auto& [kind, count] : counts) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, kind);
  return words;
}

bool DxfEntities::accepts(OGRFeature& entity) {
  const std::string layer = layer_column_ >= 0 ? entity.GetFieldAsString(layer_column_) : "";
  layers_.insert(layer);
  if (!wanted_.empty() && layer != wanted_) return false;
  if (paper_column_ >= 0 && entity.IsFieldSetAndNotNull(paper_column_) &&
      entity.GetFieldAsInteger(paper_column_) != 0) {
    ++on_paper_;
    return false;
  }
  if (wanted_.empty() && is_hidden(entity)) {
    ++hidden_;
    hidden_layers_.insert(layer);
    return false;
  }
  ++accepted_;
  return true;
}

void DxfEntities::note_unreadable(const std::string& failure) {
  if (unreadable_.empty()) unreadable_ = failure;
}

std::string DxfEntities::entities(std::uint64_t count) const {
  return fmt::format("{} of {} entities {}", count, accepted_ + left_out(), count == 1 ? "is" : "are");
}

void DxfEntities::report() {
  if (!wanted_.empty() && !layers_.contains(wanted_)) {
    const std::vector<std::string> names(layers_.begin(), layers_.end());
    problems_.stop(fmt::format("has no layer \"{}\"", wanted_), fmt::format("it has {}", listed(names)),
                   meant(wanted_, names));
  }
  if (on_paper_ > 0) {
    problems_.warn(entities(on_paper_) + " in a layout", "that is paper space, not the model; they are left out");
  }
  if (hidden_ > 0) {
    const std::vector<std::string> names(hidden_layers_.begin(), hidden_layers_.end());
    problems_.warn(entities(hidden_) + " on a layer that is switched off or frozen",
                   fmt::format("layers left out: {}", listed(names)),
                   fmt::format("To read such a layer, name it: {} = \"{}\"", layer_key_, names.front()));
  }
  if (texts_ > 0) {
    problems_.warn(entities(texts_) + (texts_ == 1 ? " a text" : " texts"),
                   "their places are those of labels; they are left out");
  }
  if (const std::string kinds = unread_kinds(); !kinds.empty()) {
    problems_.warn("has entities of kinds that are not read", kinds,
                   "They are left out; if they are part of the ground, convert them to 3D faces or polylines");
  }
  if (!unreadable_.empty()) {
    problems_.warn("has entities that GDAL cannot read", unreadable_entity(problems_.file(), unreadable_),
                   "They are left out; if they are part of the ground, convert them to polylines");
  }
}

}  // namespace talus

#endif
