#include "commands.hpp"
namespace talus::cli { int verify(const VerifyOptions&) { return done; } }
