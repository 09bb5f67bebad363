#include "talus/archive/table_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "talus/core/problems.hpp"

namespace talus {

namespace {

constexpr std::uint64_t tail_bytes = 1U << 16;

[[noreturn]] void refuse(const std::filesystem::path& file, std::string what, std::string why) {
  throw BadInput(Problem{.file = file.string(),
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = "It was changed or removed; run these rocks again"});
}

}  // namespace

void TableMark::save(ByteWriter& out) const {
  out.text(file_name);
  out.put(bytes);
  out.put(tail.high);
  out.put(tail.low);
}

TableMark TableMark::read(ByteReader& in) {
  TableMark mark;
  mark.file_name = in.text();
  const bool is_name = !mark.file_name.empty() && mark.file_name.front() != '.' &&
                       std::filesystem::path(mark.file_name).filename() == mark.file_name;
  expect_bytes(is_name, "a table has no valid file name");
  mark.bytes = in.get<std::uint64_t>();
  mark.tail.high = in.get<std::uint64_t>();
  mark.tail.low = in.get<std::uint64_t>();
  return mark;
}

TableMark mark_of(const std::filesystem::path& file, std::string_view file_name, std::uint64_t bytes) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) refuse(file, "this table is missing", error.message());
  if (size < bytes) {
    refuse(file, "this table is too short", fmt::format("it has {} bytes, expected at least {}", size, bytes));
  }
  const std::uint64_t length = std::min(bytes, tail_bytes);
  std::string tail(length, '\0');
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(bytes - length));
  in.read(tail.data(), static_cast<std::streamsize>(length));
  if (!in) refuse(file, "this table cannot be read", "reading it failed");
  return {std::string(file_name), bytes, checksum_of(tail)};
}

std::filesystem::path find_marked(const std::filesystem::path& folder, const TableMark& mark) {
  const std::filesystem::path whole = folder / mark.file_name;
  std::error_code ignored;
  const std::filesystem::path part = OutputFile::part_of(whole);
  const std::filesystem::path& file = std::filesystem::exists(part, ignored) ? part : whole;
  if (mark_of(file, mark.file_name, mark.bytes) != mark) {
    refuse(file, "this table is not the one that the state was saved with", "its rows up to the saved place differ");
  }
  return file;
}

TableFiles::TableFiles(std::filesystem::path folder, const TableContext& context, const TableRocks& rocks)
    : folder_(std::move(folder)) {
  for (const ResultTable* table : tables_with(rocks)) {
    auto sink = std::make_unique<Sink>();
    auto observer = table->make(context, rocks, *sink);
    entries_.push_back({table, table->header(context), std::move(sink), std::move(observer)});
  }
}

void TableFiles::begin() {
  for (Entry& entry : entries_) {
    entry.sink->file = std::make_unique<OutputFile>(folder_ / entry.table->file_name);
    entry.sink->write(entry.header);
  }
}

void TableFiles::resume(std::span<const TableMark> marks) {
  for (Entry& entry : entries_) {
    const auto mark = std::ranges::find(marks, entry.table->file_name, &TableMark::file_name);
    if (mark == marks.end()) refuse(folder_ / entry.table->file_name, "the state has no mark of this table", "");
    (void)find_marked(folder_, *mark);
  }
  for (Entry& entry : entries_) {
    const auto mark = std::ranges::find(marks, entry.table->file_name, &TableMark::file_name);
    entry.sink->file = std::make_unique<OutputFile>(folder_ / entry.table->file_name, mark->bytes);
  }
}

std::vector<Observer*> TableFiles::observers() const {
  std::vector<Observer*> list;
  for (const Entry& entry : entries_) list.push_back(entry.observer.get());
  return list;
}

void TableFiles::append(std::span<const std::string> texts) {
  expect_bytes(texts.size() == entries_.size(), "the rows are of other tables");
  for (std::size_t k = 0; k < texts.size(); ++k) entries_[k].sink->write(texts[k]);
}

std::vector<TableMark> TableFiles::sync() {
  if (finished_) return *finished_;
  std::vector<TableMark> marks;
  for (const Entry& entry : entries_) {
    OutputFile& file = *entry.sink->file;
    file.sync();
    const std::string_view name = entry.table->file_name;
    marks.push_back(mark_of(OutputFile::part_of(folder_ / name), name, file.position()));
  }
  return marks;
}

void TableFiles::keep_parts() {
  if (finished_) return;
  for (const Entry& entry : entries_) entry.sink->file->keep_part();
}

void TableFiles::finish() {
  finished_ = sync();
  for (const Entry& entry : entries_) entry.sink->file->commit();
}

}  // namespace talus
