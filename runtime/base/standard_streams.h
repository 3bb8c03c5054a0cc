// The three streams that every process expects to have.
#pragma once

namespace aspect {

// To be called first: standard streams that the caller closed are given a file that only fails, so
// that no file opened later takes their place. SIGPIPE is ignored from then on: a reader that has
// gone is an error of the write.
void guard_standard_streams();

}  // namespace aspect
