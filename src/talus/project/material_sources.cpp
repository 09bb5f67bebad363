#include "talus/project/material_sources.hpp"

#include <algorithm>

#include "talus/project/echo.hpp"
#include "talus/project/material_library.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

std::vector<SourceOfValues> sources_of_values(const Project& project) {
  std::vector<SourceOfValues> sources;
  for (Material material : project.materials) {  // copies: slots are of rows that may be changed
    const LibraryMaterial* const entry = material.like.empty() ? nullptr : material_library().find(material.like);
    if (entry == nullptr) continue;
    Material theirs = entry->material;
    const std::size_t first = sources.size();
    for (const LibraryValue& value : entry->given) {
      const Setting& declared = setting("material", value.key);
      if (written(declared.slot(&material), false) != written(declared.slot(&theirs), false)) continue;
      const std::string& text = material_library().sources[value.source].text;
      auto known = std::find_if(sources.begin() + static_cast<std::ptrdiff_t>(first), sources.end(),
                                [&](const SourceOfValues& each) { return each.source == text; });
      if (known == sources.end()) known = sources.insert(known, {material.name, material.like, {}, text});
      known->keys.push_back(value.key);
    }
  }
  return sources;
}

}  // namespace talus::project
