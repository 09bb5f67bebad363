#pragma once
// The commands of the program, one a file. Each returns the exit code and throws BadInput for bad input.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace talus::cli {

enum ExitCode { done = 0, check_failed = 1, bad_input = 2, stopped = 3, internal_error = 4 };

struct ExitMeaning {
  ExitCode code;
  const char* meaning;
};
inline constexpr std::array exit_meanings{
    ExitMeaning{done, "done"}, ExitMeaning{check_failed, "a check failed"}, ExitMeaning{bad_input, "bad input"},
    ExitMeaning{stopped, "stopped by a signal (results so far kept)"}, ExitMeaning{internal_error, "internal error"}};

/// Options that override settings of a project file.
struct ProjectOptions {
  std::filesystem::path file;
  std::vector<std::string> settings;
  std::optional<std::int64_t> rocks;
  std::optional<std::uint64_t> seed;
};

struct RunOptions {
  ProjectOptions project;
  std::filesystem::path folder;  // empty: named after the project, next to its file
  int threads = 0;
  bool quiet = false;
  std::string shard;  // "2/7"; empty: the whole campaign
  bool resume = false;
  double checkpoint_every = 20;   // [s]; 0: never
  bool alone = false;             // even if a launcher started several processes
  std::uint64_t maps_memory = 0;  // [bytes]; 0: half of the available memory
};
int run(const RunOptions& options);

struct ServeOptions {
  std::filesystem::path project;  // or a folder; empty: the current folder
  int port = 8425;
  bool open = false;
};
int serve(const ServeOptions& options);

struct MergeOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path folder;  // empty: the only input folder, or the project's name
  bool partial = false;
  int threads = 0;
  std::uint64_t maps_memory = 0;  // as in RunOptions
  bool quiet = false;
};
int merge(const MergeOptions& options);

struct CalibrateOptions {
  std::filesystem::path study;
  std::filesystem::path folder;  // empty: named after the study, next to its file
  int threads = 0;
  bool quiet = false;
};
int calibrate(const CalibrateOptions& options);

int check(const ProjectOptions& options);

struct ReplayOptions {
  ProjectOptions project;
  std::uint64_t rock = 0;
  bool csv = false;
};
int replay(const ReplayOptions& options);

/// A question to a finished run; one of line, barrier, polygon and ditch.
struct LineOptions {
  std::filesystem::path folder;               // of the run
  std::string line, polygon;                  // "x,y x,y ...", or a file
  std::string barrier;                        // of the run
  std::vector<double> ditch;                  // its toe and far edge
  std::optional<double> height_m, energy_kJ;  // of a kit to judge; both or neither
  std::optional<double> section_m;
  std::vector<std::string> design;  // KEY=VALUE of [design]
  std::filesystem::path files;      // folder of the project's files; empty: the one that `folder` is in
  std::filesystem::path json;       // empty: none
  bool csv = false;
};
int line(const LineOptions& options);

/// A question to a project and its variations; one of line, barrier and polygon.
struct WhatIfOptions {
  ProjectOptions project;
  std::string line, polygon, barrier;  // as in LineOptions
  std::vector<std::string> steps;      // FACTOR=PERCENT; empty: the usual ones
  std::string material;                // alone; empty: all
  std::optional<double> within_s;      // time for the runs
  std::filesystem::path folder;        // for tables; empty: none
  int threads = 0;
  bool quiet = false;
};
int what_if(const WhatIfOptions& options);

struct SectionOptions {
  std::filesystem::path terrain;  // a project, a raster or a mesh
  std::string line;               // as in LineOptions
  std::string crs;                // of a raster or mesh that names none; empty: that of the file
  double tolerance_m = 0;
  std::filesystem::path file;  // empty: standard output
};
int section(const SectionOptions& options);

struct ReportOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path file;         // empty: report.html in the first folder, or compare.html for several
  std::filesystem::path observed;     // stops to compare with; empty: none
  std::filesystem::path pdf;          // to print to, instead of a page; empty: none
  std::string paper;                  // "A4" or "A3"; empty: the project's
  std::string units;                  // "metric" or "us"; empty: the project's
  std::vector<std::string> settings;  // of [report], which override the project's
};
int report(const ReportOptions& options);

struct ExportOptions {
  std::filesystem::path folder;  // of a run
  std::string paths;             // "all" or a number of rocks
  std::filesystem::path file;    // empty: standard output
};
int export_paths(const ExportOptions& options);

struct SensitivityOptions {
  std::filesystem::path study;
  std::filesystem::path folder;  // empty: named after the study, next to its file
  int threads = 0;
  bool quiet = false;
};
int sensitivity(const SensitivityOptions& options);

struct VerifyOptions {
  std::vector<std::string> cases;  // empty: all
  std::filesystem::path json;      // empty: none
  std::filesystem::path page;      // empty: none
  std::filesystem::path folder;    // of the cases; empty: those built into the program
};
int verify(const VerifyOptions& options);

struct ValidateOptions {
  std::vector<std::string> experiments;  // names or folders; empty: all that are built in
  std::filesystem::path folder;          // empty: out/validation
  int threads = 0;
  bool quiet = false;
  std::optional<std::int64_t> rocks, draws;  // instead of the studies' own
};
int validate(const ValidateOptions& options);

int schema();

int materials();

struct NewOptions {
  std::filesystem::path file;
  bool force = false;
};
int start_project(const NewOptions& options);

/// Prints the manual page of the commands that `app` declares.
int manual(const CLI::App& app);

/// Prints a script with which a shell (bash, zsh or fish) completes the commands that `app` declares.
int completion(const CLI::App& app, const std::string& shell);

}  // namespace talus::cli
