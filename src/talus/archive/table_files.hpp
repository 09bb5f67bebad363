#pragma once
// The files of the tables during a campaign: created or resumed, and marked for checkpoints.

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/result_tables.hpp"
#include "talus/core/bytes.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/output_file.hpp"

namespace talus {

/// How much of a table belongs to a state: its first `bytes` bytes, and a checksum of the last of them to detect
/// another file of the same name.
struct TableMark {
  std::string file_name;
  std::uint64_t bytes = 0;
  Digest tail;
  friend bool operator==(const TableMark&, const TableMark&) = default;

  void save(ByteWriter& out) const;
  [[nodiscard]] static TableMark read(ByteReader& in);
};

/// The mark of the first `bytes` bytes of a file; throws BadInput if it cannot be read or is shorter.
[[nodiscard]] TableMark mark_of(const std::filesystem::path& file, std::string_view file_name, std::uint64_t bytes);

/// The file of a mark: FOLDER/NAME.part, or FOLDER/NAME. Throws BadInput if it is missing, shorter than the mark, or
/// another file.
[[nodiscard]] std::filesystem::path find_marked(const std::filesystem::path& folder, const TableMark& mark);

/// The tables of one run folder as NAME.part, until they are finished.
class TableFiles {
 public:
  TableFiles(std::filesystem::path folder, const TableContext& context, const TableRocks& rocks);

  /// Creates new files; or resumes the marked ones, truncated to their marks. Throws BadInput.
  void begin();
  void resume(std::span<const TableMark> marks);

  [[nodiscard]] std::vector<Observer*> observers() const;
  /// Appends rows of each table that another process made, in the order of the tables.
  void append(std::span<const std::string> texts);
  /// Syncs the tables to disk and returns their marks; also after they are finished.
  [[nodiscard]] std::vector<TableMark> sync();
  /// Keeps the parts even if they are not finished.
  void keep_parts();
  void finish();

 private:
  /// Passes text to a file that is opened after the table is made.
  struct Sink : TextSink {
    std::unique_ptr<OutputFile> file;
    void write(std::string_view text) override { file->write(text); }
  };
  struct Entry {
    const ResultTable* table;
    std::string header;
    std::unique_ptr<Sink> sink;
    std::unique_ptr<Observer> observer;
  };

  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::optional<std::vector<TableMark>> finished_;
};

}  // namespace talus
