#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {

namespace {

Setting words(std::string_view key, std::string TitleBlock::*text, std::string_view without_it,
              std::string_view meaning) {
  return {.key = key, .slot = member(text), .without_it = without_it, .meaning = meaning, .source = "Talus"};
}

}  // namespace

Table report_table() {
  auto [add, rows] = one_row(&Project::title_block);
  constexpr std::string_view left_out = "left out";
  return {
      .key = "report",
      .meaning =
          "The title block, the paper and the units of the report. They change no result: a run can be resumed after a "
          "change, and `talus report --set report.author=...` overrides them.",
      .settings =
          {
              words("client", &TitleBlock::client, left_out, "For whom the analysis is made."),
              words("project", &TitleBlock::project, left_out,
                    "The work or site that the analysis belongs to; the project's `name` is the title of the sheet."),
              words("number", &TitleBlock::number, left_out, "Number of the project or of the drawing."),
              words("author", &TitleBlock::author, left_out, "Who made the analysis."),
              words("checked", &TitleBlock::checked, left_out, "Who checked it."),
              words("revision", &TitleBlock::revision, left_out, "Revision of the sheet."),
              words("date", &TitleBlock::date, "the date of the run", "Date, as it is to be printed."),
              words("text", &TitleBlock::text, left_out, "Any further text, such as a status or a note."),
              {.key = "logo",
               .slot = member(&TitleBlock::logo),
               .without_it = left_out,
               .meaning = "A picture in the title block: a PNG or JPEG file of at most 512 kB and 4000 pixels a side. "
                          "The path is relative to the project file.",
               .source = "Talus"},
              {.key = "paper",
               .slot = member(&TitleBlock::paper),
               .meaning = "Paper of the printed report: A4 upright or A3 lengthwise.",
               .source = "ISO 216"},
              {.key = "units",
               .slot = member(&TitleBlock::units),
               .meaning =
                   "Units of the report's results: metric, or US customary (ft, ft/s, lb, kip-ft). Its reader can "
                   "change them. Inputs, coordinates on maps and all other files are metric always.",
               .source = "NIST Special Publication 811 (2008), appendix B.8"},
          },
      .topic = topics::sheet,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
