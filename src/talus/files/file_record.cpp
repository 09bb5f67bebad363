#include "talus/files/file_record.hpp"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include <nlohmann/json.hpp>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/json_file.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/files/output_file.hpp"

namespace talus {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* files_key = "files";

bool is_changed_by_readers(const fs::path& name) { return name.extension() == ".gpkg"; }

/// Whether a name in a record, which cannot be trusted, refers to a file in the folder.
bool stays_in_folder(const fs::path& name) {
  if (name.empty() || name.is_absolute()) return false;
  return std::ranges::none_of(name, [](const fs::path& part) { return part.empty() || part == "." || part == ".."; });
}

/// nullopt if it is not an ordinary file, or cannot be read.
std::optional<Json> record_of(const fs::path& file, const fs::path& name) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error || not_an_ordinary_file(file)) return std::nullopt;
  Json record{{"bytes", bytes}};
  if (is_changed_by_readers(name)) return record;
  Checksum checksum;
  std::ifstream in(file, std::ios::binary);
  std::string piece(std::size_t{1} << 20, '\0');
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0) {
    stop_point();
    checksum.add(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  if (!in.eof()) return std::nullopt;
  record["xxh128"] = text_of(checksum.digest());
  return record;
}

void write(const fs::path& folder, const Json& files) {
  OutputFile file(folder / file_record_name);
  file.write(Json{{files_key, files}}.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  file.commit();
}

/// nullopt if there is no record, or it cannot be read.
std::optional<Json> read(const fs::path& folder) {
  try {
    Json json = read_json_object<Json>(folder / file_record_name, "");
    const bool is_record = json.contains(files_key) && json.at(files_key).is_object();
    return is_record ? std::optional(json.at(files_key)) : std::nullopt;
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

struct Entry {
  std::string name;
  std::optional<Json> record;
};

void read_entries(const fs::path& folder, std::vector<Entry>& entries, bool also_parts) {
  const StopScope* const here = StopScope::current();
  tbb::parallel_for_each(entries, [&](Entry& entry) {
    const StopScope there(here);
    const fs::path whole = folder / entry.name, part = OutputFile::part_of(whole);
    std::error_code ignored;
    entry.record = record_of(also_parts && fs::exists(part, ignored) ? part : whole, entry.name);
  });
}

}  // namespace

void write_file_record(const fs::path& folder, std::span<const std::string> names) {
  std::vector<Entry> entries;
  for (const std::string& name : names) entries.push_back({name, {}});
  read_entries(folder, entries, true);
  Json files = Json::object();
  for (Entry& entry : entries) {
    if (!entry.record) {
      throw BadInput(Problem{.file = (folder / entry.name).string(),
                             .what = "cannot be read",
                             .why = "it was written by this run",
                             .hint = "Is another program working in this folder?"});
    }
    files[entry.name] = std::move(*entry.record);
  }
  write(folder, files);
}

std::optional<std::string> changed_file(const fs::path& folder) {
  const auto files = read(folder);
  if (!files) return file_record_name;
  std::vector<Entry> entries;
  for (const auto& [name, record] : files->items()) entries.push_back({name, {}});
  read_entries(folder, entries, false);
  for (const Entry& entry : entries) {
    if (!entry.record || *entry.record != files->at(entry.name)) return entry.name;
  }
  return std::nullopt;
}

std::vector<std::string> recorded_files(const fs::path& folder) {
  std::vector<std::string> names;
  const auto files = read(folder);
  if (!files) return names;
  for (const auto& [name, record] : files->items()) {
    if (stays_in_folder(name)) names.push_back(name);
  }
  return names;
}

void remove_recorded_files_but(const fs::path& folder, std::span<const std::string> kept) {
  std::error_code error;
  for (const std::string& name : recorded_files(folder)) {
    if (std::ranges::find(kept, name) != kept.end() || name == file_record_name) continue;
    const fs::path file = fs::canonical(folder, error) / name;
    if (error || fs::canonical(file.parent_path(), error) != file.parent_path()) continue;
    if (fs::symlink_status(file, error).type() == fs::file_type::regular) fs::remove(file, error);
  }
}

void renew_in_record(const fs::path& folder, const std::string& name) {
  auto files = read(folder);
  if (!files || !files->contains(name)) return;
  if (auto record = record_of(folder / name, name)) {
    (*files)[name] = std::move(*record);
    write(folder, *files);
  }
}

}  // namespace talus
