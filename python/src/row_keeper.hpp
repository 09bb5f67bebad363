#pragma once
// Keeps the rows of a table in memory while rocks are simulated.

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "row_layout.hpp"
#include "talus/archive/rows_of_rock.hpp"

namespace talus::python {

/// The texts that a column may have, by its name: those of the model.
[[nodiscard]] inline std::size_t width_in(const TableContext& context, std::string_view column) {
  if (column == "seeder") return width_of(context.seeders);
  if (column == "barrier") return width_of(context.barriers);
  return width_of(context.materials);
}

/// Rows one after the other.
struct PackedRows {
  RowLayout layout;
  std::vector<std::byte> bytes;
  [[nodiscard]] std::size_t count() const { return layout.size > 0 ? bytes.size() / layout.size : 0; }
};

template <TableRow Row>
class RowKeeper : public Observer {
 public:
  RowKeeper(TableContext context, const TableRocks& rocks)
      : context_(std::move(context)), rocks_(rocks), rows_{layout_of<Row>([&](std::string_view column) {
          return width_in(context_, column);
        })} {
    if constexpr (std::is_same_v<Row, EndpointRow>) rows_.bytes.reserve(rocks.endpoints() * rows_.layout.size);
  }
  [[nodiscard]] bool wants_rows(std::uint64_t rock) const override { return RowsOfRock<Row>::need_path(rocks_, rock); }
  [[nodiscard]] bool wants_impacts(std::uint64_t rock) const override {
    return RowsOfRock<Row>::need_impacts(rocks_, rock);
  }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override { return std::make_unique<Part>(*this); }
  void commit(ObserverPart& part) override {
    const std::vector<std::byte>& seen = static_cast<Part&>(part).bytes;
    rows_.bytes.insert(rows_.bytes.end(), seen.begin(), seen.end());
  }

  [[nodiscard]] const PackedRows& rows() const { return rows_; }
  [[nodiscard]] bool is_wanted() const { return RowsOfRock<Row>::are_wanted(rocks_); }

  /// Calls take(text) with the table's rows as text, in pieces and in order; this many threads write them.
  template <class Take>
  void for_texts(int threads, Take&& take) const {
    constexpr std::size_t rows_in_piece = 4096;  // about a megabyte of text
    std::size_t next = 0;
    const auto first_of_piece = [&](tbb::flow_control& flow) {
      if (next >= rows_.count()) flow.stop();
      return std::exchange(next, next + rows_in_piece);
    };
    const auto text = [&](std::size_t first) { return text_of(first, std::min(first + rows_in_piece, rows_.count())); };
    using tbb::filter_mode;
    tbb::task_arena(threads).execute([&] {
      tbb::parallel_pipeline(static_cast<std::size_t>(2 * threads),
                             tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, first_of_piece) &
                                 tbb::make_filter<std::size_t, std::string>(filter_mode::parallel, text) &
                                 tbb::make_filter<std::string, void>(filter_mode::serial_in_order, take));
    });
  }

 private:
  struct Part : ObserverPart {
    explicit Part(const RowKeeper& k) : keeper(k) {}
    void see(const RockRecord& record, const RockLog& log) override {
      RowsOfRock<Row>::visit(keeper.rocks_, record, log, [&](const auto&... seen) {
        fill(row, keeper.context_, seen...);
        pack(row, keeper.rows_.layout, bytes);
      });
    }
    const RowKeeper& keeper;
    Row row;
    std::vector<std::byte> bytes;
  };

  [[nodiscard]] std::string text_of(std::size_t begin, std::size_t end) const {
    std::string text;
    CsvMemory memory;
    Row row;
    for (std::size_t k = begin; k < end; ++k) {
      unpack(rows_.bytes.data() + k * rows_.layout.size, rows_.layout, row);
      append_row(text, row, &memory, columns_in_run<Row>(context_.has_blocks));
    }
    return text;
  }

  TableContext context_;
  TableRocks rocks_;
  PackedRows rows_;
};

}  // namespace talus::python
