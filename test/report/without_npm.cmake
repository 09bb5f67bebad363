# Bundles the report's pages as a build without npm does, with Debian's esbuild and D3, and compares what D3 offers in
# them with that of npm: cmake -DWEB=... -DESBUILD=... -DD3_MODULES=... -DFOLDER=... -P without_npm.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/report_pages.cmake)
file(REMOVE_RECURSE "${FOLDER}")
foreach(part archive figures generated geometry report settings units)
  file(COPY "${WEB}/src/${part}" DESTINATION "${FOLDER}")  # away from node_modules
endforeach()
set(pages)
foreach(page IN LISTS TALUS_REPORT_PAGES)
  list(APPEND pages "${FOLDER}/report/${page}.ts")
endforeach()
set(without_npm "${CMAKE_COMMAND};-E;env;NODE_PATH=${D3_MODULES};${ESBUILD}")
set(options "--bundle;--format=iife;--minify;--target=es2020;--log-level=warning")
foreach(command
    "${without_npm};${pages};${options};--outdir=${FOLDER}"
    "${without_npm};${FOLDER}/figures/d3.ts;${options};--global-name=d3;--outfile=${FOLDER}/d3.js"
    "${WEB}/node_modules/.bin/esbuild;${WEB}/src/figures/d3.ts;${options};--global-name=d3;--outfile=${FOLDER}/npm.js"
    "node;${CMAKE_CURRENT_LIST_DIR}/same_exports.cjs;${FOLDER}/d3.js;${FOLDER}/npm.js")
  execute_process(COMMAND ${command} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the report's pages of a build without npm are not those of one with it")
  endif()
endforeach()
