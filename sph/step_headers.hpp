// What the headers of the step include of others. The files for wider instruction sets include it
// before the region that they compile for theirs: what the linker shares between files must run on
// every machine.
#pragma once

#include "simulation.hpp"
#include "step.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <omp.h>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>
