# What `cmake --install` installs: the program, the plugin of QGIS, the headers and libraries of all rooms, and a CMake
# package, with which another project can use `find_package(Talus)` and link Talus::talus, or single rooms
# (Talus::flight).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

talus_list_rooms(rooms)
install(TARGETS talus talus_flags ${rooms} EXPORT Talus ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/talus)
install(DIRECTORY src/talus DESTINATION include FILES_MATCHING PATTERN "*.hpp")
install(TARGETS talus_cli)

# Where QGIS of the distribution looks for plugins, if the prefix is /usr.
install(DIRECTORY qgis/talus_provider DESTINATION ${CMAKE_INSTALL_DATADIR}/qgis/python/plugins COMPONENT qgis
  PATTERN __pycache__ EXCLUDE)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Talus)
install(EXPORT Talus NAMESPACE Talus:: FILE TalusTargets.cmake DESTINATION ${package})
configure_package_config_file(cmake/TalusConfig.cmake.in ${CMAKE_BINARY_DIR}/generated/TalusConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/TalusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/TalusConfig.cmake ${CMAKE_BINARY_DIR}/generated/TalusConfigVersion.cmake
  DESTINATION ${package})
