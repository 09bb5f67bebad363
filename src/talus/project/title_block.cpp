#include "talus/project/title_block.hpp"

#include <fmt/format.h>

#include "talus/core/bytes.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/picture_file.hpp"
#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read_table.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

TitleBlockSettings title_block_settings(const std::vector<std::string>& overrides) {
  Problems problems;
  Document document("", "");
  for (const std::string& each : overrides) document.set(each, problems);
  for (const auto& [key, node] : document.root()) {
    if (key == "report") continue;
    Problem problem = document.at(node);
    problem.what = fmt::format("{} cannot be set here", std::string_view(key));
    problem.why = "a report is made of finished results; only settings of [report] can be given";
    problem.hint = "Run the project again with this setting";
    problems.add(std::move(problem));
  }
  const Table& declared = table("report");
  TitleBlock block;
  ValueReader reader(document, problems);
  read_table(
      declared, document, reader, [&](int) { return Row(&block); }, "a project", problems);

  TitleBlockSettings settings;
  const toml::table* const row = document.root()["report"].as_table();
  for (const Setting& setting : declared.settings) {
    const toml::node* const node = row != nullptr ? row->get(setting.key) : nullptr;
    if (node == nullptr || reader.refused().contains(node)) continue;
    if (auto value = written(setting.slot(&block), false)) settings.given[std::string(setting.key)] = std::move(*value);
    if (setting.key != "logo") continue;
    try {
      settings.logo = data_address_of_picture(block.logo);
    } catch (const BadBytes& bad) {
      Problem problem = document.at(*node);
      problem.where = declared.heading();
      problem.what = fmt::format("logo is {}", quoted(*node));
      problem.why = bad.what();
      problem.hint = "Name a PNG or JPEG picture; the path is relative to the current folder";
      problems.add(std::move(problem));
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  return settings;
}

}  // namespace talus::project
