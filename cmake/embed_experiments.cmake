# Embeds the field experiments (validation/) in the library, with their licences: talus_embed_experiments(target).

set(TALUS_EMBED_BYTES_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_bytes.cmake)

function(talus_embed_experiments target)
  set(folder ${CMAKE_SOURCE_DIR}/validation)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${folder}/*)
  set(output ${CMAKE_BINARY_DIR}/generated/experiment_files.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DFUNCTION=experiment_files -DITEM=ExperimentFile -DOUTPUT=${output}
            -DHEADER=talus/validation/experiments.hpp -DNAMESPACE=talus::validation -P ${TALUS_EMBED_BYTES_SCRIPT}
    DEPENDS ${files} ${TALUS_EMBED_BYTES_SCRIPT}
    COMMENT "Embedding the experiments"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON OBJECT_DEPENDS "${files}")
endfunction()
