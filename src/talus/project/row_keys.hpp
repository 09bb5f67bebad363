#pragma once
// Checks the keys of one row of the project file: unknown keys, and keys that exclude each other.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

/// Whether the row has an unknown key that was probably meant to be `key`, which is then mistyped rather than missing.
[[nodiscard]] bool is_mistyped(const Table& table, const toml::table& row, std::string_view key);

/// "a, b and c", with `last` = " and ".
[[nodiscard]] std::string plain_list(std::span<const std::string_view> words, std::string_view last);

struct RowKeys {
  const Document& document;
  const Table& table;
  const toml::table& from;
  const std::string& where;  // names the row in messages
  Problems& problems;
  const std::vector<Table>& tables;  // of the file

  /// `lead` precedes the keys of a value that is a table: "normal_restitution ".
  void refuse_unknown(const std::string& lead) const;
  void refuse_exclusive() const;
};

}  // namespace talus::project
