#include "talus/calibration/saved_sets.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "talus/core/bytes.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/files/output_file.hpp"

namespace talus::calibration {

namespace {

constexpr std::string_view sets_ending = ".sets";

void write_sample(const Sample& sample, ByteWriter& out) {
  out.put(static_cast<std::uint64_t>(sample.rows.rows()));
  out.put(static_cast<std::uint64_t>(sample.rows.cols()));
  out.numbers(std::span<const double>(sample.rows.data(), static_cast<std::size_t>(sample.rows.size())));
  out.list(sample.strata);
  out.list(sample.rocks);
}

Sample read_sample(ByteReader& in) {
  const auto rows = in.get<std::uint64_t>(), columns = in.get<std::uint64_t>();
  expect_bytes(columns <= 8 && rows <= in.left() / sizeof(double), "a sample is too large");
  Sample sample;
  sample.rows.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  expect_bytes(rows * columns <= in.left() / sizeof(double), "a sample is too large");
  in.numbers(std::span<double>(sample.rows.data(), static_cast<std::size_t>(sample.rows.size())));
  sample.strata = in.list<std::uint32_t>();
  sample.rocks = in.list<std::uint32_t>();
  const auto is_complete = [&](const std::vector<std::uint32_t>& list) { return list.empty() || list.size() == rows; };
  expect_bytes(is_complete(sample.strata) && is_complete(sample.rocks), "a sample is incomplete");
  return sample;
}

}  // namespace

SavedSets::SavedSets(std::filesystem::path folder, std::string fingerprint)
    : folder_(std::move(folder)), fingerprint_(std::move(fingerprint)) {
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
  for (std::size_t k = 0; k < sets; ++k) {
    std::vector<Sample>& samples = samples_[first + k];
    const std::size_t groups = in.count(1);
    samples.clear();
    for (std::size_t g = 0; g < groups; ++g) samples.push_back(read_sample(in));
  }
  in.expect_end();
}

std::optional<std::vector<Sample>> SavedSets::of(std::size_t set) const {
  const auto found = samples_.find(set);
  if (found == samples_.end()) return std::nullopt;
  return found->second;
}

void SavedSets::save(std::size_t first, const std::vector<SetResult>& sets) const {
  ByteWriter out;
  out.text(fingerprint_);
  out.put(static_cast<std::uint64_t>(first));
  out.count(sets.size());
  for (const SetResult& set : sets) {
    out.count(set.samples.size());
    for (const Sample& sample : set.samples) write_sample(sample, out);
  }
  const std::string content = out.take();
  ByteWriter digest;
  digest.text(text_of(checksum_of(content)));
  OutputFile file(folder_ / fmt::format("{:07}{}", first, sets_ending));
  file.write(digest.bytes());
  file.write(content);
  file.commit();
}

}  // namespace talus::calibration
