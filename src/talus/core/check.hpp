#pragma once
// Checks of the program's own assumptions, in debug builds only. Bad input is a Problem (problems.hpp), and a rock that
// leaves the model is a value (rocks/motion.hpp); neither is checked here.

#include <cstdio>
#include <cstdlib>

#ifdef NDEBUG
#define TALUS_PROMISE(condition, why) static_cast<void>(0)
#else
#define TALUS_PROMISE(condition, why)                                                                            \
  ((condition) ? static_cast<void>(0)                                                                            \
               : (std::fprintf(stderr, "%s:%d: broken promise: %s (%s)\n", __FILE__, __LINE__, why, #condition), \
                  std::abort()))
#endif
