# Installs Talus below FOLDER, builds the examples against that and runs them.
file(REMOVE_RECURSE ${FOLDER}/prefix ${FOLDER}/build)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${TALUS_BUILD} --prefix ${FOLDER}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

function(build_example source)
  cmake_path(GET source FILENAME name)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${FOLDER}/build/${name} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${FOLDER}/prefix -DCMAKE_RUNTIME_OUTPUT_DIRECTORY=${FOLDER}/build/bin
      ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build/${name} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

build_example(${EXAMPLE})

# From the release, through impacts, until it rests.
execute_process(COMMAND ${FOLDER}/build/bin/one_rock OUTPUT_VARIABLE path COMMAND_ERROR_IS_FATAL ANY)
message("${path}")
if(NOT path MATCHES "^projectile  t =  0.000 s .*\nended  .*\nat[ _]rest\n$")
  message(FATAL_ERROR "That is not the path of a rock from its release until it rests")
endif()

# The kernel alone, on a machine without the libraries of the rooms above it.
build_example(${EXAMPLE}/kernel -DCMAKE_DISABLE_FIND_PACKAGE_GDAL=ON -DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON -DCMAKE_DISABLE_FIND_PACKAGE_OpenSSL=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_Qhull=ON)
execute_process(COMMAND ${FOLDER}/build/bin/listen OUTPUT_VARIABLE heard COMMAND_ERROR_IS_FATAL ANY)
message("${heard}")
if(NOT heard MATCHES "^impact at t = .*\nended at t = .* impacts, .* m in flight: at[ _]rest\n$")
  message(FATAL_ERROR "That is not what happens to a rock from its first impact until it rests")
endif()

execute_process(COMMAND ${FOLDER}/prefix/bin/talus --version COMMAND_ERROR_IS_FATAL ANY)
