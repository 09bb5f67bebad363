# Fetches the packages in a folder's package-lock.json with npm, and no others:
# talus_npm(STAMP FOLDER) sets STAMP to the file that exists once this is done.

find_program(NPM npm)

function(talus_npm stamp_variable folder)
  if(NOT NPM)
    message(FATAL_ERROR "npm was not found. Install Node.js 18 or later with it, or build with -DTALUS_SERVER=OFF")
  endif()
  set(stamp ${folder}/node_modules/.package-lock.json)
  set(${stamp_variable} ${stamp} PARENT_SCOPE)
  get_property(known GLOBAL PROPERTY TALUS_NPM_FOLDERS)
  if(folder IN_LIST known)  # another target fetches it already
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY TALUS_NPM_FOLDERS ${folder})
  add_custom_command(
    OUTPUT ${stamp}
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${folder}/package-lock.json
    WORKING_DIRECTORY ${folder}
    COMMENT "Fetching what ${folder} is built with"
    VERBATIM)
endfunction()
