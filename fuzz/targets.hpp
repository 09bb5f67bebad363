#pragma once
// The readers of bytes from outside, each as a function of bytes: called by libFuzzer (main.cpp), and by the ordinary
// tests with the stored corpus (test/fuzz/corpus_test.cpp).

#include <array>
#include <filesystem>
#include <string_view>

namespace talus::fuzz {

/// The outcome of reading an input. Any other exception or behaviour is a defect.
enum class Verdict { read, refused };

/// Reads an input and processes it as the start of a run would. Files are created in `folder`; none outside is opened.
using Read = Verdict (*)(std::string_view input, const std::filesystem::path& folder);

/// A project's text up to the first NUL, then settings as for --set, separated by NULs. If the project needs no files
/// and its terrain is small, its model is built.
Verdict read_project(std::string_view input, const std::filesystem::path& folder);

/// A set of factors for the check of a barrier.
Verdict read_factors(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects OBJ, STL or PLY, the others are the file. A small mesh is cleaned.
Verdict read_mesh(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects text or LAS, the others are the file. Few points are made into a surface.
Verdict read_points(std::string_view input, const std::filesystem::path& folder);

/// A table of releases, from which a model is built.
Verdict read_table(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects whether the section is simplified, the others are a table of its points, from which a model
/// is built.
Verdict read_section(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects a calibration or a sensitivity study, the others are its file.
Verdict read_study(std::string_view input, const std::filesystem::path& folder);

/// A sample of parameters, such as the posterior of a calibration, with which a model is built.
Verdict read_posterior(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects GeoJSON or DXF, the others are a reference layer, which is drawn over a terrain.
Verdict read_layer(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects integers or real numbers, the others are an ASCII grid, which is checked.
Verdict read_grid(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects the file of a run's folder that the others are: summary.json or a table. It is read for the
/// report and, if it has paths, for drawing.
Verdict read_results(std::string_view input, const std::filesystem::path& folder);

/// A state of a run without its checksums, which no mutation would match: four bytes for the header's length, the
/// header, and the observers' sums.
Verdict read_state(std::string_view input, const std::filesystem::path& folder);

/// A picture for a page.
Verdict read_picture(std::string_view input, const std::filesystem::path& folder);

/// The first byte selects the head of a store of trajectories, after four bytes for its length and followed by the
/// paths; or the path of one rock. Checksums are left out: no mutation would match them.
Verdict read_store(std::string_view input, const std::filesystem::path& folder);

struct Target {
  std::string_view name;  // also that of its corpus folder
  Read read;
};

inline constexpr std::array<Target, 14> targets{{{"project", &read_project},
                                                 {"factors", &read_factors},
                                                 {"mesh", &read_mesh},
                                                 {"points", &read_points},
                                                 {"grid", &read_grid},
                                                 {"table", &read_table},
                                                 {"section", &read_section},
                                                 {"study", &read_study},
                                                 {"posterior", &read_posterior},
                                                 {"layer", &read_layer},
                                                 {"results", &read_results},
                                                 {"state", &read_state},
                                                 {"picture", &read_picture},
                                                 {"store", &read_store}}};

}  // namespace talus::fuzz
