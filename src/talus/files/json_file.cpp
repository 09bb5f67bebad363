#include "talus/files/json_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>
#include <utility>

#include "talus/files/json_text.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus {

void refuse_json_file(const std::filesystem::path& path, std::string where, std::string what, std::string why,
                      std::string_view hint) {
  throw BadInput(Problem{.file = path.string(),
                         .where = std::move(where),
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = std::string(hint)});
}

std::string text_of_json_file(const std::filesystem::path& path, std::string_view hint, std::uintmax_t most_bytes) {
  const auto refuse = [&](std::string what, std::string why) {
    refuse_json_file(path, "", std::move(what), std::move(why), hint);
  };
  if (const auto why = not_an_ordinary_file(path)) refuse("cannot be opened", *why);
  std::ifstream stream(path, std::ios::binary);
  std::error_code error;
  if (!stream) {
    refuse(std::filesystem::exists(path, error) ? "cannot be opened" : "there is no such file",
           "the folder of a finished run has it");
  }
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error || bytes > most_bytes) {
    refuse("cannot be read", error
                                 ? error.message()
                                 : fmt::format("it has {} MiB; expected at most {}", bytes >> 20U, most_bytes >> 20U));
  }
  std::string text(bytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(bytes));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (const std::size_t depth = depth_of_json(text); depth > deepest_json) {
    refuse("is damaged", fmt::format("its lists are nested {} deep; expected at most {}", depth, deepest_json));
  }
  return text;
}

}  // namespace talus
