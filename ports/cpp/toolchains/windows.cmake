# Builds for Windows by Debian's MinGW-w64, g++-mingw-w64-x86-64, and runs the tests by Wine. With POSIX threads, because the
# other kind has no std::thread before GCC 13; without DLLs, because Windows does not have them.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
