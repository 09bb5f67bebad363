#include "command_options.hpp"

namespace talus::cli {

void add_project(CLI::App& command, ProjectOptions& options) {
  command.add_option("project", options.file, "The project file (TOML)")->required()->type_name("PROJECT.toml");
  add_overrides(command, "--set", options.settings,
                "Override a setting, for example --set analysis.gravity_m_s2=9.81; repeatable");
  command.add_option("--rocks", options.rocks, "Total number of rocks, instead of the project's")
      ->transform(number_of_rocks())
      ->type_name("N");
  command.add_option("--seed", options.seed, "Seed of the random numbers, instead of the project's")
      ->transform(natural_number())
      ->type_name("S");
}

void add_study(CLI::App& command, std::filesystem::path& study) {
  command.add_option("study", study, "The study file (TOML)")->required()->check(names_file)->type_name("STUDY.toml");
}

void add_run_folder(CLI::App& command, std::filesystem::path& folder, const std::string& description) {
  command.add_option("folder", folder, description)->required()->check(names_folder)->type_name("DIR");
}

void add_overrides(CLI::App& command, const std::string& option, std::vector<std::string>& settings,
                   const std::string& description, const std::string& type_name) {
  command.add_option(option, settings, description)
      ->type_name(type_name)
      ->expected(1)
      ->allow_extra_args(false)  // otherwise it also consumes the arguments after it
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_output_folder(CLI::App& command, std::filesystem::path& folder, const std::string& description) {
  command.add_option("-o,--output", folder, description)->check(names_folder)->type_name("DIR");
}

void add_threads(CLI::App& command, int& threads, const std::string& description) {
  command.add_option("--threads", threads, description)->check(CLI::Range(1, 4096))->type_name("N");
}

void add_quiet(CLI::App& command, bool& quiet, const std::string& description) {
  command.add_flag("--quiet,-q", quiet, description);
}

void add_maps_memory(CLI::App& command, std::uint64_t& bytes) {
  command
      .add_option("--maps-memory", bytes,
                  "Memory limit for maps, for example 4GB (default: half of the available memory)")
      ->transform(memory_size())
      ->type_name("SIZE");
}

CLI::Option_group& add_question(CLI::App& command, std::string& line, std::string& barrier, std::string& polygon) {
  auto* const asked = command.add_option_group("question", "What is asked");
  asked
      ->add_option("--line", line,
                   "Corners \"x,y x,y ...\" (2D: x), a table (.csv) with the columns x_m and y_m, or a GIS file with "
                   "one line")
      ->check(names_line)
      ->type_name("LINE");
  asked->add_option("--barrier", barrier, "A barrier or collector, by its name")->check(names_line)->type_name("NAME");
  asked->add_option("--polygon", polygon, "As --line: the corners of a polygon")
      ->check(names_line)
      ->type_name("POLYGON");
  asked->require_option(1);
  return *asked;
}

}  // namespace talus::cli
