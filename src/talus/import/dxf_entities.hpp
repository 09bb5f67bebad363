#pragma once
// Which entities of a DXF belong to the model. Only for files that are built with GDAL.

#include <ogrsf_frmts.h>

#include <cstdint>
#include <set>
#include <string>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/import/dxf_file.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {

/// GDAL returns all entities in one layer, with the names of their CAD layers as an attribute. Entities in layouts
/// (paper space) are left out, and so are those on hidden layers, unless such a layer is requested.
class DxfEntities {
 public:
  /// Refuses files that are not in metres, and curves whose heights are used, because GDAL drops them.
  DxfEntities(OGRLayer& all, const VectorRequest& request, RasterProblems& problems);

  /// Whether an entity is to be read; counts it either way.
  [[nodiscard]] bool accepts(OGRFeature& entity);
  /// Whether an entity is a text, whose place is that of a label, not of a point of the ground.
  [[nodiscard]] static bool is_text(const OGRFeature& entity);
  /// Counts texts that were accepted, but left out.
  void note_texts(std::uint64_t count) { texts_ = count; }
  /// Records GDAL's message about an entity that it skipped because it could not read it.
  void note_unreadable(const std::string& failure);
  /// The requested layer; empty: all visible layers.
  [[nodiscard]] const std::string& layer() const { return wanted_; }
  /// How many entities of the requested layer were accepted, and how many were not.
  [[nodiscard]] std::uint64_t accepted() const { return accepted_; }
  [[nodiscard]] std::uint64_t left_out() const { return on_paper_ + hidden_; }
  /// The kinds that GDAL does not read at all, with their numbers: "1 MESH, 2 3DSOLID"; empty if there are none.
  [[nodiscard]] std::string unread_kinds() const;
  /// Warns about entities that were left out; throws BadInput if no entity is on the requested layer.
  void report();

 private:
  [[nodiscard]] std::string entities(std::uint64_t count) const;
  [[nodiscard]] bool is_wanted(const std::string& layer) const;
  void refuse_curves(const VectorRequest& request);

  RasterProblems& problems_;
  std::string wanted_, layer_key_;
  int layer_column_, paper_column_;
  DxfContents contents_;
  std::set<std::string> layers_, hidden_layers_;
  std::uint64_t accepted_ = 0, on_paper_ = 0, hidden_ = 0, texts_ = 0;
  std::string unreadable_;
};

}  // namespace talus
