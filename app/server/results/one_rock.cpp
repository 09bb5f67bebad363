#include "results/one_rock.hpp"

#include <string>
#include <vector>

#include "talus/archive/path_energies.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/archive/result_tables.hpp"
#include "talus/archive/rock_rows.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;
template <class Row>
Json by_column(const Row& row) {
  const std::vector<std::string> texts = texts_of(row);
  Json json = Json::object();
  for (std::size_t k = 0; k < texts.size(); ++k) json[std::string(column_names<Row>[k])] = texts[k];
  return json;
}

/// The rows of a rock in endpoints.csv and paths.csv.
struct RockRows {
  std::vector<EndpointRow> endpoint;
  Path path;
};

RockRows simulated_again(const Model& model, std::uint64_t rock) {
  Simulator simulator(model);
  const RockRecord record = simulator.simulate(rock, true);
  const TableContext context = TableContext::of(model);
  RockRows rows{std::vector<EndpointRow>(1), {rock}};
  fill(rows.endpoint.front(), context, record);
  for (std::size_t k = 0; k < simulator.log().rows.size(); ++k)
    fill(rows.path.rows.emplace_back(), context, record, k, simulator.log().rows[k]);
  return rows;
}

Json energies(const Path& path) {
  constexpr double tolerance = 0.05;  // of the arcs [m]
  Json json = Json::array();
  for (const PathEnergies& at : energies_along(path, tolerance))
    json.push_back({at.time_s, at.ke_translational_J, at.ke_rotational_J, at.pe_J});
  return json;
}

}  // namespace

Json one_rock(const fs::path& folder, std::uint64_t rock, const RunFacts& facts,
              const std::function<std::shared_ptr<const BuiltProject>()>& model) {
  const std::string name = std::to_string(rock);
  RockRows rows{rows_of_rock<EndpointRow>(folder, rock), {rock, rows_of_rock<PathEventRow>(folder, rock)}};
  if (rows.endpoint.empty() && (rock >= facts.summary.rocks.done || facts.in_tables.has_endpoint(rock)))
    throw Refusal(404, name, "there is no such rock", "it was not run");
  const bool is_in_table = !rows.path.rows.empty();
  if (!is_in_table) {
    const auto built = model();
    if (!built || rock >= built->model.rocks())
      throw Refusal(404, name, "the trajectory of this rock is not available",
                    "paths.csv does not have it, and the files of the project have changed since");
    rows = simulated_again(built->model, rock);
  }
  Json hits = Json::array(), path = Json::array();
  for (const HitRow& row : rows_of_rock<HitRow>(folder, rock)) hits.push_back(by_column(row));
  for (const PathEventRow& row : rows.path.rows) path.push_back(texts_of(row));
  std::vector<std::string_view> columns(column_names<PathEventRow>.begin(), column_names<PathEventRow>.end());
  if (!path.empty()) columns.resize(path.front().size());  // spheres have no orientation
  return {{"rock", rock},
          {"endpoint", by_column(rows.endpoint.front())},
          {"columns", std::move(columns)},
          {"rows", std::move(path)},
          {"in_table", is_in_table},
          {"hits", std::move(hits)},
          {"energy", energies(rows.path)}};
}

}  // namespace talus::server
