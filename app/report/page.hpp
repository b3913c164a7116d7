// The page that reports are put into, as page/build.js bundles it: page.html, made part of the
// program by CMake.
#pragma once

#include <string_view>

namespace meniscus {

/// The page with `{"meniscus":"report"}` once where its data belong.
std::string_view report_page_template();

} // namespace meniscus
