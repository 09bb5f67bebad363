#include "targets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "talus/archive/path_arcs.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/run_state.hpp"
#include "talus/calibration/study.hpp"
#include "talus/core/bytes.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/picture_file.hpp"
#include "talus/gdal/ascii_grid_check.hpp"
#include "talus/import/las_file.hpp"
#include "talus/import/mesh_formats.hpp"
#include "talus/import/point_file.hpp"
#include "talus/import/survey_crs.hpp"
#include "talus/layers/layer_shapes.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/survey_surface.hpp"
#include "talus/model/model.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/factor_set.hpp"
#include "talus/project/read.hpp"
#include "talus/report/report.hpp"
#include "talus/run/run_results.hpp"
#include "talus/sensitivity/study.hpp"
#include "talus/store/store_file.hpp"
#include "talus/store/trajectory_store.hpp"

namespace talus::fuzz {

namespace {

namespace fs = std::filesystem;

// Limits that keep the work for an input small, so that many are tried per second.
constexpr std::size_t most_parts = 2000;

/// A reader may refuse its input; all other exceptions are passed on.
template <class Work>
Verdict verdict_of(Work&& work) {
  try {
    work();
    return Verdict::read;
  } catch (const BadInput& bad) {
    if (bad.problems().text().empty()) throw std::logic_error("a refusal says something");
    return Verdict::refused;
  } catch (const BadBytes&) {
    return Verdict::refused;
  }
}

/// Removes the first byte of an input and returns it.
std::size_t take_choice(std::string_view& input) {
  const std::size_t choice = input.empty() ? 0 : static_cast<unsigned char>(input.front());
  input.remove_prefix(std::min<std::size_t>(1, input.size()));
  return choice;
}

fs::path written(const fs::path& file, std::string_view bytes) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
  return file;
}

// ---- projects ----

/// Whether a project would open files, which other targets cover.
bool needs_files(const project::Project& project) { return !project.named_files.empty(); }

bool is_small(const project::Project& project) {
  const auto& terrain = project.terrain;
  std::size_t parts =
      terrain.section.vertices.size() + terrain.inline_mesh.vertices.size() + terrain.inline_mesh.triangles.size();
  for (const auto& line : terrain.polygons.polylines) parts += line.size();
  const bool has_cells = std::ranges::any_of(
      project.seeders, [](const project::Seeder& seeder) { return seeder.in_cells.cell_m.has_value(); });
  return parts <= most_parts && !has_cells;
}

}  // namespace

Verdict read_project(std::string_view input, const fs::path& folder) {
  project::Overrides overrides;
  std::string_view text = input.substr(0, input.find('\0'));
  for (std::string_view rest = input.substr(text.size()); rest.size() > 1;) {
    rest.remove_prefix(1);
    overrides.settings.emplace_back(rest.substr(0, rest.find('\0')));
    rest.remove_prefix(overrides.settings.back().size());
  }
  return verdict_of([&] {
    // The project file does not exist, so that no path in it is accessed.
    const project::Reading reading = project::read_project_text(text, folder / "not-there.toml", overrides);
    (void)project::echo(reading.project).dump();
    if (needs_files(reading.project) || !is_small(reading.project)) return;
    Problems warnings;
    const Model model = project::build_model(reading.project, warnings);
    (void)warnings.text();
  });
}

Verdict read_mesh(std::string_view input, const fs::path&) {
  const std::size_t format = take_choice(input) % 3;
  return verdict_of([&] {
    MeshProblems problems("mesh");
    RawMesh mesh = format == 0   ? read_obj(input, problems)
                   : format == 1 ? read_stl(input, problems)
                                 : read_ply(input, problems);
    problems.throw_if_any();
    if (mesh.triangles.size() <= most_parts) (void)clean(std::move(mesh), {.source = "mesh"});
  });
}

Verdict read_factors(std::string_view input, const fs::path&) {
  return verdict_of([&] { (void)project::factor_table(project::read_factor_set({input, "factors.toml"})); });
}

Verdict read_grid(std::string_view input, const fs::path& folder) {
  const GridNumbers numbers = take_choice(input) % 2 == 1 ? GridNumbers::whole : GridNumbers::real;
  return verdict_of([&] {
    const fs::path file = written(folder / "dem.asc", input);
    (void)is_ascii_grid(file);
    check_ascii_grid(file, numbers);
  });
}

Verdict read_points(std::string_view input, const fs::path& folder) {
  const bool is_las = take_choice(input) % 2 == 1;
  return verdict_of([&] {
    Survey survey;
    if (is_las) {
      const fs::path file = written(folder / "points.las", input);
      LasFile las = read_las_file(file, {});
      Problems warnings;
      (void)crs_of_las(las.crs, file, {}, warnings);
      survey.points = std::move(las.points);
    } else {
      survey.points = read_point_file(written(folder / "points.csv", input));
    }
    if (survey.points.size() <= most_parts) (void)surface_of(survey, {.source = "points"});
  });
}

Verdict read_table(std::string_view input, const fs::path& folder) {
  constexpr std::string_view start = R"(
[terrain]
vertices = [[0, 0, 10], [1000, 0, 0], [1000, 1000, 0], [0, 1000, 10]]
triangles = [[0, 1, 2], [0, 2, 3]]
[[material]]
name = "Rock"
[[seeder]]
)";
  written(folder / "table.csv", input);
  return verdict_of([&] {
    const std::string text = std::string(start) + "type = \"table\"\ntable = \"table.csv\"\nmass_kg = 1\n";
    Problems warnings;
    (void)project::build_model(project::read_project_text(text, folder / "not-there.toml").project, warnings);
    (void)warnings.text();
  });
}

Verdict read_section(std::string_view input, const fs::path& folder) {
  constexpr std::string_view rest = R"(
[[material]]
name = "Rock"
[[seeder]]
position = [0, "surface"]
mass_kg = 1
)";
  std::string text = "[terrain]\nsection = \"section.csv\"\n";
  if (take_choice(input) % 2 == 1) text += "section_tolerance_m = 0.5\n";
  text += rest;
  written(folder / "section.csv", input);
  return verdict_of([&] {
    Problems warnings;
    (void)project::build_model(project::read_project_text(text, folder / "not-there.toml").project, warnings);
    (void)warnings.text();
  });
}

Verdict read_study(std::string_view input, const fs::path& folder) {
  const bool is_sensitivity = take_choice(input) % 2 == 1;
  return verdict_of([&] {
    // The study file does not exist, and reading its text opens no other.
    const fs::path file = folder / "not-there.toml";
    if (is_sensitivity) {
      (void)sensitivity::read_study_text(input, file);
    } else {
      (void)calibration::read_study_text(input, file);
    }
  });
}

Verdict read_posterior(std::string_view input, const fs::path& folder) {
  constexpr std::string_view text = R"(
[sampling]
parameters = "posterior.csv"
ensembles = 20
[terrain]
section = [[0, 10], [10, 0], [20, 0]]
[[material]]
name = "Rock"
[[seeder]]
position = [1, "surface"]
rocks = 40
mass_kg = { mean = 100, distribution = "uniform", rel_min = 50, rel_max = 50 }
)";
  written(folder / "posterior.csv", input);
  return verdict_of([&] {
    Problems warnings;
    (void)project::build_model(project::read_project_text(text, folder / "not-there.toml").project, warnings);
    (void)warnings.text();
  });
}

Verdict read_layer(std::string_view input, const fs::path& folder) {
  const char* const ending = take_choice(input) % 2 == 1 ? "dxf" : "geojson";
  const fs::path file = written(folder / (std::string("layer.") + ending), input);
  return verdict_of([&] {
    Problems warnings;
    const TerrainOnPlan terrain{{{-100, -100}, {100, 100}}, ""};
    const LayerShapes layer =
        shapes_of_layer(file, {.layer = "", .name_attribute = "", .most_points = most_parts}, terrain, warnings);
    (void)layer.nearest({0, 0}, 10);
    (void)warnings.text();
  });
}

/// The other files of a folder with a hostile table.
constexpr std::string_view summary_of_no_rocks =
    R"({"talus": {"version": ""}, "name": "", "fingerprint": "", "seed": 0, "interrupted": false, "end_reasons": {},
        "rocks": {"planned": 0, "done": 0, "lifted": 0, "with_endpoint": 0, "with_path": 0}, "events": 0,
        "statistics": {}, "histograms": {}, "barriers": [], "sources": [], "warnings": [], "notes": [],
        "energy_datum_m": 0, "origin_m": [0, 0, 0], "terrain": {"kind": "section"}, "project": {},
        "timings": {"seconds": 0, "rocks_per_second": 0, "threads": 1}})";

Verdict read_results(std::string_view input, const fs::path& folder) {
  constexpr std::array names{"summary.json", "endpoints.csv", "paths.csv", "barriers.csv"};
  const std::size_t choice = take_choice(input) % names.size();
  for (const char* name : names) fs::remove(folder / name);
  written(folder / "summary.json", summary_of_no_rocks);
  const fs::path file = written(folder / names[choice], input);
  return verdict_of([&] {
    const RunFolder run = read_run_folder(folder, {.paths = 3, .path_rows = 100, .endpoints = 3, .hits = 3});
    if (choice == 2) {
      PathReader reader(file);
      while (reader.next([](std::uint64_t rock) { return rock % 2 == 0; })) {
        for_points_along(reader.path(), 0.1, [](const PathPoint&) {});
      }
    }
    if (choice == 0) (void)report_page({&run, 1});  // a megabyte, and of the tables it shows but numbers
  });
}

Verdict read_state(std::string_view input, const fs::path&) {
  std::uint32_t length = 0;
  if (input.size() < sizeof length) return Verdict::refused;
  std::memcpy(&length, input.data(), sizeof length);
  input.remove_prefix(sizeof length);
  const std::string_view header = input.substr(0, length);
  // The file that write_run_state() would write with these bytes.
  ByteWriter out;
  for (const char c : std::string_view("talus run state\n")) out.put(c);
  out.put(run_state_format);
  out.text(header);
  const auto put_digest = [&](std::string_view bytes) {
    const Digest digest = checksum_of(bytes);
    out.put(digest.high);
    out.put(digest.low);
  };
  put_digest(header);
  for (const char c : input.substr(header.size())) out.put(c);
  put_digest(out.bytes());
  return verdict_of([&] {
    const RunStateHeader state = read_header(out.bytes());
    project::RunSums sums(state.description);
    const auto observers = sums.observers();
    merge_state(out.bytes(), observers);
    ByteWriter again;
    for (SummingObserver* observer : observers) observer->save(again);
  });
}

Verdict read_picture(std::string_view input, const fs::path&) {
  return verdict_of([&] { (void)picture_in(input); });
}

namespace {

Verdict read_store_of(std::string_view input, const fs::path& folder) {
  std::uint32_t length = 0;
  if (input.size() < sizeof length) return Verdict::refused;
  std::memcpy(&length, input.data(), sizeof length);
  input.remove_prefix(sizeof length);
  const std::string_view head = input.substr(0, length);
  ByteWriter out;
  for (const char c : store_magic) out.put(c);
  out.put(store_format);
  out.put(static_cast<std::uint32_t>(checksum_of(head).low));
  out.text(head);
  for (const char c : input.substr(head.size())) out.put(c);
  const fs::path file = written(folder / trajectories_name, out.bytes());
  return verdict_of([&] {
    const TrajectoryStore store(file);
    (void)store.rocks_near({{-10, -10}, {10, 10}});
    const Vec2 line[] = {{0, 0}, {5, 1000}};
    (void)store.rocks_near(line, 1);
    if (store.rocks().empty()) return;
    const StoredTrajectory last = store.read(store.rocks().size() - 1);
    for (const PathRow& row : last.rows) {
      const double energy = last.record.body.mass * row.motion.velocity.squared_norm();
      if (!std::isfinite(energy)) throw std::logic_error("the energies of a trajectory are finite");
    }
  });
}

}  // namespace

Verdict read_store(std::string_view input, const fs::path& folder) {
  if (take_choice(input) % 2 == 0) return read_store_of(input, folder);
  return verdict_of([&] {
    StoredTrajectory trajectory;
    decode_path(input, Vec3(0, 0, -standard_gravity), trajectory);
  });
}

}  // namespace talus::fuzz
