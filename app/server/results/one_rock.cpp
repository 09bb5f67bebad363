#include "results/one_rock.hpp"

#include <charconv>
#include <span>
#include <string>
#include <vector>

#include "talus/campaign/simulate.hpp"
#include "talus/io/path_energies.hpp"
#include "talus/io/path_reader.hpp"
#include "talus/io/result_tables.hpp"
#include "talus/io/rock_rows.hpp"
#include "talus/io/run_folder.hpp"
#include "talus/io/table_columns.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

Json by_column(std::span<const std::string_view> columns, const Texts& row) {
  Json json = Json::object();
  for (std::size_t k = 0; k < columns.size(); ++k) json[std::string(columns[k])] = row[k];
  return json;
}

/// A row of text without names, in which nothing is quoted.
Texts split(std::string_view row) {
  Texts texts;
  for (std::size_t comma = row.find(','); comma != std::string_view::npos; comma = row.find(',')) {
    texts.emplace_back(row.substr(0, comma));
    row.remove_prefix(comma + 1);
  }
  texts.emplace_back(row);
  return texts;
}

std::vector<Texts> path_again(const Model& model, std::uint64_t rock) {
  Simulator simulator(model);
  const RockRecord record = simulator.simulate(rock, true);
  const TableContext context = TableContext::of(model);
  std::vector<Texts> rows;
  for (std::size_t k = 0; k < simulator.log().rows.size(); ++k) {
    std::string text;
    append_path_row(text, context, record, k, simulator.log().rows[k]);
    text.pop_back();  // the line's end
    rows.push_back(split(text));
  }
  return rows;
}

Json energies(const std::vector<Texts>& rows) {
  constexpr double tolerance = 0.05;  // of the arcs [m]
  Json json = Json::array();
  for (const io::PathEnergies& at : io::energies_along(io::path_of(rows), tolerance))
    json.push_back({at.time_s, at.ke_translational_J, at.ke_rotational_J, at.pe_J});
  return json;
}

}  // namespace

Json one_rock(const fs::path& folder, std::uint64_t rock,
              const std::function<std::shared_ptr<const BuiltProject>()>& model) {
  const std::string name = std::to_string(rock);
  const auto endpoint = io::rows_of_rock(folder / "endpoints.csv", io::endpoint_columns, rock);
  if (endpoint.empty()) throw Refusal(404, name, "there is no such rock", "it was not thrown");
  auto rows = io::rows_of_rock(folder / "paths.csv", io::path_columns, rock);
  const bool is_in_table = !rows.empty();
  if (!is_in_table) {
    const auto built = model();
    if (!built || rock >= built->model.rocks())
      throw Refusal(404, name, "the path of this rock is not known",
                    "paths.csv does not have it, and the files of the project have changed since");
    rows = path_again(built->model, rock);
  }
  Json hits = Json::array();
  for (const Texts& row : io::rows_of_rock(folder / "barriers.csv", io::barrier_columns, rock))
    hits.push_back(by_column(io::barrier_columns, row));
  return {{"rock", rock},
          {"endpoint", by_column(io::endpoint_columns, endpoint.front())},
          {"columns", io::path_columns},
          {"rows", rows},
          {"in_table", is_in_table},
          {"hits", std::move(hits)},
          {"energy", energies(rows)}};
}

}  // namespace talus::server
