# Bundles the report's figures as a build without npm does, with Debian's esbuild and D3, and compares what the bundle
# offers with npm's: cmake -DWEB=... -DESBUILD=... -DD3_MODULES=... -DBUNDLE=... -DFOLDER=... -P without_npm.cmake
file(REMOVE_RECURSE "${FOLDER}")
file(COPY "${WEB}/src/figures" "${WEB}/src/generated" "${WEB}/src/geometry" "${WEB}/src/settings"
  "${WEB}/src/units" DESTINATION "${FOLDER}")  # away from node_modules
foreach(command
    "${CMAKE_COMMAND};-E;env;NODE_PATH=${D3_MODULES};${ESBUILD};${FOLDER}/figures/report.ts;--bundle;--format=iife;--global-name=figures;--minify;--target=es2020;--log-level=warning;--outfile=${FOLDER}/figures.js"
    "node;${CMAKE_CURRENT_LIST_DIR}/same_exports.cjs;${FOLDER}/figures.js;${BUNDLE}")
  execute_process(COMMAND ${command} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the figures of a build without npm are not those of one with it")
  endif()
endforeach()
