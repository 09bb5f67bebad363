// `talus verify`: the published cases, number by number.

#include <fmt/format.h>

#include <memory>

#include "command_options.hpp"
#include "commands.hpp"
#include "earlier_output.hpp"
#include "exit_codes.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/files/output_file.hpp"
#include "talus/verification/cases.hpp"
#include "talus/verification/show.hpp"
#include "talus/verification/verify.hpp"

namespace talus::cli {

namespace {

struct VerifyOptions {
  std::vector<std::string> cases;  // empty: all
  std::filesystem::path json;      // empty: none
  std::filesystem::path page;      // empty: none
  std::filesystem::path folder;    // of the cases; empty: those built into the program
};

void write(const std::filesystem::path& file, const std::string& text) {
  OutputFile output(place_of_file(file));
  output.write(text);
  output.commit();
}

int verify(const VerifyOptions& options) {
  using namespace verification;
  for (const auto& file : {options.json, options.page}) {
    if (!file.empty()) (void)place_of_file(file);  // fails before the cases run, which takes minutes
  }
  if (!options.json.empty()) refuse_other_files(options.json, "{\n  \"passes\":", "comparison");
  if (!options.page.empty()) refuse_other_files(options.page, page_title, "page");
  const Files files = options.folder.empty() ? embedded_cases() : cases_in(options.folder);
  std::vector<Case> cases;
  for (const std::string& name : chosen_cases(files, options.cases)) cases.push_back(read_case(files, name));

  take_available_threads();
  std::vector<CaseResult> results;
  bool passes = true;
  for (const Case& one : cases) {
    results.push_back(verification::verify(one, files));
    passes = passes && results.back().passes();
    fmt::print("{}", verification::text(results.back()));
  }
  fmt::print("{}", summary(results));
  if (!options.json.empty()) write(options.json, json(results).dump(2) + '\n');
  if (!options.page.empty()) write(options.page, page(cases, results));
  return passes ? done : check_failed;
}

}  // namespace

Command add_verify(CLI::App& app) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand("verify", "Run the published verification cases and compare every number");
  command->add_option("cases", options->cases, "Case names, or the beginnings of names (default: all)")
      ->type_name("CASE");
  command->add_option("--json", options->json, "Also write the comparison as JSON")
      ->check(names_file)
      ->type_name("FILE");
  command->add_option("--page", options->page, "Also write the comparison as a Markdown page")
      ->check(names_file)
      ->type_name("FILE");
  command->add_option("--cases", options->folder, "Folder of the cases (default: those built into the program)")
      ->check(names_folder)
      ->type_name("DIR");
  return {command, [options] { return verify(*options); }};
}

}  // namespace talus::cli
