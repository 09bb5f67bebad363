#include "talus/store/store_file.hpp"

#include <algorithm>

#include "talus/files/checksum.hpp"
#include "talus/files/output_file.hpp"
#include "talus/store/path_code.hpp"

namespace talus {

namespace {

/// What stands before the paths: facts, directory and index.
void save_head(ByteWriter& out, const StoreFacts& facts, std::uint64_t done, std::span<const StoredRock> rocks) {
  std::uint64_t rows = 0, cells = 0;
  double largest_radius = 0;
  for (const StoredRock& rock : rocks) {
    rows += rock.rows;
    cells += rock.cells_size;
    largest_radius = std::max(largest_radius, radius_in(rock.path()));
  }
  out.text(TALUS_VERSION);
  facts.save(out);
  out.put(done);
  out.put(rows);
  out.put(largest_radius);
  out.count(rocks.size());
  for (const StoredRock& rock : rocks) out.put(rock.rock);
  std::uint64_t end = 0;
  for (const StoredRock& rock : rocks) out.put(end += rock.path_size);
  for (const StoredRock& rock : rocks) out.put(static_cast<std::uint32_t>(checksum_of(rock.path()).low));
  out.count(cells);
  for (const StoredRock& rock : rocks) out.numbers(std::span(rock.cells()));
}

}  // namespace

StoreExtent write_store(const std::filesystem::path& file, const StoreFacts& facts, std::uint64_t done,
                        std::span<const StoredRock> rocks) {
  // Size and checksum of the head come before it: it is made twice, piece by piece, since it may be large.
  Checksum checksum;
  std::uint64_t head_size = 0;
  ByteWriter measured([&](std::string_view piece) {
    checksum.add(piece);
    head_size += piece.size();
  });
  save_head(measured, facts, done, rocks);
  measured.flush();

  OutputFile out(file);
  ByteWriter head([&](std::string_view piece) { out.write(piece); });
  for (const char c : store_magic) head.put(c);
  head.put(store_format);
  head.put(static_cast<std::uint32_t>(checksum.digest().low));
  head.put(head_size);
  save_head(head, facts, done, rocks);
  head.flush();
  StoreExtent extent{.rocks = rocks.size()};
  for (const StoredRock& rock : rocks) {
    out.write(rock.path());
    extent.rows += rock.rows;
  }
  extent.bytes = out.position();
  out.commit();
  return extent;
}

}  // namespace talus
