#pragma once
// How GDAL takes handlers of file systems, which changed between its versions. Tried with GDAL 3.6 and 3.13; the
// changes between them, in Open (3.12), Rename (3.11) and the ownership of handlers (3.13), are those of the headers
// of 3.11 and 3.12.

#include <cpl_vsi_virtual.h>
#include <gdal_version.h>

#include <memory>
#include <string>
#include <utility>

namespace talus {

/// What Open returns: a pointer, since GDAL 3.12 a unique one.
using OpenedByGdal = decltype(std::declval<VSIFilesystemHandler&>().Open("", "", true, nullptr));

/// Takes the place of the handler of a prefix, which remains usable until the program ends.
void install_gdal_handler(const std::string& prefix, std::unique_ptr<VSIFilesystemHandler> handler);

}  // namespace talus
