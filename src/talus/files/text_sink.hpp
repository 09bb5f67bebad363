#pragma once
// The destination of a table's text, which separates making the text from storing it.

#include <string_view>

namespace talus {

/// Receives a table's text in the order of its rows.
class TextSink {
 public:
  virtual ~TextSink() = default;
  virtual void write(std::string_view text) = 0;
};

}  // namespace talus
