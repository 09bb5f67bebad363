# Installs Talus below FOLDER, builds the example against that and runs it.
file(REMOVE_RECURSE ${FOLDER}/prefix ${FOLDER}/build)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${TALUS_BUILD} --prefix ${FOLDER}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${EXAMPLE} -B ${FOLDER}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${FOLDER}/prefix
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build COMMAND_ERROR_IS_FATAL ANY)

# From the release, through impacts, until it rests.
execute_process(COMMAND ${FOLDER}/build/one_rock OUTPUT_VARIABLE path COMMAND_ERROR_IS_FATAL ANY)
message("${path}")
if(NOT path MATCHES "^projectile  t =  0.000 s .*\nended  .*\nat[ _]rest\n$")
  message(FATAL_ERROR "That is not the path of a rock from its release until it rests")
endif()
execute_process(COMMAND ${FOLDER}/prefix/bin/talus --version COMMAND_ERROR_IS_FATAL ANY)
