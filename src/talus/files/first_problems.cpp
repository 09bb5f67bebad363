#include "talus/files/first_problems.hpp"

#include <fmt/format.h>

namespace talus {

void FirstProblems::add(int line, std::string what, std::string why, std::string hint) {
  if (++count_ > most_reported) return;
  first_.add(Problem{.file = file_,
                     .line = line,
                     .where = {},
                     .what = std::move(what),
                     .why = std::move(why),
                     .hint = std::move(hint)});
}

void FirstProblems::throw_if_any() const {
  if (count_ == 0) return;
  Problems all = first_;
  if (count_ > most_reported) {
    all.add(Problem{.file = file_,
                    .where = {},
                    .what = fmt::format("{} more {} have problems", count_ - most_reported, things_),
                    .why = {},
                    .hint = {}});
  }
  throw BadInput(all);
}

}  // namespace talus
