# What npm fetches for a folder with a package-lock.json, and from nowhere but that list:
# talus_npm(STAMP FOLDER) gives the file that is there once it has.

find_program(NPM npm)

function(talus_npm stamp_variable folder)
  if(NOT NPM)
    message(FATAL_ERROR "npm was not found. Install Node.js 18 or later with it, or build with -DTALUS_SERVER=OFF")
  endif()
  set(stamp ${folder}/node_modules/.package-lock.json)
  set(${stamp_variable} ${stamp} PARENT_SCOPE)
  get_property(known GLOBAL PROPERTY TALUS_NPM_FOLDERS)
  if(folder IN_LIST known)  # another target has it fetched, too
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
