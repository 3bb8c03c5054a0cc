// The command line of aspectd: its help and its manual page. Without CLI11, which is heavy.
#pragma once

#include "tools/command_line/command_text.h"

namespace aspect {

CommandText aspectd_command();

}  // namespace aspect
