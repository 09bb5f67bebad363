#ifdef TALUS_HAS_GDAL

#include "talus/export/geopackage_file.hpp"

#include <system_error>

#include "talus/files/output_file.hpp"
#include "talus/gdal/raster_crs.hpp"

namespace talus {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, std::string why, std::string hint,
                         std::string option = {}) {
  throw BadInput(Problem{.file = file.string(),
                         .what = "cannot write this file",
                         .why = std::move(why),
                         .hint = std::move(hint),
                         .option = std::move(option)});
}

[[noreturn]] void refuse_to_write(const std::filesystem::path& file, std::string why) {
  refuse(file, std::move(why), "Free some space, or choose another folder", "-o");
}

}  // namespace

GeoPackageFile::GeoPackageFile(std::filesystem::path path, const std::string& crs_wkt)
    : path_(std::move(path)), part_(path_), messages_(GdalFiles::in_folder(path_.parent_path())) {
  part_ += ".part";
  make_output_folder(path_.parent_path());
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (driver == nullptr) {
    refuse(path_, "the GDAL library of this machine has no driver GPKG",
           "Install GDAL with its usual drivers, or set geopackage = \"none\"");
  }
  if (const auto crs = crs_for_file(crs_wkt)) {
    crs_ = *crs;
  } else {
    crs_.SetLocalCS("Undefined Cartesian SRS");  // the format's number -1
  }
  messages_.clear();
  std::error_code error;
  std::filesystem::remove(part_, error);  // left by a killed run
  dataset_.reset(driver->Create(part_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset_ || dataset_->StartTransaction() != OGRERR_NONE) fail();
}

GeoPackageFile::~GeoPackageFile() {
  if (is_committed_) return;
  dataset_.reset();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void GeoPackageFile::fail() const { refuse_to_write(path_, messages_.failure()); }

OGRLayer& GeoPackageFile::add_layer(const char* name, OGRwkbGeometryType type, const char* meaning,
                                    std::span<const GeoField> fields) {
  char** options = CSLSetNameValue(nullptr, "DESCRIPTION", meaning);
  OGRLayer* layer = dataset_->CreateLayer(name, &crs_, type, options);
  CSLDestroy(options);
  if (layer == nullptr) fail();
  for (const GeoField& field : fields) {
    OGRFieldDefn definition(field.name.c_str(), field.type);
    if (layer->CreateField(&definition) != OGRERR_NONE) fail();
  }
  return *layer;
}

void GeoPackageFile::add(OGRLayer& layer, OGRFeature& feature) {
  if (layer.CreateFeature(&feature) != OGRERR_NONE) fail();
}

void GeoPackageFile::commit() {
  if (dataset_->CommitTransaction() != OGRERR_NONE) fail();
  dataset_.reset();
  if (messages_.has_failure()) fail();  // errors while a file is closed are only messages
  finish_file(part_, path_);
  is_committed_ = true;
}

}  // namespace talus

#endif
