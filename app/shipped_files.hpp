// The files that come with the program: those of an installed one, else those of the source tree
// that it was built from.
#pragma once

#include "command_line.hpp"

namespace meniscus {

/// The sample snapshots, by name; throws InputError where there are none.
std::vector<Path> sample_snapshots();

/// The folder of the scenes; throws InputError where there is none.
Path shipped_scenes();

/// The folder of the studies, each in a folder of its name; throws InputError where there is none.
Path shipped_studies();

/// The folder of the model files; throws InputError where there is none.
Path shipped_models();

} // namespace meniscus
