// The text of live_page.html, put into the program at build time.
#pragma once

#include <string_view>

namespace aspect {

extern const std::string_view kLivePageHtml;

}  // namespace aspect
