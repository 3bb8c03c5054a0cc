// What the page's script works with.
#pragma once

#include <string>

#include "tools/report/report_contents.h"

namespace aspect {

// One JSON object that may stand in an HTML script element. Numbers of the sphere's mesh are packed
// in base64: points as int16 of 32767ths, places as uint32, aspects as int16.
std::string report_json(const ReportContents& contents);

}  // namespace aspect
