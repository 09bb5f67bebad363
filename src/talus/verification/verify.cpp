#include "talus/verification/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>

#include "talus/core/overloaded.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::verification {
namespace {

/// The results of the runs of a case, each computed on first use.
class Runs {
 public:
  Runs(const Case& published, const Files& files) : published_(published), files_(files) {}

  const std::vector<Event>& path(const std::string& run) {
    Ran& ran = of(run);
    if (!ran.path) ran.path = path_of(ran.model, 0);
    return *ran.path;
  }
  std::vector<Event> at_times(const std::string& run, std::span<const double> times) {
    return path_at(of(run).model, 0, times);
  }
  const Observed& observed(const std::string& run, Energies energies = Energies::skip) {
    Ran& ran = of(run);
    if (!ran.observed || (energies == Energies::watch && !ran.has_energies)) {
      ran.observed = observe(ran.model, energies);
      ran.has_energies = energies == Energies::watch;
    }
    return *ran.observed;
  }

 private:
  struct Ran {
    Model model;
    std::optional<std::vector<Event>> path;
    std::optional<Observed> observed;
    bool has_energies = false;
  };
  Ran& of(const std::string& run_name) {
    const auto found = ran_.find(run_name);
    if (found != ran_.end()) return found->second;
    const Run& run = published_.run(run_name);
    const std::string file = fmt::format("{}/{}", published_.name, run.project);
    project::Reading reading =
        project::read_project_text(files_.find(file)->second, file, {run.settings, run.rocks, std::nullopt});
    return ran_.emplace(run_name, Ran{project::build_model(reading.project, reading.warnings), {}, {}, false})
        .first->second;
  }

  const Case& published_;
  const Files& files_;
  std::map<std::string, Ran> ran_;
};

std::string between(const Interval& interval) { return fmt::format("{:.6g} ... {:.6g}", interval.low, interval.high); }

Verdict verdict(bool agrees) { return agrees ? Verdict::agrees : Verdict::differs; }

/// The largest published number of each kind.
std::array<double, kind_count> scales(const PathTable& table) {
  std::array<double, kind_count> scale{};
  for (const auto& [column, quantity] : table.columns) {
    const std::size_t c = *table.published.column(column);
    for (std::size_t r = 0; r < table.published.rows().size(); ++r) {
      const auto& number = table.published.number(r, c);
      double& largest = scale[static_cast<std::size_t>(kind_of(quantity))];
      if (number) largest = std::max(largest, std::abs(number->value));
    }
  }
  return scale;
}

const Exception* exception_of(const PathTable& table, const std::string& row, const std::string& column) {
  const auto found =
      std::ranges::find_if(table.exceptions, [&](const Exception& e) { return e.concerns(row, column); });
  return found == table.exceptions.end() ? nullptr : &*found;
}

/// What is compared with each row of the table; nullopt if the path has no such row.
std::vector<std::optional<Event>> events_of(const PathTable& table, const std::string& run, Runs& runs) {
  std::vector<std::optional<Event>> events;
  if (table.times) {
    std::vector<double> times;
    for (std::size_t row = 0; row < table.published.rows().size(); ++row)
      times.push_back(table.published.number(row, *table.times)->value);
    const std::vector<Event> path = runs.at_times(run, times);
    events.assign(path.begin(), path.end());
  } else {
    const std::vector<Event>& path = runs.path(run);
    for (const std::size_t row : table.events)
      events.push_back(row < path.size() ? std::optional(path[row]) : std::nullopt);
  }
  return events;
}

std::vector<Line> compare(const PathTable& table, const std::string& run, Runs& runs) {
  const std::vector<std::optional<Event>> events = events_of(table, run, runs);
  const auto scale = scales(table);
  const auto event = [&](std::size_t row) { return row < events.size() && events[row] ? &*events[row] : nullptr; };
  std::vector<Line> lines;
  for (std::size_t r = 0; r < table.published.rows().size(); ++r) {
    const std::string& row = table.published.rows()[r];
    for (const auto& [column, quantity] : table.columns) {
      const std::size_t c = *table.published.column(column);
      const auto& number = table.published.number(r, c);
      if (!number) continue;  // the table has no number there
      Line line{row, column, number->text, {}, {}, {}, Verdict::differs, {}};
      if (event(r) != nullptr) line.ours = value(quantity, *event(r), event(r + 1));
      if (line.ours) {
        // The sign of the spin in section differs between programs, so magnitudes are compared.
        line.difference = *line.ours - (quantity == PathQuantity::spin ? std::abs(number->value) : number->value);
      }
      const Exception* exception = exception_of(table, row, column);
      if (exception != nullptr) line.why = exception->why;
      if (exception != nullptr && !exception->tolerance) {
        line.verdict = Verdict::left_out;
      } else {
        const Tolerance& tolerance = exception != nullptr ? *exception->tolerance : table.tolerance;
        const double allowed = tolerance.allowed(*number, scale[static_cast<std::size_t>(kind_of(quantity))]);
        line.allowed = fmt::format("{:.3g}", allowed);
        // Allows for the rounding of the difference.
        line.verdict = verdict(line.difference && std::abs(*line.difference) <= allowed * (1 + 1e-9));
      }
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

/// Whether statistics of very many rocks are comparable with those of few. The others depend on the sample size.
bool is_independent_of_size(Statistic statistic) {
  switch (statistic) {
    case Statistic::mean:
    case Statistic::median:
    case Statistic::standard_deviation:
    case Statistic::sample_variance:
    case Statistic::kurtosis:
    case Statistic::skewness:
      return true;
    default:
      return false;
  }
}

std::vector<Line> compare(const StatisticsTable& table, const std::string& run, Runs& runs) {
  const std::vector<double>& many = runs.observed(run).sample(table.sample);
  const Descriptive ours = describe(many);
  std::map<std::uint64_t, SamplingSpread> spreads;
  std::vector<Line> lines;
  for (const std::string& column : table.columns) {
    const std::size_t c = *table.published.column(column);
    const auto& count = table.published.number(*table.published.row(name(Statistic::count)), c);
    for (std::size_t r = 0; r < table.published.rows().size(); ++r) {
      const auto& number = table.published.number(r, c);
      const Statistic statistic = *statistic_of(table.published.rows()[r]);
      if (!number || statistic == Statistic::count) continue;
      const bool is_tested = std::ranges::find(table.tested, statistic) != table.tested.end();
      Line line{table.published.rows()[r],
                column,
                number->text,
                {},
                {},
                {},
                is_tested ? Verdict::differs : Verdict::shown,
                {}};
      if (count && count->value >= 1 && !many.empty()) {
        const auto size = static_cast<std::uint64_t>(count->value);
        const SamplingSpread& spread = spreads.try_emplace(size, many, size).first->second;
        line.ours = is_independent_of_size(statistic) ? value(ours, statistic) : spread.typical(statistic);
        if (line.ours) line.difference = *line.ours - number->value;
        if (const auto interval = spread.interval(statistic)) {
          line.allowed = between(*interval);
          if (is_tested) line.verdict = verdict(interval->contains(number->value));
        }
      }
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::vector<Line> compare(const ValuesTable& table, Runs& runs) {
  std::vector<Line> lines;
  for (const ValuesTable::Value& v : table.values) {
    Line line{v.what, fmt::format("{} of {}", name(v.statistic), name(v.sample)), {}, {}, {}, {}, Verdict::differs,
              v.run};
    line.ours = value(describe(runs.observed(v.run).sample(v.sample)), v.statistic);
    if (const auto* number = std::get_if<Printed>(&v.published)) {
      const double allowed = v.tolerance.allowed(*number, std::abs(number->value));
      line.published = number->text;
      line.allowed = fmt::format("{:.3g}", allowed);
      if (line.ours) {
        line.difference = *line.ours - number->value;
        line.verdict = verdict(std::abs(*line.difference) <= allowed * (1 + 1e-9));
      }
    } else {
      const Interval& interval = std::get<Interval>(v.published);
      line.published = between(interval);
      line.allowed = "in between";
      if (line.ours) line.verdict = verdict(interval.contains(*line.ours));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Line> compare(const CountTable& table, const std::string& run, Runs& runs) {
  const Observed& observed = runs.observed(run);
  const double probability =
      static_cast<double>(observed.sample(table.sample).size()) / static_cast<double>(observed.rocks);
  const Interval interval = binomial_interval(table.rocks, probability);
  std::vector<Line> lines;
  for (const auto& [whose, number] : table.published) {
    const double ours = probability * static_cast<double>(table.rocks);
    lines.push_back({fmt::format("of {} rocks", table.rocks),
                     whose,
                     number.text,
                     ours,
                     ours - number.value,
                     between(interval),
                     verdict(interval.contains(number.value)),
                     {}});
  }
  return lines;
}

std::vector<Line> compare(const AgreementTable& table, const std::vector<std::string>& run_names, Runs& runs) {
  const Descriptive reference = describe(runs.observed(run_names.front()).sample(table.sample));
  const double allowed = 0.5 * std::pow(10.0, -table.decimals);
  std::vector<Line> lines;
  for (const std::string& run : run_names) {
    const Descriptive rows = describe(runs.observed(run).sample(table.sample));
    for (const Statistic statistic : table.statistics) {
      const auto expected = value(reference, statistic);
      Line line{run,
                std::string(name(statistic)),
                fmt::format("{:.{}f}", expected.value_or(0), table.decimals),
                value(rows, statistic),
                {},
                fmt::format("{:.3g}", allowed),
                Verdict::differs,
                {}};
      if (line.ours && expected) {
        line.difference = *line.ours - *expected;
        line.verdict = verdict(std::abs(*line.difference) <= allowed);
      }
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::vector<Line> compare(const SoundnessTable& table, const std::string& run, Runs& runs) {
  const Observed& observed = runs.observed(run, Energies::watch);
  std::vector<Line> lines;
  const auto add = [&](std::string row, std::string quantity, double ours, std::string allowed, Verdict v) {
    lines.push_back({std::move(row), std::move(quantity), {}, ours, {}, std::move(allowed), v, {}});
  };
  for (int k = 0; k < end_reason_count; ++k) {
    const auto reason = static_cast<EndReason>(k);
    const auto count = static_cast<double>(observed.ends[static_cast<std::size_t>(k)]);
    const bool is_fine = std::ranges::find(table.ends, reason) != table.ends.end();
    add(fmt::format("ended: {}", name(reason)), "rocks", count, is_fine ? "any" : "0", verdict(is_fine || count == 0));
  }
  add("largest rise of the total energy", "of the path's energy", observed.max_energy_rise,
      fmt::format("{:g}", table.energy_rise), verdict(observed.max_energy_rise <= table.energy_rise));
  for (const SampleQuantity quantity : table.shown) {
    const Descriptive rows = describe(observed.sample(quantity));
    for (int s = 0; s < statistic_count; ++s) {
      const auto statistic = static_cast<Statistic>(s);
      if (const auto x = value(rows, statistic)) {
        add(std::string(name(quantity)), std::string(name(statistic)), *x, "", Verdict::shown);
      }
    }
  }
  return lines;
}

}  // namespace

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::agrees:
      return "agrees";
    case Verdict::differs:
      return "DIFFERS";
    case Verdict::left_out:
      return "left out";
    case Verdict::shown:
      return "shown";
  }
  return "";
}

std::size_t TableResult::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::ranges::count(lines, verdict, &Line::verdict));
}
std::size_t CaseResult::count(Verdict verdict) const {
  std::size_t sum = 0;
  for (const TableResult& table : tables) sum += table.count(verdict);
  return sum;
}

CaseResult verify(const Case& published, const Files& files) {
  const auto begin = std::chrono::steady_clock::now();
  CaseResult result{published.name, published.title, {}, 0};
  Runs runs(published, files);
  for (const Table& table : published.tables) {
    const auto add = [&](const std::string& run, std::vector<Line> lines) {
      result.tables.push_back({table.title, table.source, run, table.why, std::move(lines)});
    };
    const auto with_each_run = [&](const auto& kind) {
      for (const std::string& run : table.runs) add(run, compare(kind, run, runs));
    };
    std::visit(Overloaded{[&](const ValuesTable& kind) { add("", compare(kind, runs)); },
                          [&](const AgreementTable& kind) { add("", compare(kind, table.runs, runs)); }, with_each_run},
               table.kind);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace talus::verification
