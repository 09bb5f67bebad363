#include "results/one_rock.hpp"

#include <charconv>
#include <span>
#include <string>
#include <vector>

#include "talus/archive/path_energies.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/archive/result_tables.hpp"
#include "talus/archive/rock_rows.hpp"
#include "talus/archive/run_facts.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

Json by_column(std::span<const std::string_view> columns, const Texts& row) {
  Json json = Json::object();
  for (std::size_t k = 0; k < columns.size(); ++k) json[std::string(columns[k])] = row[k];
  return json;
}

/// The texts of a row as the tables have it (csv_text.hpp), line's end included.
Texts split(std::string_view row) {
  Texts texts(1);
  bool is_quoted = false;
  row.remove_suffix(1);
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] == '"') {
      if (!is_quoted && k > 0 && row[k - 1] == '"') texts.back() += '"';  // the second of two within quotes
      is_quoted = !is_quoted;
    } else if (row[k] == ',' && !is_quoted) {
      texts.emplace_back();
    } else {
      texts.back() += row[k];
    }
  }
  return texts;
}

/// What the tables say of a rock's end and of its path.
struct RockRows {
  std::vector<Texts> endpoint, path;
};

RockRows computed_again(const Model& model, std::uint64_t rock) {
  Simulator simulator(model);
  const RockRecord record = simulator.simulate(rock, true);
  const TableContext context = TableContext::of(model);
  std::string text;
  append_endpoint_row(text, context, record);
  RockRows rows{{split(text)}, {}};
  for (std::size_t k = 0; k < simulator.log().rows.size(); ++k) {
    text.clear();
    append_path_row(text, context, record, k, simulator.log().rows[k]);
    rows.path.push_back(split(text));
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

Json one_rock(const fs::path& folder, std::uint64_t rock, const io::RunFacts& facts,
              const std::function<std::shared_ptr<const BuiltProject>()>& model) {
  const std::string name = std::to_string(rock);
  RockRows rows{io::rows_of_rock(folder / "endpoints.csv", io::endpoint_columns, rock),
                io::rows_of_rock(folder / "paths.csv", io::path_columns, rock)};
  if (rows.endpoint.empty() && (rock >= facts.summary.rocks.done || facts.in_tables.has_endpoint(rock)))
    throw Refusal(404, name, "there is no such rock", "it was not run");
  const bool is_in_table = !rows.path.empty();
  if (!is_in_table) {
    const auto built = model();
    if (!built || rock >= built->model.rocks())
      throw Refusal(404, name, "the path of this rock is not known",
                    "paths.csv does not have it, and the files of the project have changed since");
    rows = computed_again(built->model, rock);
  }
  Json hits = Json::array();
  for (const Texts& row : io::rows_of_rock(folder / "barriers.csv", io::barrier_columns, rock))
    hits.push_back(by_column(io::barrier_columns, row));
  return {{"rock", rock},
          {"endpoint", by_column(io::endpoint_columns, rows.endpoint.front())},
          {"columns", io::path_columns},
          {"rows", rows.path},
          {"in_table", is_in_table},
          {"hits", std::move(hits)},
          {"energy", energies(rows.path)}};
}

}  // namespace talus::server
