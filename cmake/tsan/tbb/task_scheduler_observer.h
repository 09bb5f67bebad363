#pragma once
#include "talus_threads.hpp"
