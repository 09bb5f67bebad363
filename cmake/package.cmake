# What `make package` makes with CPack: a Debian package for each component that is installed.

set(TALUS_PACKAGER "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
if(TALUS_PACKAGER STREQUAL " <>")
  set(TALUS_PACKAGER "The Talus authors <talus@packages.invalid>")
endif()

set(CPACK_PACKAGE_NAME talus)
set(CPACK_PACKAGE_VENDOR "The Talus authors")
set(CPACK_PACKAGE_CONTACT "${TALUS_PACKAGER}")
set(CPACK_OUTPUT_FILE_PREFIX ${CMAKE_BINARY_DIR}/packages)
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# talus_package(COMPONENT NAME description...): the component's Debian package, if something is installed with it.
get_cmake_property(installed COMPONENTS)
set(CPACK_COMPONENTS_ALL "")
function(talus_package component name)
  if(NOT component IN_LIST installed)
    return()
  endif()
  string(TOUPPER ${component} key)
  list(JOIN ARGN "\n" description)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${description}" PARENT_SCOPE)
  install(FILES ${shared}/copyright ${shared}/changelog.gz ${shared}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endfunction()

set(about
  "Talus simulates where rocks go that come off a face: how far, how fast, how"
  "high and with what energy, and which barrier stops them, in section (2D) or"
  "over a terrain (3D).")
talus_package(program talus
  "rockfall simulator" ${about} "" "This package has the program and the workbench, which opens in a browser.")
talus_package(development libtalus-dev
  "rockfall simulator - C++ library" ${about} "" "This package has the headers, static libraries and the CMake package.")
talus_package(python python3-talus
  "rockfall simulator - Python module" ${about} "" "This package has the module for Python 3.")
talus_package(qgis qgis-plugin-talus
  "rockfall simulator - QGIS plugin" ${about} "" "This package has the plugin for QGIS.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS xdg-utils)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "chromium, openmpi-bin, qgis")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(development_packages libeigen3-dev libtbb-dev libfmt-dev libboost-dev nlohmann-json3-dev libtomlplusplus-dev libqhull-dev
  libssl-dev)
if(TALUS_GDAL)
  list(APPEND development_packages libgdal-dev libproj-dev libsqlite3-dev)
endif()
if(TALUS_MPI)
  list(APPEND development_packages libopenmpi-dev)
endif()
list(JOIN development_packages ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)

set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas, python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "talus, python3-xarray, python3-tqdm")

set(CPACK_DEBIAN_QGIS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_QGIS_PACKAGE_DEPENDS "talus (>= ${PROJECT_VERSION}), python3-qgis")

# The files that Debian asks for in every package.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, where it is set
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/changelog.Debian @ONLY CONTENT
"talus (@PROJECT_VERSION@-@CPACK_DEBIAN_PACKAGE_RELEASE@) stable; urgency=medium

  * Version @PROJECT_VERSION@. changelog.gz says what changed.

 -- @TALUS_PACKAGER@  @now@
")
set(licences "")
if(TALUS_SERVER)
  # Of the Apache License Debian wants a reference only.
  set(licences "&& gzip -dc ${CMAKE_BINARY_DIR}/web/licences.txt | sed \
'/^ *Apache License$/,/END OF TERMS AND CONDITIONS/c (its text is in /usr/share/common-licenses/Apache-2.0)'")
endif()
add_custom_command(
  OUTPUT ${shared}/copyright ${shared}/changelog.gz ${shared}/changelog.Debian.gz
  COMMAND sh -c "{ cat packaging/copyright NOTICE && echo ${licences}; } > ${shared}/copyright && \
gzip -9nc CHANGELOG.md > ${shared}/changelog.gz && \
gzip -9nc ${CMAKE_BINARY_DIR}/generated/changelog.Debian > ${shared}/changelog.Debian.gz"
  DEPENDS talus_cli packaging/copyright NOTICE CHANGELOG.md ${CMAKE_BINARY_DIR}/generated/changelog.Debian
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
  COMMENT "Writing copyright and changelogs of the packages"
  VERBATIM)
add_custom_target(talus_debian_files ALL DEPENDS ${shared}/copyright)

include(CPack)
