#include "talus/archive/run_state.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <system_error>

#include "talus/core/bytes.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/output_file.hpp"

namespace talus {

namespace {

constexpr std::string_view magic = "talus run state\n";
constexpr std::uint32_t format = run_state_format;
constexpr std::size_t digest_size = 16;
constexpr std::size_t preamble_size = magic.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t);
constexpr const char* cut_short = "it was cut short";

void put(ByteWriter& out, const Digest& digest) {
  out.put(digest.high);
  out.put(digest.low);
}

Digest get_digest(ByteReader& in) {
  Digest digest;
  digest.high = in.get<std::uint64_t>();
  digest.low = in.get<std::uint64_t>();
  return digest;
}

std::string saved(const RunStateHeader& header, std::string_view description) {
  ByteWriter out;
  out.text(TALUS_VERSION);
  out.text(description);
  out.put(header.range.first);
  out.put(header.range.last);
  out.put(header.done);
  out.put(header.shard ? header.shard->number : 0);
  out.put(header.shard ? header.shard->of : 0);
  out.put(header.seconds);
  out.put(static_cast<std::int32_t>(header.threads));
  out.count(header.tables.size());
  for (const TableMark& mark : header.tables) mark.save(out);
  return out.take();
}

RunStateHeader header_from(std::string_view bytes) {
  ByteReader in(bytes);
  RunStateHeader header;
  if (const std::string version = in.text(); version != TALUS_VERSION) {
    throw BadBytes(fmt::format("talus {} wrote it, this is talus {}, which may compute different results", version,
                               TALUS_VERSION));
  }
  header.description = description_from(in.text());
  header.range.first = in.get<std::uint64_t>();
  header.range.last = in.get<std::uint64_t>();
  header.done = in.get<std::uint64_t>();
  expect_bytes(header.range.first <= header.done && header.done <= header.range.last &&
                   header.range.last <= header.description.rocks,
               "its rocks disagree");
  const auto number = in.get<std::uint64_t>(), of = in.get<std::uint64_t>();
  expect_bytes(number <= of, "its shard is not valid");
  if (number > 0) header.shard = Shard{number, of};
  header.seconds = in.get<double>();
  header.threads = in.get<std::int32_t>();
  expect_bytes(std::isfinite(header.seconds) && header.seconds >= 0 && header.threads > 0, "its timings are damaged");
  constexpr std::size_t least_mark = sizeof(std::uint64_t) + 1 + sizeof(std::uint64_t) + digest_size;
  for (std::size_t left = in.count(least_mark); left > 0; --left) header.tables.push_back(TableMark::read(in));
  in.expect_end();
  return header;
}

/// The length of the header, after checking the bytes before it.
std::uint64_t header_size(std::string_view preamble) {
  const std::string_view begin = preamble.substr(0, magic.size());
  expect_bytes(!begin.empty(), "it is empty");
  expect_bytes(begin == magic.substr(0, begin.size()), "it is not the state of a run");
  expect_bytes(preamble.size() >= preamble_size, cut_short);
  ByteReader in(preamble.substr(magic.size()));
  expect_bytes(in.get<std::uint32_t>() == format, "another version of talus wrote it");
  return in.get<std::uint64_t>();
}

[[noreturn]] void refuse(const std::filesystem::path& file, std::string why) {
  throw BadInput(Problem{.file = file.string(),
                         .what = "cannot use this state of a run",
                         .why = std::move(why),
                         .hint = "Remove it, and run these rocks again without --resume"});
}

std::uint64_t size_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) refuse(file, error.message());
  return size;
}

/// The first `most` bytes, or all if there are fewer.
std::string read_bytes(const std::filesystem::path& file, std::uint64_t most) {
  std::string bytes(std::min(size_of(file), most), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) refuse(file, "reading it failed");
  return bytes;
}

}  // namespace

std::string saved(const RunDescription& description) { return json_text(description); }

void write_run_state(const std::filesystem::path& file, const RunStateHeader& header,
                     std::span<SummingObserver* const> observers) {
  write_run_state(file, header, saved(header.description), observers);
}

void write_run_state(const std::filesystem::path& file, const RunStateHeader& header, std::string_view description,
                     std::span<SummingObserver* const> observers) {
  OutputFile output(file);
  Checksum checksum;
  ByteWriter out([&](std::string_view piece) {
    checksum.add(piece);
    output.write(piece);
  });
  const std::string head = saved(header, description);
  for (const char c : magic) out.put(c);
  out.put(format);
  out.text(head);
  put(out, checksum_of(head));
  for (SummingObserver* observer : observers) observer->save(out);
  out.flush();
  put(out, checksum.digest());
  out.flush();
  output.commit();
}

RunStateHeader read_header(std::string_view bytes) {
  const std::uint64_t size = header_size(bytes.substr(0, preamble_size));
  ByteReader in(bytes.substr(preamble_size));
  expect_bytes(size <= in.left() && in.left() - size >= digest_size, cut_short);
  const std::string_view head = in.bytes(size);
  expect_bytes(get_digest(in) == checksum_of(head), "it was changed or damaged");
  return header_from(head);
}

void merge_state(std::string_view bytes, std::span<SummingObserver* const> observers) {
  const std::uint64_t size = header_size(bytes.substr(0, preamble_size));
  const std::size_t left = bytes.size() - preamble_size;
  expect_bytes(size <= left && left - size >= 2 * digest_size, cut_short);
  const std::string_view all = bytes.substr(0, bytes.size() - digest_size);
  ByteReader end(bytes.substr(all.size()));
  expect_bytes(get_digest(end) == checksum_of(all), "it was cut short, changed or damaged");
  ByteReader in(all.substr(preamble_size + size + digest_size));
  for (SummingObserver* observer : observers) observer->merge_saved(in);
  in.expect_end();
}

RunStateHeader read_run_state_header(const std::filesystem::path& file) {
  try {
    const std::uint64_t size = header_size(read_bytes(file, preamble_size));
    expect_bytes(size <= size_of(file), cut_short);
    return read_header(read_bytes(file, preamble_size + size + digest_size));
  } catch (const BadBytes& bad) {
    refuse(file, bad.what());
  }
}

void merge_run_state(const std::filesystem::path& file, std::span<SummingObserver* const> observers) {
  try {
    merge_state(read_bytes(file, size_of(file)), observers);
  } catch (const BadBytes& bad) {
    refuse(file, bad.what());
  }
}

}  // namespace talus
