#pragma once
// Where the text of a table goes. Who makes the text need not be who keeps it.

#include <string_view>

namespace talus {

/// Takes a table's text in the order of its rows.
class TextSink {
 public:
  virtual ~TextSink() = default;
  virtual void write(std::string_view text) = 0;
};

}  // namespace talus
