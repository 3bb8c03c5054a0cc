// The camera.toml of a set of frames, as its tools write it, for programs that link no runtime.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace aspect {

// Its lines KEY = NUMBER.
inline std::map<std::string, double> camera_table(const std::string& file) {
  std::map<std::string, double> values;
  std::ifstream in(file);
  std::string key, equals;
  for (std::string line; std::getline(in, line);) {
    std::stringstream words(line);
    double value = 0;
    if (words >> key >> equals >> value) values[key] = value;
  }
  return values;
}

}  // namespace aspect
