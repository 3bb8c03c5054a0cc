// What the word for an option's value says of it, for completion: the word is what people read in
// --help, so that it must be right anyway.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aspect {

// "auto|always|never" is one of these words; FILE.svg, TRUTH.csv, FILE.b|FILE.toml, and SCENE
// are files with these endings; FILE and FRAME any file, FOLDER is a folder. All else is free.
struct ValueWords {
  std::vector<std::string> choices;
  std::vector<std::string> endings;  // without the dot
  bool is_file = false;              // of any name where there are no endings; or a folder's
  bool is_folder = false;
};

ValueWords value_words(std::string_view value);

}  // namespace aspect
