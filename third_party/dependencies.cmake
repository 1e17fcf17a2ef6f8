# How each dependency is found. All come from Debian (third_party/packages.txt); none is vendored.

find_program(ARIADNE_CCACHE ccache)
if(ARIADNE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ARIADNE_CCACHE})
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)  # headers: Boost.Math
find_package(fmt REQUIRED)
find_package(nanoflann REQUIRED)
find_package(TBB REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenSSL REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)
find_package(tsl-robin-map REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(assimp REQUIRED)
find_package(GTest REQUIRED)
find_library(LZF_LIBRARY lzf REQUIRED)
find_library(GOMP_LIBRARY NAMES libgomp.so.1 gomp REQUIRED)  # only to keep CHOLMOD from starting threads
find_package(Ceres 2.1 REQUIRED)

find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(suitesparse_cholmod INTERFACE)
target_include_directories(suitesparse_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE})
target_link_libraries(suitesparse_cholmod INTERFACE ${CHOLMOD_LIBRARY})

find_path(SPECTRA_INCLUDE Spectra/SymEigsSolver.h REQUIRED)  # headers

# Options that every translation unit shares.
add_library(ariadne_flags INTERFACE)
target_include_directories(ariadne_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(ariadne_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  $<$<BOOL:${ARIADNE_WERROR}>:-Werror>
  # gcc 12 sees Eigen's 4-wide path for a 3-vector, which is never taken, as out of bounds.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
  # Without contraction a*b+c is rounded the same way in every function that writes it, so brute force
  # and k-d tree find identical distances, and a debug build the same bytes as a release build.
  -ffp-contract=off)
# Debian's libraries are built for the baseline instruction set and exchange Eigen types with us: keep
# their alignment, whatever -march says.
target_compile_definitions(ariadne_flags INTERFACE EIGEN_MAX_ALIGN_BYTES=16)

if(NOT ARIADNE_ARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(ARIADNE_ARCH x86-64-v3)
endif()
if(ARIADNE_ARCH)
  target_compile_options(ariadne_flags INTERFACE -march=${ARIADNE_ARCH})
endif()
