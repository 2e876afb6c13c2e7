# Builds for the roboRIO (a Cortex-A9 whose calls pass floats as integers) by Debian's compiler, g++-arm-linux-gnueabi, and
# runs the tests by qemu-user-static. Without GCC's notes that it passes some arguments otherwise than before version 7.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(CMAKE_CXX_COMPILER arm-linux-gnueabi-g++)
set(CMAKE_CXX_FLAGS_INIT "-mcpu=cortex-a9 -mfpu=vfpv3 -mfloat-abi=softfp -Wno-psabi")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-arm-static -L /usr/arm-linux-gnueabi)
