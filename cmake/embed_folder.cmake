# Embeds the files of a folder of the source in a library or program, as a function that lists them:
# talus_embed_folder(TARGET FOLDER folder FUNCTION name ITEM type HEADER header NAMESPACE namespace [EXCLUDE pattern]).
# The header declares the type and the function.

set(TALUS_EMBED_BYTES_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_bytes.cmake)

function(talus_embed_folder target)
  cmake_parse_arguments(PARSE_ARGV 1 of "" "FOLDER;FUNCTION;ITEM;HEADER;NAMESPACE;EXCLUDE" "")
  set(folder ${CMAKE_SOURCE_DIR}/${of_FOLDER})
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${folder}/*)
  set(output ${CMAKE_BINARY_DIR}/generated/${of_FUNCTION}.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DFUNCTION=${of_FUNCTION} -DITEM=${of_ITEM} -DOUTPUT=${output}
            -DHEADER=${of_HEADER} -DNAMESPACE=${of_NAMESPACE} -DEXCLUDE=${of_EXCLUDE} -P ${TALUS_EMBED_BYTES_SCRIPT}
    DEPENDS ${files} ${TALUS_EMBED_BYTES_SCRIPT}
    COMMENT "Embedding ${of_FOLDER}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON OBJECT_DEPENDS "${files}")
endfunction()
