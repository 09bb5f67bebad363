#pragma once
// Names of layers and attributes, for messages.

#include <string>
#include <vector>

namespace talus {

/// For example `"rock", "scree" and 7 more`.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);
/// `Did you mean "rock"?`; empty if none of the names is similar.
[[nodiscard]] std::string meant(const std::string& name, const std::vector<std::string>& names);

}  // namespace talus
