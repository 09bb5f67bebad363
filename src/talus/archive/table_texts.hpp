#pragma once
// The tables of a run as text that another process writes.

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "talus/archive/result_tables.hpp"

namespace talus {

/// Collects the rows of the tables, in the order of `tables_with`.
class TableTexts {
 public:
  TableTexts(const TableContext& context, const TableRocks& rocks) {
    const std::vector<const ResultTable*> tables = tables_with(rocks);
    sinks_.resize(tables.size());
    for (std::size_t k = 0; k < sinks_.size(); ++k) observers_.push_back(tables[k]->make(context, rocks, sinks_[k]));
  }
  TableTexts(const TableTexts&) = delete;
  TableTexts& operator=(const TableTexts&) = delete;

  [[nodiscard]] std::vector<Observer*> observers() const {
    std::vector<Observer*> list;
    for (const auto& observer : observers_) list.push_back(observer.get());
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

  std::vector<Sink> sinks_;  // by table, as are the observers
  std::vector<std::unique_ptr<Observer>> observers_;
};

}  // namespace talus
