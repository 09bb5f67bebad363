#pragma once
// The tables of a run as text that another process writes.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "talus/archive/table_files.hpp"

namespace talus {

/// Collects the rows of the tables, in the order of `make_tables`.
class TableTexts {
 public:
  TableTexts(const TableContext& context, const TableRocks& rocks)
      : tables_(make_tables(context, rocks, {&sinks_[0], &sinks_[1], &sinks_[2]})) {}
  TableTexts(const TableTexts&) = delete;
  TableTexts& operator=(const TableTexts&) = delete;

  [[nodiscard]] std::vector<Observer*> observers() const {
    std::vector<Observer*> list;
    for (const auto& table : tables_) list.push_back(table.get());
    return list;
  }
  /// The rows of each table since the last call.
  [[nodiscard]] std::vector<std::string> take() {
    std::vector<std::string> texts;
    for (Sink& sink : sinks_) texts.push_back(std::exchange(sink.text, {}));
    return texts;
  }

 private:
  struct Sink : TextSink {
    std::string text;
    void write(std::string_view rows) override { text += rows; }
  };

  std::array<Sink, table_count> sinks_;
  std::array<std::unique_ptr<TableObserver>, table_count> tables_;
};

}  // namespace talus
