# 32-bit systems on BeagleBone Black (Cortex-A8) and Raspberry Pi 2 and later (Cortex-A7 and up).
# Debian's cross compiler looks into its own folders and then into /usr/include, where the
# header-only libraries are.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
set(CMAKE_STRIP arm-linux-gnueabihf-strip)
# Debian's own default, -mfpu=vfpv3-d16, leaves out NEON, which all of them have. Results stay those
# of IEEE 754: doubles and single floats are VFP's, and NEON, which flushes tiny floats to zero, is
# used by the compiler for whole numbers only as long as there is no -ffast-math.
# The notes about calls that another GCC compiled otherwise do not matter to static programs.
set(CMAKE_CXX_FLAGS_INIT "-march=armv7-a -mfpu=neon -mfloat-abi=hard -mthumb -Wno-psabi")
# Tests are linked dynamically, programs are not.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm-static -L /usr/arm-linux-gnueabihf)
# Nothing of the build machine's may be linked.
set(CMAKE_FIND_ROOT_PATH /usr/arm-linux-gnueabihf)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
