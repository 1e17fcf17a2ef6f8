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
find_package(octomap REQUIRED)
find_library(LZF_LIBRARY lzf REQUIRED)
find_package(BZip2 REQUIRED)
find_library(ZSTD_LIBRARY zstd REQUIRED)
find_library(POLYCLIPPING_LIBRARY polyclipping REQUIRED)
find_library(GOMP_LIBRARY NAMES libgomp.so.1 gomp REQUIRED)  # only to keep CHOLMOD from starting threads

# The system's BLAS (OpenBLAS, by packages.txt), loaded before all else: Debian's Ceres names ATLAS, which would
# otherwise serve CHOLMOD as well, three times slower.
find_library(BLAS_LIBRARY NAMES libblas.so REQUIRED)
add_library(system_blas INTERFACE)
target_link_options(system_blas INTERFACE
  "SHELL:-Wl,--push-state,--no-as-needed ${BLAS_LIBRARY} -Wl,--pop-state")

find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(suitesparse_cholmod INTERFACE)
target_include_directories(suitesparse_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE})
target_link_libraries(suitesparse_cholmod INTERFACE system_blas ${CHOLMOD_LIBRARY})

# Ceres as a shared library: the static one holds functions of Eigen that were built without AVX, and a program
# in which they meet ours frees with the one what the other has allocated.
find_package(Ceres 2.1 REQUIRED)
find_library(CERES_LIBRARY NAMES libceres.so REQUIRED)
find_library(GLOG_LIBRARY glog REQUIRED)
add_library(ceres_shared INTERFACE)
target_link_libraries(ceres_shared INTERFACE system_blas ${CERES_LIBRARY} ${GLOG_LIBRARY})

find_package(PkgConfig REQUIRED)
pkg_check_modules(CBC REQUIRED IMPORTED_TARGET cbc cgl osi-clp)


# Options that every translation unit shares.
add_library(ariadne_flags INTERFACE)
target_include_directories(ariadne_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(ariadne_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  $<$<BOOL:${ARIADNE_WERROR}>:-Werror>
  # gcc 12 sees Eigen's 4-wide path for a 3-vector, which is never taken, as out of bounds.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
  # A unity build includes .cpp files, and gcc takes what they hide for what a header would give away.
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
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

find_path(OMPL_INCLUDE ompl/config.h PATH_SUFFIXES ompl-1.5 REQUIRED)
find_library(OMPL_LIBRARY ompl REQUIRED)
add_library(ompl_shared INTERFACE)
target_include_directories(ompl_shared SYSTEM INTERFACE ${OMPL_INCLUDE})
target_link_libraries(ompl_shared INTERFACE ${OMPL_LIBRARY} Eigen3::Eigen Boost::headers)
