# talus_room(NAME LOWER...): the folder src/talus/NAME as a library talus_NAME, which may include the rooms LOWER.
#
# The compiler finds `talus/NAME/...` in a folder of that room only, build/rooms/NAME, which contains a link to the
# sources. It gets the folders of the room, of LOWER and of their lower rooms, so that an include of any other room does
# not compile. A room is declared after its lower rooms, so that there is no cycle.
function(talus_room name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/talus/${name}/*.cpp)
  set(visible ${CMAKE_BINARY_DIR}/rooms/${name})
  file(MAKE_DIRECTORY ${visible}/talus)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/talus/${name} ${visible}/talus/${name} SYMBOLIC)
  set(target talus_${name})
  add_library(${target} STATIC ${sources})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${visible}> $<INSTALL_INTERFACE:include>)
  target_link_libraries(${target} PUBLIC talus_flags)
  foreach(lower IN LISTS ARGN)
    if(NOT TARGET talus_${lower})
      message(FATAL_ERROR "The room ${name} is to know ${lower}, which is not declared before it (src/CMakeLists.txt)")
    endif()
    target_link_libraries(${target} PUBLIC talus_${lower})
  endforeach()
  if(name IN_LIST TALUS_COLD_ROOMS)
    talus_cold(${target})
  elseif(name STREQUAL "core")  # flags are the same in all other rooms, and so is the precompiled header
    target_precompile_headers(${target} PRIVATE <vector> <string> <variant> <optional> <fmt/format.h>)
  else()
    target_precompile_headers(${target} REUSE_FROM talus_core)
  endif()
  talus_unity(${target})
  set_property(GLOBAL APPEND PROPERTY TALUS_ROOMS ${target})
  # For the tests: the include folders of the room.
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/rooms/${name}.txt
    CONTENT "$<JOIN:$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>,\n>\n")
endfunction()

# The libraries of all rooms, from low to high.
function(talus_list_rooms variable)
  get_property(rooms GLOBAL PROPERTY TALUS_ROOMS)
  set(${variable} ${rooms} PARENT_SCOPE)
endfunction()
