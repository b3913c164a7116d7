// What windows.h does to whoever includes it first. The standard library undefines these macros
// where it is included for the first time, so all of it that the runtime includes comes before.
#include <algorithm>
#include <array>
#include <atomic>
#include <cfenv>
#include <cfloat>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))

#include "all_headers.hpp"

#if !defined(min) || !defined(max)
#error "a header undefined the macros, so that this tests nothing"
#endif
