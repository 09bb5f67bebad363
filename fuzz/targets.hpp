#pragma once
// Where bytes from outside come in, each as a function of bytes: what libFuzzer calls (main.cpp), and what the ordinary
// tests feed with the kept corpus (test/fuzz/corpus_test.cpp).

#include <array>
#include <filesystem>
#include <string_view>

namespace talus::fuzz {

/// What a reader makes of an input. Anything else that it throws, or does, is a defect.
enum class Verdict { read, refused };

/// Reads an input, and does with it what a run would do first. Files are made in `folder`, and none is opened outside.
using Read = Verdict (*)(std::string_view input, const std::filesystem::path& folder);

/// A project's text, up to the first NUL; what follows, between NULs, are settings as with --set. A project that needs
/// no file is built, if its terrain is small.
Verdict read_project(std::string_view input, const std::filesystem::path& folder);

/// The first byte chooses OBJ, STL or PLY, the others are the file. A small mesh is cleaned.
Verdict read_mesh(std::string_view input, const std::filesystem::path& folder);

/// The first byte chooses text or LAS, the others are the file. From few points a surface is made.
Verdict read_points(std::string_view input, const std::filesystem::path& folder);

/// The first byte chooses whole or real numbers, the others are a grid of text, held against its header.
Verdict read_grid(std::string_view input, const std::filesystem::path& folder);

/// The first byte chooses which file of a run's folder the others are: summary.json or one of the tables; they are
/// read for the report and, of paths, for drawing.
Verdict read_results(std::string_view input, const std::filesystem::path& folder);

/// A state of a run, without its checksums, which no mutation would hit: four bytes of the header's length, the header,
/// what the observers saved.
Verdict read_state(std::string_view input, const std::filesystem::path& folder);

struct Target {
  std::string_view name;  // also of the folder of its corpus
  Read read;
};

inline constexpr std::array<Target, 6> targets{{{"project", &read_project},
                                                {"mesh", &read_mesh},
                                                {"points", &read_points},
                                                {"grid", &read_grid},
                                                {"results", &read_results},
                                                {"state", &read_state}}};

}  // namespace talus::fuzz
