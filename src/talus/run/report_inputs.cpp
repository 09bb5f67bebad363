#include "talus/run/report_inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "talus/core/bytes.hpp"
#include "talus/core/problems.hpp"
#include "talus/core/utf8.hpp"
#include "talus/files/picture_file.hpp"
#include "talus/files/sha256.hpp"
#include "talus/gdal/file_list.hpp"
#include "talus/project/material_sources.hpp"

namespace talus::project {

namespace {

namespace fs = std::filesystem;

/// Its name relative to the folder of the project, unless the project names it by an absolute path.
fs::path name_of_input(const fs::path& folder, const fs::path& named, const fs::path& file) {
  if (named.is_absolute()) return file;
  const fs::path from = folder.empty() ? fs::path(".") : folder;
  return file.lexically_normal().lexically_relative(from.lexically_normal());
}

std::vector<InputFile> input_files(const Project& project) {
  std::vector<InputFile> files{
      {as_utf8(project.file.filename().string()), project.source.bytes, project.source.sha256}};
  const fs::path folder = project.file.parent_path();
  for (const NamedFile& named : project.named_files) {
    if (named.is_layer()) continue;
    for (const fs::path& file : files_read_with(folder / named.file)) {
      std::string name = as_utf8(name_of_input(folder, named.file, file).string());
      if (std::ranges::any_of(files, [&](const InputFile& known) { return known.name == name; })) continue;
      std::error_code error;
      const std::uintmax_t bytes = fs::file_size(file, error);
      files.push_back({std::move(name), error ? 0 : bytes, sha256_of_file(file).value_or("")});
    }
  }
  return files;
}

std::string logo_of(const Project& project) {
  const fs::path& logo = project.title_block.logo;
  if (logo.empty()) return {};
  try {
    return data_address_of_picture(project.file.parent_path() / logo);
  } catch (const BadBytes& bad) {
    throw BadInput(Problem{.file = project.file.string(),
                           .where = "[report]",
                           .what = "logo is \"" + logo.string() + '"',
                           .why = bad.what()});
  }
}

}  // namespace

std::vector<MaterialSource> material_sources(const Project& project) {
  std::vector<MaterialSource> sources;
  for (SourceOfValues& each : sources_of_values(project)) {
    sources.push_back({std::move(each.material), std::move(each.like), std::move(each.keys), std::move(each.source)});
  }
  return sources;
}

ReportInputs report_inputs(const Project& project) {
  return {.files = input_files(project), .material_sources = material_sources(project), .logo = logo_of(project)};
}

}  // namespace talus::project
