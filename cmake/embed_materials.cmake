# Embeds the library of materials (src/talus/project/materials.toml) in the program, so that it needs no files.
# Included, it defines talus_embed_materials(target); as a script (cmake -DINPUT=... -DOUTPUT=... -P embed_materials.cmake)
# it writes the C++ file.

if(CMAKE_SCRIPT_MODE_FILE)
  file(READ "${INPUT}" text)
  string(FIND "${text}" ")embedded\"" found)
  if(NOT found EQUAL -1)
    message(FATAL_ERROR "${INPUT} holds the text )embedded\", with which its C++ string would end")
  endif()
  set(code "// Made by cmake/embed_materials.cmake; do not edit.\n#include \"talus/project/material_library.hpp\"\n\n")
  string(APPEND code "namespace talus::project {\n\n")
  string(APPEND code "std::string_view material_library_text() {\n  return R\"embedded(${text})embedded\";\n}\n\n")
  file(WRITE "${OUTPUT}" "${code}}  // namespace talus::project\n")
  return()
endif()

set(TALUS_EMBED_MATERIALS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(talus_embed_materials target)
  set(input ${CMAKE_SOURCE_DIR}/src/talus/project/materials.toml)
  set(output ${CMAKE_BINARY_DIR}/generated/materials.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${input} -DOUTPUT=${output} -P ${TALUS_EMBED_MATERIALS_SCRIPT}
    DEPENDS ${input} ${TALUS_EMBED_MATERIALS_SCRIPT}
    COMMENT "Embedding the library of materials"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
