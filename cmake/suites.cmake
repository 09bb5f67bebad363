# Each suite of a GoogleTest program as one test of CTest: a process for each test would take longer to start than most
# tests take. CTest reads this before it runs, with `program` and `label` set.
if(NOT EXISTS "${program}")
  add_test("${label}_is_not_built" "${program}")
  return()
endif()
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE lines RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${program} --gtest_list_tests failed: ${failed}")
endif()
string(REGEX REPLACE " *#[^\n]*" "" lines "${lines}")  # types and values of parameters
string(REPLACE "\n" ";" lines "${lines}")
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_/]+)[.]$")
    set(suite "${CMAKE_MATCH_1}")
    add_test("${suite}" "${program}" "--gtest_filter=${suite}.*" --gtest_brief=1)
    set_tests_properties("${suite}" PROPERTIES LABELS "${label}")
  endif()
endforeach()
