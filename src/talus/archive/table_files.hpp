#pragma once
// The files of the tables while a campaign writes them: begun anew or gone on with, and marked for a checkpoint.

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/result_tables.hpp"
#include "talus/core/bytes.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/output_file.hpp"

namespace talus {

/// How much of a table belongs to a state: its first so many bytes, and what the last of them are, to notice another
/// file of the same name.
struct TableMark {
  std::string file_name;
  std::uint64_t bytes = 0;
  Digest tail;
  friend bool operator==(const TableMark&, const TableMark&) = default;

  void save(ByteWriter& out) const;
  [[nodiscard]] static TableMark read(ByteReader& in);
};

/// The mark of the first so many bytes of a file; throws BadInput where it cannot be read or is shorter.
[[nodiscard]] TableMark mark_of(const std::filesystem::path& file, std::string_view file_name, std::uint64_t bytes);

/// Where the table that a mark belongs to is: FOLDER/NAME.part, or FOLDER/NAME. Throws BadInput that says what is wrong
/// where there is none, or it is shorter than the mark or another one.
[[nodiscard]] std::filesystem::path find_marked(const std::filesystem::path& folder, const TableMark& mark);

inline constexpr std::size_t table_count = 3;

/// The tables of a run, always in the same order: who adds one adds it here.
[[nodiscard]] std::array<std::unique_ptr<TableObserver>, table_count> make_tables(
    const TableContext& context, const TableRocks& rocks, const std::array<TextSink*, table_count>& sinks);

/// The tables of one run folder as NAME.part, until they are finished.
class TableFiles {
 public:
  TableFiles(std::filesystem::path folder, const TableContext& context, const TableRocks& rocks);

  /// Makes new files; or goes on with those that were marked, cut to their marks. Throws BadInput.
  void begin();
  void go_on(std::span<const TableMark> marks);

  [[nodiscard]] std::vector<Observer*> observers() const;
  /// Rows of each table that were made elsewhere, in the order of the tables; they come after those before.
  void append(std::span<const std::string> texts);
  /// What they hold now, all of it on the disk; also once they are finished.
  [[nodiscard]] std::vector<TableMark> sync();
  /// From now on parts stay if they are not finished.
  void keep_parts();
  void finish();

 private:
  /// Passes text on to a file that is opened later than the table is made.
  struct Sink : TextSink {
    std::unique_ptr<OutputFile> file;
    void write(std::string_view text) override { file->write(text); }
  };
  struct Entry {
    std::unique_ptr<Sink> sink;
    std::unique_ptr<TableObserver> table;
  };

  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::optional<std::vector<TableMark>> finished_;
};

}  // namespace talus
