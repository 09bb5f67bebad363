# Compiler settings that every target of Talus shares: talus_flags holds what users of the library must have, too, since
# bits and layouts depend on it; talus_own_flags the rest.
add_library(talus_flags INTERFACE)
set_target_properties(talus_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(talus_flags INTERFACE cxx_std_20)
add_library(talus_own_flags INTERFACE)
target_link_libraries(talus_flags INTERFACE $<BUILD_INTERFACE:talus_own_flags>)
target_compile_options(talus_own_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Wconversion -Wno-sign-conversion
  # Where several files are compiled at once, a name of another file is hidden on purpose.
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
  # Designated initializers leave out what has a default on purpose; four doubles side by side have no ABI to keep.
  -Wno-missing-field-initializers -Wno-psabi
  # sqrt and friends need not set errno; this changes no result and lets them be one instruction.
  -fno-math-errno
  # A vector's coordinates are written one by one; to read two of them at once waits until both have arrived in memory.
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# No fused multiply-add: the bits of a result must not depend on what the compiler found to fuse.
target_compile_options(talus_flags INTERFACE -ffp-contract=off)
# Sums have one order on every processor, and a vector's coordinates need not wait for each other. It changes how vectors
# are laid out, so all or none must be compiled with it.
target_compile_definitions(talus_flags INTERFACE EIGEN_DONT_VECTORIZE)
if(TALUS_WERROR)
  target_compile_options(talus_own_flags INTERFACE -Werror)
endif()
if(TALUS_SANITIZE)
  target_compile_options(talus_flags INTERFACE -O1 -g1
    -fsanitize=${TALUS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    # Instrumented code makes g++ 12 see optionals used before they are set.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(talus_flags INTERFACE -fsanitize=${TALUS_SANITIZE})
endif()
if(TALUS_FUZZ)  # the library tells libFuzzer which branches an input took
  target_compile_options(talus_flags INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(talus_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Headers and templates, which take most of the time, are compiled once for several source files. Names in unnamed
# namespaces must then differ between the files of a target.
function(talus_unity target)
  if(TALUS_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
  endif()
endfunction()
