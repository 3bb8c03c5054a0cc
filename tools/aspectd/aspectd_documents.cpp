// Writes the manual page and the completions of aspectd; the build runs it, and a board never.
#include <cstdio>
#include <exception>

#include "tools/aspectd/aspectd_command.h"
#include "tools/command_line/documents.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("aspectd_documents: give the folder to write to\n", stderr);
    return 2;
  }
  try {
    aspect::write_documents(aspect::aspectd_command(), argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aspectd_documents: %s\n", error.what());
    return 1;
  }
}
