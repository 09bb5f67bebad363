#include "talus/maps/source_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <system_error>

#include "talus/core/check.hpp"
#include "talus/files/output_file.hpp"
#include "talus/maps/map_files.hpp"

namespace talus {

namespace {

constexpr std::size_t longest_name = 100;  // bytes; file systems take 255

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80; }  // byte of a UTF-8 character

void cut_ends(std::string& name) {
  const auto first = name.find_first_not_of(" .");
  if (first == std::string::npos) {
    name.clear();
  } else {
    name = name.substr(first, name.find_last_not_of(" .") - first + 1);
  }
}

std::string in_small_letters(std::string name) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name;
}

/// Whether Windows treats the name as a device, whatever its extension.
bool is_device(const std::string& name) {
  const std::string word = in_small_letters(name.substr(0, name.find('.')));
  if (word == "con" || word == "prn" || word == "aux" || word == "nul") return true;
  return word.size() == 4 && (word.starts_with("com") || word.starts_with("lpt")) && word[3] >= '0' && word[3] <= '9';
}

std::string folder_name(const std::string& name) {
  constexpr std::string_view not_in_names = "/\\:*?\"<>|";
  std::string out;
  for (const char c : name) {
    const bool is_control = static_cast<unsigned char>(c) < ' ' || c == 127;
    out += is_control || not_in_names.find(c) != std::string_view::npos ? '_' : c;
  }
  cut_ends(out);
  if (out.size() > longest_name) {
    std::size_t end = longest_name;
    while (end > 0 && is_continuation(out[end])) --end;
    out.resize(end);
    cut_ends(out);
  }
  if (out.empty()) return "source";
  return is_device(out) ? "_" + out : out;
}

}  // namespace

std::vector<std::string> folder_names(std::span<const std::string> names) {
  std::vector<std::string> out;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    const std::string wanted = folder_name(name);
    std::string folder = wanted;
    for (int n = 2; !taken.insert(in_small_letters(folder)).second; ++n) folder = fmt::format("{}-{}", wanted, n);
    out.push_back(std::move(folder));
  }
  return out;
}

void write_source_maps(std::span<const Maps> maps, std::span<const std::string> sources, const MapSelection& selection,
                       const std::string& crs_wkt, const std::filesystem::path& folder) {
  TALUS_PROMISE(maps.size() == sources.size(), "every source has its maps");
  const std::vector<std::string> folders = folder_names(sources);
  std::string list = header_of<SourceRow>();
  MapSelection of_each = selection;
  of_each.bands.reset();  // ensembles are not divided by source
  for (std::size_t k = 0; k < maps.size(); ++k) {
    if (maps[k].rocks() == 0) continue;
    (void)write_maps(maps[k], of_each, crs_wkt, folder / folders[k]);
    append_row(list, SourceRow{folders[k], sources[k], maps[k].rocks()});
  }
  make_output_folder(folder);
  OutputFile file(folder / SourceRow::file_name);
  file.write(list);
  file.commit();
}

void remove_source_maps(const std::filesystem::path& folder) {
  std::error_code error, ignored;
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (!entry.is_symlink(ignored) && entry.is_directory(ignored)) folders.push_back(entry.path());
  }
  for (const std::filesystem::path& each : folders) {
    remove_maps(each);
    std::filesystem::remove(each, ignored);  // only if it is empty
  }
  std::filesystem::remove(folder / SourceRow::file_name, ignored);
  std::filesystem::remove(folder, ignored);
}

}  // namespace talus
