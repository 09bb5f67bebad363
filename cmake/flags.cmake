# Compiler settings of all targets of Talus: talus_flags has those that users of the library need, too, because bits and
# layouts depend on them; talus_own_flags has the rest.
add_library(talus_flags INTERFACE)
set_target_properties(talus_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(talus_flags INTERFACE cxx_std_20)
add_library(talus_own_flags INTERFACE)
target_link_libraries(talus_flags INTERFACE $<BUILD_INTERFACE:talus_own_flags>)
target_compile_options(talus_own_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Wconversion -Wno-sign-conversion
  # Where several files are compiled at once, a name of another file is hidden on purpose.
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
  # Designated initializers omit members with defaults on purpose; vectors of four doubles are not part of a stable ABI.
  -Wno-missing-field-initializers -Wno-psabi
  # sqrt and the like need not set errno: they become one instruction, with the same results.
  -fno-math-errno
  # Code for a shared library may call its own functions directly.
  $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
  # A vector's coordinates are written one by one; reading two at once would wait until both are in memory.
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# No fused multiply-add: the bits of a result must not depend on what the compiler fuses.
target_compile_options(talus_flags INTERFACE -ffp-contract=off
  # Clang before 19 knows no operator delete with a size otherwise.
  $<$<CXX_COMPILER_ID:Clang>:-fsized-deallocation>)
# Eigen's sums have the same order on every processor. It changes the layout of its vectors, so all code must be compiled
# with it, or none.
target_compile_definitions(talus_flags INTERFACE EIGEN_DONT_VECTORIZE)
if(TALUS_WERROR)
  target_compile_options(talus_own_flags INTERFACE -Werror)
endif()
if(TALUS_SANITIZE)
  target_compile_options(talus_flags INTERFACE -O1 -g1
    -fsanitize=${TALUS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    # In instrumented code g++ 12 reports optionals as used before they are set, wrongly.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(talus_flags INTERFACE -fsanitize=${TALUS_SANITIZE})
endif()
if(TALUS_FUZZ)  # lets libFuzzer see which branches of the library an input takes
  target_compile_options(talus_flags INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(talus_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Headers and templates, which take most of the time, are compiled once for several source files. Names in unnamed
# namespaces must then differ between the files of a target.
function(talus_unity target)
  if(TALUS_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
  endif()
endfunction()

# Code that takes no noticeable part of a run's time is compiled with less optimisation, in two thirds of the time, and
# with a precompiled header of all that its files include from others. The first target makes the header, the others
# use it.
function(talus_cold target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  get_property(first GLOBAL PROPERTY TALUS_COLD)
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    set_property(GLOBAL PROPERTY TALUS_COLD ${target})
    target_precompile_headers(${target} PRIVATE <algorithm> <filesystem> <functional> <map> <optional> <ranges>
      <span> <string> <variant> <vector> <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp> [["talus/project/toml.hpp"]]
      <tbb/enumerable_thread_specific.h> <tbb/parallel_for.h>)
  endif()
endfunction()
