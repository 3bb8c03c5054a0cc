# 64-bit ARM boards: Raspberry Pi Zero 2 W, 3, 4, 5. Debian's cross compiler looks into its own
# folders and then into /usr/include, where the header-only libraries are.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_STRIP aarch64-linux-gnu-strip)
# The least of them, Cortex-A53, is ARMv8-A without extensions.
set(CMAKE_CXX_FLAGS_INIT "-march=armv8-a")
# Tests are linked dynamically, programs are not.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L /usr/aarch64-linux-gnu)
# Nothing of the build machine's may be linked.
set(CMAKE_FIND_ROOT_PATH /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
