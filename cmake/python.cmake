# Looks for what the Python package needs: the system's interpreter, whose packages (numpy, pybind11) come from the
# distribution as well, even if another one comes first in PATH. Sets TALUS_PYTHON to whether the package is built.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The interpreter of the Python package")
endif()
set(Python_FIND_STRATEGY LOCATION)
find_package(Python 3.10 QUIET COMPONENTS Interpreter Development.Module NumPy)
find_package(pybind11 2.10 QUIET CONFIG)
set(has_python OFF)
if(Python_FOUND AND pybind11_FOUND AND NOT TALUS_SANITIZE MATCHES "thread")  # its reports would be about NumPy
  set(has_python ON)
endif()
option(TALUS_PYTHON "Build the Python package, with pybind11 and NumPy" ${has_python})
if(TALUS_PYTHON AND NOT has_python)
  message(FATAL_ERROR "The Python package needs Python 3.10, NumPy and pybind11 2.10. Install them (on Debian: python3-dev "
    "python3-numpy pybind11-dev), or build with -DTALUS_PYTHON=OFF")
endif()
