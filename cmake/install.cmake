# What `cmake --install` installs, by component:
# - program: the program with its manual page, what shells complete, the entry of menus, and examples
# - development: the headers and libraries of all rooms, and a CMake package, with which another project can use
#   `find_package(Talus)` and link Talus::talus, or single rooms (Talus::terrain)
# - qgis: the plugin of QGIS
# - licence: the licence, for archives; a Debian package has a file of its own (cmake/package.cmake)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS talus_cli COMPONENT program)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/talus COMPONENT program PATTERN library EXCLUDE)
install(FILES packaging/talus.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
install(FILES web/public/icon.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps RENAME talus.svg
  COMPONENT program)

# Written by the program itself, from its declaration of commands and options.
set(shared ${CMAKE_BINARY_DIR}/generated/share)
file(MAKE_DIRECTORY ${shared})
add_custom_command(
  OUTPUT ${shared}/talus.1.gz ${shared}/talus ${shared}/_talus ${shared}/talus.fish
  COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 sh -c "./talus manual | gzip -9n > ${shared}/talus.1.gz && ./talus completion bash > ${shared}/talus && \
./talus completion zsh > ${shared}/_talus && ./talus completion fish > ${shared}/talus.fish"
  DEPENDS talus_cli
  WORKING_DIRECTORY ${CMAKE_BINARY_DIR}
  COMMENT "Writing the manual page and the completions of shells"
  VERBATIM)
add_custom_target(talus_shared ALL DEPENDS ${shared}/talus.1.gz)
install(FILES ${shared}/talus.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${shared}/talus DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${shared}/_talus DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${shared}/talus.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)

install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DATADIR}/talus COMPONENT licence)

talus_list_rooms(rooms)
install(TARGETS talus talus_flags ${rooms} EXPORT Talus
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/talus COMPONENT development)
install(DIRECTORY src/talus DESTINATION include COMPONENT development FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY examples/library DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libtalus-dev/examples
  COMPONENT development)

# Where QGIS of the distribution looks for plugins, if the prefix is /usr.
install(DIRECTORY qgis/talus_provider DESTINATION ${CMAKE_INSTALL_DATADIR}/qgis/python/plugins COMPONENT qgis
  PATTERN __pycache__ EXCLUDE PATTERN LICENSE EXCLUDE)  # Debian has the licence in a file of its own

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Talus)
get_target_property(TALUS_KERNEL talus_trajectory LINK_LIBRARIES)  # the rooms below it, and talus_flags
list(TRANSFORM TALUS_KERNEL REPLACE "^talus_" "")
list(APPEND TALUS_KERNEL trajectory)
install(EXPORT Talus NAMESPACE Talus:: FILE TalusTargets.cmake DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/TalusConfig.cmake.in ${CMAKE_BINARY_DIR}/generated/TalusConfig.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/TalusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/TalusConfig.cmake ${CMAKE_BINARY_DIR}/generated/TalusConfigVersion.cmake
  DESTINATION ${package} COMPONENT development)
