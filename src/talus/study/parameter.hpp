#pragma once
// The numbers of a project that a study varies, under the names of this room.

#include "talus/project/parameter.hpp"

namespace talus::study {

using project::Prior;
using project::SettingNumber;

}  // namespace talus::study
