#include "talus/gdal/file_list.hpp"

#include <algorithm>
#include <system_error>

#include "talus/files/file_formats.hpp"

#ifdef TALUS_HAS_GDAL
#include <cpl_string.h>

#include "talus/gdal/gdal_files.hpp"
#include "talus/gdal/gdal_open.hpp"
#endif

namespace talus {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

#ifdef TALUS_HAS_GDAL
std::vector<fs::path> files_of_dataset(GdalKind kind, const fs::path& file) {
  std::vector<fs::path> files;
  try {
    GdalMessages messages;
    RasterProblems problems(file);
    const GDALDatasetUniquePtr dataset = open_with_gdal(kind, messages, problems);
    const CPLStringList names(dataset->GetFileList());
    for (int k = 0; k < names.size(); ++k) {
      std::error_code ignored;
      const auto on_disk = file_on_disk(fs::path(names[k]).lexically_normal(), ignored);
      if (on_disk && std::ranges::find(files, *on_disk) == files.end()) files.push_back(*on_disk);
    }
  } catch (const BadInput&) {
    return {};
  }
  return files;
}
#endif

}  // namespace

std::vector<fs::path> files_read_with(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) return files_in(file);
#ifdef TALUS_HAS_GDAL
  const auto on_disk = file_on_disk(file, error);
  if (!on_disk) return {file};
  if (*on_disk != file) return {*on_disk};
  const bool is_shapefile = ending_of(file) == ".shp";
  if (!is_shapefile && !is_of_kind(file, FileKind::raster)) return {file};
  std::vector<fs::path> files = files_of_dataset(is_shapefile ? GdalKind::vector : GdalKind::raster, file);
  if (!files.empty()) return files;
#endif
  return {file};
}

}  // namespace talus
