#!/bin/sh
set -eu
cmake -S . -B build -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DTALUS_TESTS=OFF -DTALUS_SERVER=OFF -DTALUS_MPI=OFF -DTALUS_PACKAGES=OFF -DTALUS_UNITY=ON \
  -DTALUS_PYTHON=ON -DPython_EXECUTABLE="$PYTHON" -DTALUS_PYTHON_DIR="$SP_DIR" \
  -DRANDOM123_INCLUDE="$SRC_DIR/random123/include"
cmake --build build
for component in program python; do
  cmake --install build --component $component
done
