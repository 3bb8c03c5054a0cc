// The files of the page, put into the program at build time.
#pragma once

#include <span>
#include <string_view>

namespace aspect {

struct PageFile {
  std::string_view path;  // as asked for, "/page.css"
  std::string_view type;
  std::string_view text;
};

std::span<const PageFile> page_files();

}  // namespace aspect
