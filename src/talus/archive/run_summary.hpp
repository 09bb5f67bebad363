#pragma once
// summary.json as a struct: the inputs and results of a run. Each member is declared with its key. The writer
// (summary_json.hpp), the reader and the report follow from that.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "talus/archive/json_fields.hpp"
#include "talus/barriers/barrier.hpp"
#include "talus/core/problems.hpp"
#include "talus/seeding/release_order.hpp"

namespace talus {

/// The thirteen rows of a spreadsheet's descriptive statistics, the quartiles and two percentiles, in the unit in the
/// quantity's name; null if there are too few values.
struct Statistics {
  struct Percentiles {
    std::optional<double> p95{}, p99{};
    static auto fields() { return std::tuple(field("95", &Percentiles::p95), field("99", &Percentiles::p99)); }
  };

  std::optional<double> mean{}, standard_error{}, median{}, standard_deviation{}, sample_variance{}, kurtosis{},
      skewness{}, range{}, minimum{}, maximum{}, sum{};
  std::uint64_t count = 0;
  std::optional<double> confidence_level_95{};
  std::array<std::optional<double>, 3> quartiles{};
  Percentiles percentiles{};

  static auto fields() {
    using S = Statistics;
    return std::tuple(field("mean", &S::mean), field("standard_error", &S::standard_error), field("median", &S::median),
                      field("standard_deviation", &S::standard_deviation),
                      field("sample_variance", &S::sample_variance), field("kurtosis", &S::kurtosis),
                      field("skewness", &S::skewness), field("range", &S::range), field("minimum", &S::minimum),
                      field("maximum", &S::maximum), field("sum", &S::sum), field("count", &S::count),
                      field("confidence_level_95", &S::confidence_level_95), field("quartiles", &S::quartiles),
                      field("percentiles", &S::percentiles));
  }
};

/// Bins of equal width from `low` on, in the unit in the quantity's name.
struct HistogramCounts {
  double low = 0, width = 1;
  std::vector<std::uint64_t> counts{};

  static auto fields() {
    using H = HistogramCounts;
    return std::tuple(field("low", &H::low), field("width", &H::width), field("counts", &H::counts));
  }
  [[nodiscard]] std::optional<FieldFault> fault() const;
};
using Histograms = Named<std::optional<HistogramCounts>>;  // null: no values

/// A barrier or collector of the model: its foot in user coordinates [m].
struct BarrierPlace {
  std::string name{}, kind{};  // "barrier" or "collector"
  std::vector<std::array<double, 3>> line_xyz{};
  /// Stations of the points of the foot along the line of the input, on plan [m]; empty if they equal those along the
  /// foot.
  std::vector<double> stations_m{};

  static auto fields() {
    using B = BarrierPlace;
    return std::tuple(field("name", &B::name), field("kind", &B::kind), field("line_xyz", &B::line_xyz),
                      field_if_any("stations_m", &B::stations_m));
  }
};

/// Number of hits on a barrier by their outcome.
struct BarrierOutcomes {
  std::uint64_t stopped = 0, rebounded = 0, broke_through = 0, passed = 0;

  static auto fields() {
    using O = BarrierOutcomes;
    return std::tuple(field(talus::name(BarrierOutcome::stopped), &O::stopped),
                      field(talus::name(BarrierOutcome::rebounded), &O::rebounded),
                      field(talus::name(BarrierOutcome::broke_through), &O::broke_through),
                      field(talus::name(BarrierOutcome::passed), &O::passed));
  }
};

/// A barrier with its results.
struct BarrierSummary : BarrierPlace {
  std::uint64_t hits = 0, rocks_hit = 0, passed_above = 0;
  BarrierOutcomes outcomes{};
  std::optional<double> least_clearance_m{};
  Named<Statistics> statistics{};  // empty if no rock hit it
  Histograms histograms{};         // likewise

  static auto fields() {
    using B = BarrierSummary;
    return std::tuple_cat(
        BarrierPlace::fields(),
        std::tuple(field("hits", &B::hits), field("rocks_hit", &B::rocks_hit), field("passed_above", &B::passed_above),
                   field("outcomes", &B::outcomes), field("least_clearance_m", &B::least_clearance_m),
                   field_if_any("statistics", &B::statistics), field_if_any("histograms", &B::histograms)));
  }
  /// Statistics of a quantity of the hits; empty if no rock hit it.
  [[nodiscard]] Statistics statistics_of(std::string_view quantity) const;
};

/// The terrain as a coarse grid of elevations for pictures, row by row from the south-west.
struct Relief {
  double x0 = 0, y0 = 0, cell_m = 1;
  std::uint64_t columns = 0, rows = 0;
  std::vector<std::optional<double>> z_m{};

  static auto fields() {
    using R = Relief;
    return std::tuple(field("x0", &R::x0), field("y0", &R::y0), field("cell_m", &R::cell_m),
                      field("columns", &R::columns), field("rows", &R::rows), field("z_m", &R::z_m));
  }
  [[nodiscard]] std::optional<FieldFault> fault() const;
};

struct TerrainSummary {
  std::string kind{};                            // "section", "mesh" or "raster"
  std::vector<std::array<double, 2>> section{};  // its vertices x, z [m]
  std::string crs_wkt{};                         // empty: unknown
  std::vector<std::array<double, 3>> bounds{};   // lowest and highest corner [m]
  std::optional<std::uint64_t> triangles{};
  std::optional<Relief> relief{};

  static auto fields() {
    using T = TerrainSummary;
    return std::tuple(field("kind", &T::kind), field_if_any("section", &T::section),
                      field_if_any("crs_wkt", &T::crs_wkt), field_if_any("bounds", &T::bounds),
                      field_if_any("triangles", &T::triangles), field_if_any("relief", &T::relief));
  }
  [[nodiscard]] std::optional<FieldFault> fault() const;
};

/// The rocks of a source.
struct SourceRocks {
  std::string name{};
  std::uint64_t rocks = 0;

  static auto fields() { return std::tuple(field("name", &SourceRocks::name), field("rocks", &SourceRocks::rocks)); }
};

/// The places of a seeder, and the order in which they release rocks: tells the source of any rock.
struct SeederReleases : ReleaseOrder {
  std::vector<std::array<std::uint64_t, 2>> sources{};  // the first place of consecutive ones, and their source

  static auto fields() {
    using R = SeederReleases;
    using N = std::uint64_t;
    return std::tuple(field<R, N>("first_rock", &R::first_rock), field<R, N>("rocks", &R::rocks),
                      field<R, N>("rocks_at_once", &R::rocks_at_once), field<R, N>("places", &R::places),
                      field<R, N>("step", &R::step), field<R, N>("start", &R::start), field("sources", &R::sources));
  }
  [[nodiscard]] std::optional<FieldFault> fault() const;
  /// The number of the source of a rock.
  [[nodiscard]] std::uint64_t source_of(std::uint64_t rock) const;
  /// Calls visit(source, begin, end) for the places `begin` to `end` - 1 of one source.
  template <class Visit>
  void for_sources(Visit&& visit) const {
    for (std::size_t k = 0; k < sources.size(); ++k)
      visit(sources[k][1], sources[k][0], k + 1 < sources.size() ? sources[k + 1][0] : places);
  }
};

/// An input file of a run.
struct InputFile {
  std::string name{};  // as in the project, relative to its file; the project file itself: without its folder
  std::uint64_t bytes = 0;
  std::string sha256{};  // as printed by sha256sum

  static auto fields() {
    return std::tuple(field("name", &InputFile::name), field("bytes", &InputFile::bytes),
                      field("sha256", &InputFile::sha256));
  }
};

/// The source of values of a material that are those of the library.
struct MaterialSource {
  std::string material{}, like{};   // its name, and its entry in the library
  std::vector<std::string> keys{};  // of [[material]], with these values
  std::string source{};

  static auto fields() {
    using M = MaterialSource;
    return std::tuple(field("material", &M::material), field("like", &M::like), field("keys", &M::keys),
                      field("source", &M::source));
  }
};

/// What the report says of a run's inputs besides the project.
struct ReportInputs {
  std::vector<InputFile> files{};
  std::vector<MaterialSource> material_sources{};
  std::string logo{};  // of the title block, as a `data:` address; empty: none

  static auto fields() {
    using R = ReportInputs;
    return std::tuple(field("files", &R::files), field_if_any("material_sources", &R::material_sources),
                      field_if_any("logo", &R::logo));
  }
  [[nodiscard]] std::optional<FieldFault> fault() const;
};

/// A warning of a kind (core/problems.hpp), for programs.
struct WarningKind {
  std::uint64_t warning = 0;  // in the list of warnings
  std::string kind{}, where{};
  static auto fields() {
    using K = WarningKind;
    return std::tuple(field("warning", &K::warning), field("kind", &K::kind), field("where", &K::where));
  }
};

/// Warnings as texts, and the kinds of those that have one.
struct ToldWarnings {
  std::vector<std::string> texts{};
  std::vector<WarningKind> kinds{};
  /// `text`: as it is told.
  void add(const Problem& problem, std::string text);
};

/// How far all rocks have come [m].
struct WaysSummary {
  double flown_m = 0, on_ground_m = 0;  // on the ground: slid or rolled
  static auto fields() {
    using W = WaysSummary;
    return std::tuple(field("flown_m", &W::flown_m), field("on_ground_m", &W::on_ground_m));
  }
};

/// The identity of the run of a summary, and what questions to the run need to know of it.
struct RunIdentity {
  struct Program {
    std::string version{};
    std::optional<std::uint64_t> paths_revision{};  // campaign/paths_revision.hpp; nullopt: of a program without
    static auto fields() {
      return std::tuple(field("version", &Program::version), field_if_any("paths_revision", &Program::paths_revision));
    }
  };
  struct Rocks {
    std::uint64_t planned = 0, done = 0, lifted = 0;  // planned: of the whole campaign
    std::uint64_t with_endpoint = 0, with_path = 0;   // rocks in the tables, of those done
    static auto fields() {
      return std::tuple(field("planned", &Rocks::planned), field("done", &Rocks::done), field("lifted", &Rocks::lifted),
                        field("with_endpoint", &Rocks::with_endpoint), field("with_path", &Rocks::with_path));
    }
  };
  struct Part {
    std::uint64_t number = 0, of = 0, first_rock = 0, rocks = 0;
    static auto fields() {
      return std::tuple(field("number", &Part::number), field("of", &Part::of), field("first_rock", &Part::first_rock),
                        field("rocks", &Part::rocks));
    }
  };

  Program talus{};
  std::string fingerprint{};  // of all inputs of the results
  Rocks rocks{};
  std::optional<Part> shard{};  // nullopt: the whole campaign
  bool interrupted = false;
  std::optional<WaysSummary> ways{};  // nullopt: of a program without
  SharedJson project{};               // complete, with defaults
};

/// The rocks in the store of trajectories.
struct StoredRocks {
  std::uint64_t rocks = 0;
  double share = 1;                   // of the rocks done
  std::uint64_t rows = 0, bytes = 0;  // rows of paths.csv, and size of the file
  static auto fields() {
    using S = StoredRocks;
    return std::tuple(field("rocks", &S::rocks), field("share", &S::share), field("rows", &S::rows),
                      field("bytes", &S::bytes));
  }
};

struct RunSummary : RunIdentity {
  struct Timings {
    double seconds = 0, rocks_per_second = 0;
    std::uint64_t threads = 1;
    static auto fields() {
      return std::tuple(field("seconds", &Timings::seconds), field("rocks_per_second", &Timings::rocks_per_second),
                        field("threads", &Timings::threads));
    }
  };

  std::string name{};
  std::uint64_t seed = 0;
  std::vector<std::array<std::uint64_t, 2>> missing_rocks{};  // of merged runs: first rock and number of each range
  Named<std::uint64_t> end_reasons{};                         // those that occurred
  std::uint64_t events = 0;
  Named<Statistics> statistics{};
  Histograms histograms{};
  std::optional<StoredRocks> trajectories{};  // nullopt: none are stored
  std::vector<BarrierSummary> barriers{};     // and collectors
  SharedJson design{};                        // design_json.hpp; null without a design
  std::vector<SourceRocks> sources{};
  std::vector<SeederReleases> releases{};         // in the order of the rocks
  std::optional<std::uint64_t> parameter_sets{};  // different ones of the ensembles, if there are ensembles
  std::vector<std::string> warnings{};
  std::vector<WarningKind> warning_kinds{};
  std::vector<std::string> notes{};
  double energy_datum_m = 0;         // z in user coordinates at which potential energy is zero
  std::array<double, 3> origin_m{};  // origin for the quantiles of positions
  TerrainSummary terrain{};
  ReportInputs inputs{};
  Timings timings{};

  static auto fields() {
    using S = RunSummary;
    return std::tuple(
        field("talus", &S::talus), field("name", &S::name), field("fingerprint", &S::fingerprint),
        field("seed", &S::seed), field("rocks", &S::rocks), field_if_any("shard", &S::shard),
        field("interrupted", &S::interrupted), field_if_any("missing_rocks", &S::missing_rocks),
        field("end_reasons", &S::end_reasons), field("events", &S::events), field_if_any("ways", &S::ways),
        field("statistics", &S::statistics), field("histograms", &S::histograms),
        field_if_any("trajectories", &S::trajectories), field("barriers", &S::barriers),
        field_if_any("design", &S::design), field("sources", &S::sources), field_if_any("releases", &S::releases),
        field_if_any("parameter_sets", &S::parameter_sets), field("warnings", &S::warnings),
        field_if_any("warning_kinds", &S::warning_kinds), field("notes", &S::notes),
        field("energy_datum_m", &S::energy_datum_m), field("origin_m", &S::origin_m), field("terrain", &S::terrain),
        field("project", &S::project), field_if_any("inputs", &S::inputs), field("timings", &S::timings));
  }
};

/// Reads summary.json, or the file that will become it. If `take` is given, barriers, which may be many, are passed to
/// it one by one and not kept. Throws BadInput if the file is not a summary as a run writes it.
[[nodiscard]] RunSummary read_run_summary(const std::filesystem::path& file,
                                          const std::function<void(BarrierSummary)>& take = {});

/// Reads the identity of the run, also from a summary of another version of the program. Throws BadInput.
[[nodiscard]] RunIdentity read_run_identity(const std::filesystem::path& file);

/// Throws a BadField of such a file as BadInput.
[[noreturn]] void refuse_summary(const std::filesystem::path& file, const BadField& bad);

}  // namespace talus
