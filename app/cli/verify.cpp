// `talus verify`: the published cases, number by number.

#include <fmt/format.h>

#include "commands.hpp"
#include "earlier_output.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/files/output_file.hpp"
#include "talus/verification/cases.hpp"
#include "talus/verification/show.hpp"
#include "talus/verification/verify.hpp"

namespace talus::cli {

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  OutputFile output(place_of_file(file));
  output.write(text);
  output.commit();
}

}  // namespace

int verify(const VerifyOptions& options) {
  using namespace verification;
  for (const auto& file : {options.json, options.page}) {
    if (!file.empty()) (void)place_of_file(file);  // fails before the cases run, which takes minutes
  }
  if (!options.json.empty()) refuse_other_files(options.json, "{\n  \"passes\":", "comparison");
  if (!options.page.empty()) refuse_other_files(options.page, "# Verification\n", "page");
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

}  // namespace talus::cli
