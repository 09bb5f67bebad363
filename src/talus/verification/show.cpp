#include "talus/verification/show.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "talus/core/overloaded.hpp"

namespace talus::verification {
namespace {

std::string number(const std::optional<double>& x) { return x ? fmt::format("{:.7g}", *x) : std::string("none"); }
std::string difference(const std::optional<double>& x) { return x ? fmt::format("{:+.2g}", *x) : std::string(); }

std::string with_run(const TableResult& table) {
  return table.run.empty() ? table.title : fmt::format("{} [{}]", table.title, table.run);
}

/// Columns as wide as their widest text, the first two left-aligned, the others right-aligned.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::string_view indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line(indent);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool is_last = k + 1 == row.size();
      line += k < 2 ? fmt::format("{:<{}}  ", row[k], widths[k])
                    : fmt::format("{:>{}}  ", row[k], is_last ? row[k].size() : widths[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::vector<std::string> cells(const Line& line) {
  return {line.row,
          line.quantity,
          line.published.empty() ? "-" : line.published,
          number(line.ours),
          difference(line.difference),
          line.allowed,
          name(line.verdict)};
}

const std::vector<std::string> heads{"row", "quantity", "published", "Talus", "difference", "allowed", "verdict"};

std::string counted(std::size_t agree, std::size_t differ, std::size_t left_out) {
  std::string text = agree + differ == 0 ? std::string("shown, not tested")
                                         : fmt::format("{} of {} numbers agree", agree, agree + differ);
  if (left_out > 0) text += fmt::format(", {} left out with a reason", left_out);
  return text;
}
template <class Counting>
std::string counted(const Counting& result) {
  return counted(result.count(Verdict::agrees), result.count(Verdict::differs), result.count(Verdict::left_out));
}

std::string tolerances(const std::vector<Exception>& exceptions) {
  std::string text;
  for (const Exception& e : exceptions) {
    const std::string rows =
        e.rows.empty() ? "all rows" : fmt::format("row{} {}", e.rows.size() == 1 ? "" : "s", fmt::join(e.rows, ", "));
    const std::string columns = e.columns.empty() ? "all columns" : fmt::format("{}", fmt::join(e.columns, ", "));
    text += fmt::format("- {}, {}: {}. {}\n", rows, columns,
                        e.tolerance ? "tolerance " + e.tolerance->text() : std::string("left out"), e.why);
  }
  return text;
}

std::string compared_with(const TableKind& kind) {
  return std::visit(
      Overloaded{
          [](const PathTable& table) {
            std::string text = fmt::format(
                "{} Tolerance: {}.",
                table.times ? "The motion of one rock at the times of the table." : "The path of one rock, row by row.",
                table.tolerance.text());
            return table.exceptions.empty() ? text : text + "\n\n" + tolerances(table.exceptions);
          },
          [](const StatisticsTable& table) {
            std::vector<std::string_view> tested;
            for (const Statistic s : table.tested) tested.push_back(name(s));
            if (tested.empty()) return fmt::format("Statistics of {}, shown.", name(table.sample));
            return fmt::format(
                "Statistics of {}. Each of {} must lie inside the central 99 % of samples as large as the table's, "
                "drawn from many rocks; the others follow from these and are shown.",
                name(table.sample), fmt::join(tested, ", "));
          },
          [](const ValuesTable& table) {
            std::string text = "Single numbers.\n\n";
            for (const auto& v : table.values) {
              const auto* interval = std::get_if<Interval>(&v.published);
              text += fmt::format(
                  "- {} [{}]: {}\n", v.what, v.run,
                  interval ? fmt::format("between {:g} and {:g}", interval->low, interval->high)
                           : fmt::format("{}, tolerance {}", std::get<Printed>(v.published).text, v.tolerance.text()));
            }
            return text;
          },
          [](const CountTable& table) {
            return fmt::format(
                "How many of {} rocks: inside the central 99 % of the binomial distribution with the share that many "
                "rocks have.",
                table.rocks);
          },
          [](const AgreementTable& table) {
            std::vector<std::string_view> statistics;
            for (const Statistic s : table.statistics) statistics.push_back(name(s));
            return fmt::format("Talus with itself: {} of {} must be the same to {} decimals for all runs.",
                               fmt::join(statistics, ", "), name(table.sample), table.decimals);
          },
          [](const SoundnessTable& table) {
            std::vector<std::string_view> ends;
            for (const EndReason reason : table.ends) ends.emplace_back(name(reason));
            return fmt::format(
                "Requirements for every rock: it ends ({}), and from row to row of its path its total energy does not "
                "rise by more than {:g} of the path's energy, which is rounding.",
                fmt::join(ends, ", or "), table.energy_rise);
          }},
      kind);
}

std::string markdown_row(const std::vector<std::string>& row) { return fmt::format("| {} |\n", fmt::join(row, " | ")); }

/// For each column, the number that is closest to its limit.
std::string worst_of_columns(const TableResult& table) {
  std::vector<std::string> quantities;
  for (const Line& line : table.lines) {
    if (std::ranges::find(quantities, line.quantity) == quantities.end()) quantities.push_back(line.quantity);
  }
  std::string text =
      "| column | agree | differ | left out | largest difference | in row | published | Talus | allowed |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const std::string& quantity : quantities) {
    const Line* worst = nullptr;
    double worst_share = -1;
    std::array<std::size_t, 4> counts{};
    for (const Line& line : table.lines) {
      if (line.quantity != quantity) continue;
      ++counts[static_cast<std::size_t>(line.verdict)];
      if (line.verdict == Verdict::left_out || !line.difference) continue;
      const double allowed = std::strtod(line.allowed.c_str(), nullptr);
      const double share = std::abs(*line.difference) / std::max(allowed, 1e-300);
      if (share > worst_share) {
        worst_share = share;
        worst = &line;
      }
    }
    std::vector<std::string> row{quantity, fmt::format("{}", counts[0]), fmt::format("{}", counts[1]),
                                 fmt::format("{}", counts[2])};
    if (worst != nullptr) {
      row.insert(row.end(),
                 {difference(worst->difference), worst->row, worst->published, number(worst->ours), worst->allowed});
    } else {
      row.insert(row.end(), 5, "");
    }
    text += markdown_row(row);
  }
  return text;
}

std::string all_lines(const TableResult& table) {
  std::string text = markdown_row(heads) + "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Line& line : table.lines) text += markdown_row(cells(line));
  return text;
}

}  // namespace

std::string text(const CaseResult& result) {
  std::string text = fmt::format("{}: {}\n", result.name, result.title);
  for (const TableResult& table : result.tables) {
    std::vector<std::vector<std::string>> rows{heads};
    for (const Line& line : table.lines) rows.push_back(cells(line));
    text += fmt::format("\n  {}, {}\n{}  {}: {}\n", with_run(table), table.source, aligned(rows, "    "),
                        with_run(table), counted(table));
  }
  return text + fmt::format("\n{}: {}\n\n", result.name, counted(result));
}

std::string summary(std::span<const CaseResult> results) {
  std::string text;
  for (const CaseResult& result : results) {
    for (const TableResult& table : result.tables) {
      if (table.count(Verdict::differs) == 0) continue;
      std::vector<std::vector<std::string>> rows{heads};
      for (const Line& line : table.lines) {
        if (line.verdict == Verdict::differs) rows.push_back(cells(line));
      }
      text += fmt::format("OUT: {}, {}, {}\n{}\n", result.name, with_run(table), table.source, aligned(rows, "    "));
    }
  }
  std::vector<std::vector<std::string>> rows{{"case", "", "agree", "differ", "left out", "shown", "time", "verdict"}};
  std::array<std::size_t, 4> all{};
  double seconds = 0;
  const auto add = [&](std::string name, std::string title, const std::array<std::size_t, 4>& counts, double time) {
    rows.push_back({std::move(name), std::move(title), fmt::format("{}", counts[0]), fmt::format("{}", counts[1]),
                    fmt::format("{}", counts[2]), fmt::format("{}", counts[3]), fmt::format("{:.1f} s", time),
                    counts[1] == 0 ? "passes" : "FAILS"});
  };
  for (const CaseResult& result : results) {
    std::array<std::size_t, 4> counts{};
    for (std::size_t k = 0; k < counts.size(); ++k) all[k] += counts[k] = result.count(static_cast<Verdict>(k));
    add(result.name, result.title, counts, result.seconds);
    seconds += result.seconds;
  }
  add("all", "", all, seconds);
  return text + aligned(rows, "");
}

nlohmann::ordered_json json(std::span<const CaseResult> results) {
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  bool passes = true;
  const auto number_or_null = [](const std::optional<double>& x) {
    return x ? nlohmann::ordered_json(*x) : nlohmann::ordered_json(nullptr);
  };
  for (const CaseResult& result : results) {
    nlohmann::ordered_json tables = nlohmann::ordered_json::array();
    for (const TableResult& table : result.tables) {
      nlohmann::ordered_json lines = nlohmann::ordered_json::array();
      for (const Line& line : table.lines) {
        nlohmann::ordered_json entry{{"row", line.row},
                                     {"quantity", line.quantity},
                                     {"published", line.published},
                                     {"talus", number_or_null(line.ours)},
                                     {"difference", number_or_null(line.difference)},
                                     {"allowed", line.allowed},
                                     {"verdict", name(line.verdict)}};
        if (!line.why.empty()) entry["why"] = line.why;
        lines.push_back(std::move(entry));
      }
      tables.push_back({{"title", table.title},
                        {"source", table.source},
                        {"run", table.run},
                        {"why", table.why},
                        {"agree", table.count(Verdict::agrees)},
                        {"differ", table.count(Verdict::differs)},
                        {"numbers", std::move(lines)}});
    }
    passes = passes && result.passes();
    cases.push_back({{"case", result.name},
                     {"title", result.title},
                     {"passes", result.passes()},
                     {"seconds", result.seconds},
                     {"tables", std::move(tables)}});
  }
  return {{"passes", passes}, {"cases", std::move(cases)}};
}

std::string description(const Table& table) {
  std::string text = fmt::format("### {}\n\n*{}.* {}\n", table.title, table.source, compared_with(table.kind));
  if (!text.ends_with("\n\n")) text += '\n';
  return text + fmt::format("Reason: {}\n", table.why);
}

std::string page(std::span<const Case> cases, std::span<const CaseResult> results) {
  std::string text(page_title);
  text += R"(
<!-- Generated by `talus verify --page docs/verification-tables.md` from the folders under verification/; do not edit. -->

The comparisons of [verification](verification.md), table by table. *The manual* is Rocscience's verification manual of
RocFall3, *Lumped Mass and Rigid Body (Legacy Sphere)*.

Where one rock is compared, there is for each column the number that is closest to its limit; `talus verify` shows all.
Where statistics of few rocks are compared, the column *allowed* is the interval that contains the central 99 % of 4000
samples, each as large as the published one, drawn from tens of thousands of rocks. Mean, median, standard deviation,
variance, skewness and kurtosis under *Talus* are those of all these rocks, the other statistics those of a typical
sample.

| case | title | source | agree | differ | left out |
| --- | --- | --- | --- | --- | --- |
)";
  for (std::size_t k = 0; k < cases.size(); ++k) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", cases[k].name, cases[k].title, cases[k].source,
                        results[k].count(Verdict::agrees), results[k].count(Verdict::differs),
                        results[k].count(Verdict::left_out));
  }
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Case& c = cases[k];
    text += fmt::format("\n## {}: {}\n\n*{}.* {}\n", c.name, c.title, c.source, c.about);
    if (!c.notes.empty()) text += "\nNotes:\n\n";
    for (const std::string& note : c.notes) text += fmt::format("- {}\n", note);
    for (const Table& table : c.tables) {
      text += '\n' + description(table);
      for (const TableResult& result : results[k].tables) {
        if (result.title != table.title) continue;
        const bool is_path = std::holds_alternative<PathTable>(table.kind);
        text += fmt::format("\n{}{}.\n\n{}", result.run.empty() ? "" : fmt::format("Run *{}*: ", result.run),
                            counted(result), is_path ? worst_of_columns(result) : all_lines(result));
      }
    }
  }
  return text;
}

}  // namespace talus::verification
