# Embeds the fixed parts of the report's page (src/talus/report/page/) and the figures that it shares with the workbench
# (web/src/figures/, bundled with the parts of D3 that they use) in the library, so that the program is one file and its
# reports need no network. Included, it defines talus_embed_report(target); as a script
# (cmake -DFOLDER=... -DFIGURES=... -DBUNDLE=... -DOUTPUT=... -P embed.cmake) it writes the C++ file with one string per
# part.

# In this order on the page: each may use the ones before it.
set(TALUS_REPORT_SCRIPTS format settings figure run tables statistics overview terrain inputs shapes slope mapframe plan maps
  envelopes energy distributions observed impacts barriers design convergence uncertainty paper sheet page)
# The same for the page of a sensitivity study.
set(TALUS_SENSITIVITY_SCRIPTS format study figure tables paper sensitivity)
# And for that of a comparison of rock models.
set(TALUS_MODELS_SCRIPTS format study figure tables paper models)

if(CMAKE_SCRIPT_MODE_FILE)
  set(code "// Made by cmake/embed.cmake; do not edit.\n")
  string(APPEND code "#include \"talus/report/page/assets.hpp\"\n\nnamespace talus::assets {\n")
  function(embed name)
    string(APPEND code "const std::string_view ${name} =")
    foreach(file IN LISTS ARGN)
      file(READ "${file}" text)
      string(FIND "${text}" ")embedded\"" found)
      if(NOT found EQUAL -1)
        message(FATAL_ERROR "${file} holds the text )embedded\", with which its C++ string would end")
      endif()
      string(APPEND code "\n    R\"embedded(${text})embedded\"")
    endforeach()
    set(code "${code};\n" PARENT_SCOPE)
  endfunction()
  list(TRANSFORM TALUS_REPORT_SCRIPTS REPLACE "(.+)" "${FOLDER}/\\1.js")
  list(TRANSFORM TALUS_SENSITIVITY_SCRIPTS REPLACE "(.+)" "${FOLDER}/\\1.js")
  list(TRANSFORM TALUS_MODELS_SCRIPTS REPLACE "(.+)" "${FOLDER}/\\1.js")
  embed(sensitivity_script ${TALUS_SENSITIVITY_SCRIPTS})
  embed(models_script ${TALUS_MODELS_SCRIPTS})
  embed(page "${FOLDER}/page.html")
  embed(style "${FIGURES}/figures.css" "${FOLDER}/style.css")
  embed(script ${TALUS_REPORT_SCRIPTS})
  embed(figures "${BUNDLE}")
  file(WRITE "${OUTPUT}" "${code}}  // namespace talus::assets\n")
  return()
endif()

set(TALUS_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
include(${CMAKE_CURRENT_LIST_DIR}/npm.cmake)

# The figures are bundled by esbuild: the workbench's, which npm fetches with D3 in the versions of web/package-lock.json;
# or, without the workbench, Debian's esbuild and D3, without npm and network.
find_program(ESBUILD esbuild)
find_path(D3_MODULES d3-selection/src/index.js PATHS /usr/share/nodejs NO_DEFAULT_PATH DOC "The folder of D3's modules")
set(TALUS_FIGURES_WITH_NPM ON)
if(NOT TALUS_SERVER)
  if(ESBUILD AND D3_MODULES)
    set(TALUS_FIGURES_WITH_NPM OFF)
  elseif(NOT NPM)
    message(FATAL_ERROR "The report's figures are bundled by esbuild with D3, and neither npm nor these were found. Install "
      "Debian's packages esbuild and node-d3, or name them: -DESBUILD=... -DD3_MODULES=...")
  endif()
endif()

function(talus_bundle_figures bundle)
  set(web ${CMAKE_SOURCE_DIR}/web)
  if(TALUS_FIGURES_WITH_NPM)
    talus_npm(modules ${web})
    set(esbuild ${web}/node_modules/.bin/esbuild)
  else()
    set(esbuild ${CMAKE_COMMAND} -E env NODE_PATH=${D3_MODULES} ${ESBUILD})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${web}/src/figures/*.ts ${web}/src/generated/columns.ts ${web}/src/geometry/*.ts
    ${web}/src/settings/conditions.ts ${web}/src/units/*.ts)
  add_custom_command(
    OUTPUT ${bundle}
    COMMAND ${esbuild} ${web}/src/figures/report.ts --bundle --format=iife --global-name=figures --minify
      --charset=utf8 --legal-comments=inline --target=es2020 --log-level=warning --outfile=${bundle}
    DEPENDS ${sources} ${modules}
    COMMENT "Bundling the report's figures"
    VERBATIM)
endfunction()

function(talus_embed_report target)
  set(folder ${CMAKE_SOURCE_DIR}/src/talus/report/page)
  set(figures ${CMAKE_SOURCE_DIR}/web/src/figures)
  set(bundle ${CMAKE_BINARY_DIR}/generated/figures.js)
  set(output ${CMAKE_BINARY_DIR}/generated/report_assets.cpp)
  set(parts ${TALUS_REPORT_SCRIPTS} ${TALUS_SENSITIVITY_SCRIPTS} ${TALUS_MODELS_SCRIPTS})
  list(REMOVE_DUPLICATES parts)
  list(TRANSFORM parts REPLACE "(.+)" "${folder}/\\1.js")
  talus_bundle_figures(${bundle})
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DFIGURES=${figures} -DBUNDLE=${bundle}
      -DOUTPUT=${output} -P ${TALUS_EMBED_SCRIPT}
    DEPENDS ${folder}/page.html ${folder}/style.css ${figures}/figures.css ${parts} ${bundle} ${TALUS_EMBED_SCRIPT}
    COMMENT "Embedding the report's page"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON
    COMPILE_OPTIONS -Wno-overlength-strings)  # clang warns of texts that a compiler of 1998 might not take
endfunction()
