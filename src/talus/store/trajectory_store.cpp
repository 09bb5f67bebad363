#include "talus/store/trajectory_store.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/store/store_file.hpp"

namespace talus {

namespace {

constexpr std::size_t preamble_size = store_magic.size() + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);

[[noreturn]] void refuse(const std::filesystem::path& file, std::string why) {
  throw BadInput(Problem{.file = file.string(),
                         .what = "cannot use this store of trajectories",
                         .why = std::move(why),
                         .hint = "Run the project again to write it anew"});
}

std::string reason_of(int error) { return std::generic_category().message(error); }

}  // namespace

/// An open file of a fixed size, read at any place by any thread.
class TrajectoryStore::ReadFile {
 public:
  explicit ReadFile(const std::filesystem::path& file) : file_(file) {
    if (const auto why = not_an_ordinary_file(file)) refuse(file, *why);
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) refuse(file, reason_of(errno));
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) refuse(file, reason_of(errno));
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
  ~ReadFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  ReadFile(const ReadFile&) = delete;
  ReadFile& operator=(const ReadFile&) = delete;

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return file_; }
  void read(std::uint64_t begin, std::size_t size, std::string& bytes) const {
    bytes.resize(size);
    for (std::size_t have = 0; have < size;) {
      const ssize_t got = ::pread(descriptor_, bytes.data() + have, size - have, static_cast<off_t>(begin + have));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) refuse(file_, reason_of(errno));
      if (got == 0) refuse(file_, "it was cut short");
      have += static_cast<std::size_t>(got);
    }
  }

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

namespace {

/// As many numbers as there are rocks.
template <class Number>
std::vector<Number> read_numbers(ByteReader& in, std::size_t count) {
  expect_bytes(count <= in.left() / sizeof(Number), "its head is too short");
  std::vector<Number> numbers(count);
  in.numbers(std::span(numbers));
  return numbers;
}

}  // namespace

struct TrajectoryStore::Content {
  explicit Content(const std::filesystem::path& path) : file(path) {}

  void read_head() {
    std::string bytes;
    const std::size_t known = std::min<std::uint64_t>(file.size(), preamble_size);
    file.read(0, known, bytes);
    const std::string_view begin = std::string_view(bytes).substr(0, store_magic.size());
    expect_bytes(!begin.empty(), "it is empty");
    expect_bytes(begin == store_magic.substr(0, begin.size()), "it is not a store of trajectories");
    expect_bytes(bytes.size() == preamble_size, "it was cut short");
    ByteReader preamble(std::string_view(bytes).substr(store_magic.size()));
    const auto format = preamble.get<std::uint32_t>();
    expect_bytes(format > 0 && format <= store_format, "another version of talus wrote it");
    const auto checksum = preamble.get<std::uint32_t>();
    const auto size = preamble.get<std::uint64_t>();
    expect_bytes(size <= file.size() - preamble_size, "it was cut short");
    file.read(preamble_size, size, bytes);
    expect_bytes(static_cast<std::uint32_t>(checksum_of(bytes).low) == checksum, "its head was changed or damaged");
    paths_begin = preamble_size + size;
    read_head(ByteReader(bytes));
  }

  void read_head(ByteReader in) {
    (void)in.text();  // the version of the program
    facts = StoreFacts::read(in);
    done = in.get<std::uint64_t>();
    row_count = in.get<std::uint64_t>();
    largest_radius = in.get<double>();
    expect_bytes(std::isfinite(largest_radius) && largest_radius >= 0, "its largest rock has no valid size");
    rocks = in.list<std::uint64_t>();
    const bool are_in_order = std::ranges::adjacent_find(rocks, std::ranges::greater_equal()) == rocks.end();
    expect_bytes(are_in_order && (rocks.empty() || rocks.back() < facts.planned) && rocks.size() <= done &&
                     done <= facts.planned,
                 "its rocks are not in order");
    path_ends = read_numbers<std::uint64_t>(in, rocks.size());
    expect_bytes(std::ranges::is_sorted(path_ends), "its index is not valid");
    const std::uint64_t end = path_ends.empty() ? 0 : path_ends.back(), is = file.size() - paths_begin;
    expect_bytes(end <= is, "it was cut short");
    expect_bytes(end == is, "there are unexpected data at the end");
    checksums = read_numbers<std::uint32_t>(in, rocks.size());
    cells = in.text();
    in.expect_end();
  }

  ReadFile file;
  StoreFacts facts;
  std::uint64_t done = 0, row_count = 0, paths_begin = 0;
  double largest_radius = 0;
  std::vector<std::uint64_t> rocks, path_ends;
  std::vector<std::uint32_t> checksums;
  std::string cells;  // of the rocks, as runs
};

TrajectoryStore::TrajectoryStore(const std::filesystem::path& file) {
  auto content = std::make_unique<Content>(file);
  try {
    content->read_head();
  } catch (const BadBytes& bad) {
    refuse(file, bad.what());
  }
  content_ = std::move(content);
}
TrajectoryStore::~TrajectoryStore() = default;
TrajectoryStore::TrajectoryStore(TrajectoryStore&&) noexcept = default;

const StoreFacts& TrajectoryStore::facts() const { return content_->facts; }
std::uint64_t TrajectoryStore::rocks_done() const { return content_->done; }
std::uint64_t TrajectoryStore::row_count() const { return content_->row_count; }
double TrajectoryStore::largest_radius() const { return content_->largest_radius; }
std::span<const std::uint64_t> TrajectoryStore::rocks() const { return content_->rocks; }

std::optional<std::size_t> TrajectoryStore::find(std::uint64_t rock) const {
  const auto found = std::ranges::lower_bound(content_->rocks, rock);
  if (found == content_->rocks.end() || *found != rock) return std::nullopt;
  return static_cast<std::size_t>(found - content_->rocks.begin());
}

std::vector<std::size_t> TrajectoryStore::rocks_in(const CellSet& cells) const {
  std::vector<std::size_t> places;
  try {
    ByteReader in(content_->cells);
    for (std::size_t place = 0; place < rocks().size(); ++place) {
      bool is_near = false;
      read_runs(in, facts().grid.count(),
                [&](std::uint32_t first, std::uint32_t last) { is_near = is_near || cells.has_any(first, last); });
      if (is_near) places.push_back(place);
    }
    in.expect_end();
  } catch (const BadBytes& bad) {
    refuse(content_->file.path(), bad.what());
  }
  return places;
}

std::vector<std::size_t> TrajectoryStore::rocks_near(const PlanBounds& box) const {
  CellSet cells(facts().grid.count());
  facts().grid.add_box(box, cells);
  return rocks_in(cells);
}

std::vector<std::size_t> TrajectoryStore::rocks_near(std::span<const Vec2> line, double reach) const {
  CellSet cells(facts().grid.count());
  for (std::size_t k = 0; k < line.size(); ++k) facts().grid.add_line(line[k > 0 ? k - 1 : 0], line[k], reach, cells);
  return rocks_in(cells);
}

StoredTrajectory TrajectoryStore::read(std::size_t place) const {
  StoredTrajectory trajectory;
  read(place, trajectory);
  return trajectory;
}

void TrajectoryStore::read(std::size_t place, StoredTrajectory& into) const {
  const Content& content = *content_;
  const std::uint64_t begin = place > 0 ? content.path_ends[place - 1] : 0;
  thread_local std::string bytes;
  content.file.read(content.paths_begin + begin, content.path_ends[place] - begin, bytes);
  try {
    expect_bytes(static_cast<std::uint32_t>(checksum_of(bytes).low) == content.checksums[place],
                 "a trajectory was changed or damaged");
    decode_path(bytes, content.facts.gravity, into);
    const RockRecord& record = into.record;
    expect_bytes(record.seeder.index < content.facts.seeders.size() &&
                     record.source.index < content.facts.sources.size() &&
                     (!record.outcome.ground || record.outcome.ground->index < content.facts.materials.size()),
                 "a rock has a name that it does not list");
  } catch (const BadBytes& bad) {
    refuse(content.file.path(), bad.what());
  }
  into.record.rock = content.rocks[place];
}

}  // namespace talus
