# Puts the fixed parts of the report's page (src/talus/report/page/) and the drawing library D3 into the library, so that
# the program is one file and its reports need no network. Included, it gives talus_embed_report(target); as a script
# (cmake -DFOLDER=... -DD3_SCRIPT=... -DOUTPUT=... -P embed.cmake) it writes the C++ file with one string a part.

# In this order on the page: each may use what stands before it.
set(TALUS_REPORT_SCRIPTS format figure run tables statistics overview terrain inputs slope mapframe plan maps
  envelopes energy distributions impacts barriers design paper page)

if(CMAKE_SCRIPT_MODE_FILE)
  set(code "// Made by cmake/embed.cmake; do not edit.\n")
  string(APPEND code "#include \"talus/report/page/assets.hpp\"\n\nnamespace talus::io::assets {\n")
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
  embed(page "${FOLDER}/page.html")
  embed(style "${FOLDER}/style.css")
  embed(script ${TALUS_REPORT_SCRIPTS})
  embed(d3 "${D3_SCRIPT}")
  file(WRITE "${OUTPUT}" "${code}}  // namespace talus::io::assets\n")
  return()
endif()

set(TALUS_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
find_file(D3_SCRIPT d3.min.js PATHS /usr/share/nodejs/d3/dist NO_DEFAULT_PATH
  DOC "The drawing library D3, version 5, as one minified file")
if(NOT D3_SCRIPT)
  message(FATAL_ERROR "D3 is missing. Install Debian's package node-d3, or name D3 5's d3.min.js: -DD3_SCRIPT=...")
endif()

function(talus_embed_report target)
  set(folder ${CMAKE_SOURCE_DIR}/src/talus/report/page)
  set(output ${CMAKE_BINARY_DIR}/generated/report_assets.cpp)
  set(parts ${TALUS_REPORT_SCRIPTS})
  list(TRANSFORM parts REPLACE "(.+)" "${folder}/\\1.js")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DD3_SCRIPT=${D3_SCRIPT} -DOUTPUT=${output} -P ${TALUS_EMBED_SCRIPT}
    DEPENDS ${folder}/page.html ${folder}/style.css ${parts} ${D3_SCRIPT} ${TALUS_EMBED_SCRIPT}
    COMMENT "Embedding the report's page"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
