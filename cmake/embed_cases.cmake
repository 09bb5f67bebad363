# Embeds the published cases (verification/) in the library, so that `talus verify` needs no files. Included, it defines
# talus_embed_cases(target); as a script (cmake -DFOLDER=... -DOUTPUT=... -P embed_cases.cmake) it writes the C++ file.

if(CMAKE_SCRIPT_MODE_FILE)
  file(GLOB cases RELATIVE "${FOLDER}" "${FOLDER}/*/*.toml" "${FOLDER}/*/*.csv")
  set(code "// Made by cmake/embed_cases.cmake; do not edit.\n#include \"talus/verification/cases.hpp\"\n\n")
  string(APPEND code "namespace talus::verification {\n\nFiles embedded_cases() {\n  return {\n")
  foreach(name IN LISTS cases)
    file(READ "${FOLDER}/${name}" text)
    string(FIND "${text}" ")embedded\"" found)
    if(NOT found EQUAL -1)
      message(FATAL_ERROR "${name} holds the text )embedded\", with which its C++ string would end")
    endif()
    string(APPEND code "      {\"${name}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  file(WRITE "${OUTPUT}" "${code}  };\n}\n\n}  // namespace talus::verification\n")
  return()
endif()

set(TALUS_EMBED_CASES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(talus_embed_cases target)
  set(folder ${CMAKE_SOURCE_DIR}/verification)
  set(output ${CMAKE_BINARY_DIR}/generated/embedded_cases.cpp)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*/*.toml ${folder}/*/*.csv)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DOUTPUT=${output} -P ${TALUS_EMBED_CASES_SCRIPT}
    DEPENDS ${files} ${TALUS_EMBED_CASES_SCRIPT}
    COMMENT "Embedding the published cases"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
