# Builds the workbench's page (web/) with Vite and embeds it in the program: talus_embed_page(target).

include(${CMAKE_CURRENT_LIST_DIR}/npm.cmake)

function(talus_embed_page target)
  set(web ${CMAKE_SOURCE_DIR}/web)
  talus_npm(modules ${web})
  set(packed ${CMAKE_BINARY_DIR}/web)
  set(output ${CMAKE_BINARY_DIR}/generated/page_assets.cpp)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${web}/src/* ${web}/public/*)
  file(GLOB documents CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/*.md)  # which the page's help quotes
  list(APPEND sources ${documents} ${web}/index.html ${web}/vite.config.ts ${web}/tsconfig.json ${web}/package.json)
  set(embed ${CMAKE_SOURCE_DIR}/cmake/embed_bytes.cmake)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${NPM} run --silent build -- --outDir ${packed} --emptyOutDir --logLevel warn
    COMMAND ${NPM} run --silent pack -- ${packed}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${packed} -DFUNCTION=page_assets -DITEM=Asset -DOUTPUT=${output}
            -DHEADER=assets.hpp -DNAMESPACE=talus::server -P ${embed}
    DEPENDS ${sources} ${modules} ${web}/pack.mjs ${web}/licences.mjs ${embed}
    WORKING_DIRECTORY ${web}
    COMMENT "Building the page"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
