#include "talus/store/store_file.hpp"

#include <algorithm>

#include "talus/files/checksum.hpp"
#include "talus/files/output_file.hpp"
#include "talus/store/path_code.hpp"

namespace talus {

StoreFile::StoreFile(const StoreFacts& facts, std::uint64_t done) : facts_(facts), done_(done) {}

void StoreFile::add(std::uint64_t rock, std::uint32_t rows, std::string_view cells, std::string_view path) {
  rocks_.push_back(rock);
  paths_.push_back(path);
  cells_ += cells;
  rows_ += rows;
  largest_radius_ = std::max(largest_radius_, radius_in(path));
}

StoreExtent StoreFile::write(const std::filesystem::path& file) const {
  ByteWriter head;
  head.text(TALUS_VERSION);
  facts_.save(head);
  head.put(done_);
  head.put(rows_);
  head.put(largest_radius_);
  head.list(rocks_);
  std::uint64_t end = 0;
  for (const std::string_view path : paths_) head.put(end += path.size());
  for (const std::string_view path : paths_) head.put(static_cast<std::uint32_t>(checksum_of(path).low));
  head.text(cells_);
  const std::string& bytes = head.bytes();

  OutputFile out(file);
  ByteWriter preamble;
  for (const char c : store_magic) preamble.put(c);
  preamble.put(store_format);
  preamble.put(static_cast<std::uint32_t>(checksum_of(bytes).low));
  preamble.put(static_cast<std::uint64_t>(bytes.size()));
  out.write(preamble.bytes());
  out.write(bytes);
  for (const std::string_view path : paths_) out.write(path);
  const std::uint64_t size = out.position();
  out.commit();
  return {rocks_.size(), rows_, size};
}

}  // namespace talus
