# Embeds the bundled examples in the program, except that of the library: talus_embed_examples(target).

set(TALUS_EMBED_BYTES_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_bytes.cmake)

function(talus_embed_examples target)
  set(folder ${CMAKE_SOURCE_DIR}/examples)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${folder}/*)
  set(output ${CMAKE_BINARY_DIR}/generated/example_files.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DFUNCTION=example_files -DITEM=ExampleFile -DOUTPUT=${output} -DHEADER=assets.hpp -DNAMESPACE=talus::server
            -DEXCLUDE=^library/
            -P ${TALUS_EMBED_BYTES_SCRIPT}
    DEPENDS ${files} ${TALUS_EMBED_BYTES_SCRIPT}
    COMMENT "Embedding the examples"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON OBJECT_DEPENDS "${files}")
endfunction()
