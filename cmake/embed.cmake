# Embeds the fixed parts of the report's pages (src/talus/report/page/) and their scripts (web/src/report/, bundled with the
# figures that they share with the workbench and the parts of D3 that these use) in the library, so that the program is one
# file and its reports need no network. Included, it defines talus_embed_report(target); as a script
# (cmake -DFOLDER=... -DFIGURES=... -DBUNDLES=... -DOUTPUT=... -P embed.cmake) it writes the C++ file with one string per
# part.

include(${CMAKE_CURRENT_LIST_DIR}/report_pages.cmake)

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
  embed(page "${FOLDER}/page.html")
  embed(style "${FIGURES}/figures.css" "${FOLDER}/style.css")
  foreach(page IN LISTS TALUS_REPORT_PAGES)
    embed(${page}_script "${BUNDLES}/${page}.js")
  endforeach()
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

function(talus_bundle_report folder)
  set(web ${CMAKE_SOURCE_DIR}/web)
  if(TALUS_FIGURES_WITH_NPM)
    talus_npm(modules ${web})
    set(esbuild ${web}/node_modules/.bin/esbuild)
  else()
    set(esbuild ${CMAKE_COMMAND} -E env NODE_PATH=${D3_MODULES} ${ESBUILD})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${web}/src/report/*.ts ${web}/src/archive/*.ts ${web}/src/figures/*.ts
    ${web}/src/generated/*.ts ${web}/src/geometry/*.ts ${web}/src/settings/*.ts ${web}/src/units/*.ts)
  list(TRANSFORM TALUS_REPORT_PAGES REPLACE "(.+)" "${web}/src/report/\\1.ts" OUTPUT_VARIABLE entries)
  list(TRANSFORM TALUS_REPORT_PAGES REPLACE "(.+)" "${folder}/\\1.js" OUTPUT_VARIABLE bundles)
  add_custom_command(
    OUTPUT ${bundles}
    COMMAND ${esbuild} ${entries} --bundle --format=iife --minify --charset=utf8 --legal-comments=inline --target=es2020
      --log-level=warning --outdir=${folder}
    DEPENDS ${sources} ${modules}
    COMMENT "Bundling the report's pages"
    VERBATIM)
endfunction()

function(talus_embed_report target)
  set(folder ${CMAKE_SOURCE_DIR}/src/talus/report/page)
  set(figures ${CMAKE_SOURCE_DIR}/web/src/figures)
  set(bundles ${CMAKE_BINARY_DIR}/generated/report)
  set(output ${CMAKE_BINARY_DIR}/generated/report_assets.cpp)
  list(TRANSFORM TALUS_REPORT_PAGES REPLACE "(.+)" "${bundles}/\\1.js" OUTPUT_VARIABLE scripts)
  talus_bundle_report(${bundles})
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DFIGURES=${figures} -DBUNDLES=${bundles}
      -DOUTPUT=${output} -P ${TALUS_EMBED_SCRIPT}
    DEPENDS ${folder}/page.html ${folder}/style.css ${figures}/figures.css ${scripts} ${TALUS_EMBED_SCRIPT}
    COMMENT "Embedding the report's pages"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON
    COMPILE_OPTIONS -Wno-overlength-strings)  # clang warns of texts that a compiler of 1998 might not take
endfunction()
