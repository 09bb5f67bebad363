#pragma once
// Which entities of a DXF are of the model. For files that are built with GDAL only.

#include <ogrsf_frmts.h>

#include <cstdint>
#include <set>
#include <string>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {

/// GDAL gives all entities in one layer, with the names of their CAD layers as an attribute. Left out are those of
/// layouts (paper space), and those of hidden layers unless one of these is asked for.
class DxfEntities {
 public:
  /// Refuses files that are not in metres.
  DxfEntities(OGRLayer& all, const VectorRequest& request, RasterProblems& problems);

  [[nodiscard]] bool takes(OGRFeature& entity);
  /// Remembers what GDAL said of an entity that it could not read, and went on to the next one.
  void note_unreadable(const std::string& failure);
  /// The layer that is asked for; empty: all that are shown.
  [[nodiscard]] const std::string& layer() const { return wanted_; }
  /// How many were taken, and how many of the layer that is asked for were not.
  [[nodiscard]] std::uint64_t taken() const { return taken_; }
  [[nodiscard]] std::uint64_t left_out() const { return on_paper_ + hidden_; }
  /// Warns of what was left out; throws BadInput where no entity has the layer that is asked for.
  void report();

 private:
  [[nodiscard]] std::string entities(std::uint64_t count) const;

  RasterProblems& problems_;
  std::string wanted_, layer_key_;
  int layer_column_, paper_column_;
  std::set<std::string> layers_, hidden_layers_;
  std::uint64_t taken_ = 0, on_paper_ = 0, hidden_ = 0;
  std::string unreadable_;
};

}  // namespace talus
