#include "talus/study/saved_sets.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "talus/core/bytes.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/files/output_file.hpp"

namespace talus::study {

namespace {

constexpr std::string_view sets_ending = ".sets";

}  // namespace

SavedSets::SavedSets(const std::filesystem::path& folder, std::string fingerprint)
    : folder_(folder / "sets"), fingerprint_(std::move(fingerprint)) {
  make_output_folder(folder_);
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    if (entry.path().extension() == sets_ending && !not_an_ordinary_file(entry.path())) files.push_back(entry.path());
  }
  for (const std::filesystem::path& file : files) {
    try {
      read(file);
    } catch (const BadBytes&) {
      std::filesystem::remove(file, error);
    }
  }
}

void SavedSets::read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  const std::string bytes = std::move(content).str();
  ByteReader in(bytes);
  const std::string digest = in.text();
  expect_bytes(digest == text_of(checksum_of(std::string_view(bytes).substr(bytes.size() - in.left()))), "damaged");
  expect_bytes(in.text() == fingerprint_, "of another study");
  const auto first = in.get<std::uint64_t>();
  const std::size_t sets = in.count(1);
  for (std::size_t k = 0; k < sets; ++k) results_[first + k] = in.text();
  in.expect_end();
}

std::optional<std::string_view> SavedSets::of(std::size_t set) const {
  const auto found = results_.find(set);
  if (found == results_.end()) return std::nullopt;
  return found->second;
}

void SavedSets::save(std::size_t first, const std::vector<std::string>& results) const {
  ByteWriter out;
  out.text(fingerprint_);
  out.put(static_cast<std::uint64_t>(first));
  out.count(results.size());
  for (const std::string& result : results) out.text(result);
  const std::string content = out.take();
  ByteWriter digest;
  digest.text(text_of(checksum_of(content)));
  OutputFile file(folder_ / fmt::format("{:07}{}", first, sets_ending));
  file.write(digest.bytes());
  file.write(content);
  file.commit();
}

}  // namespace talus::study
