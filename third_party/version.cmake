# cmake -DROOT=<source root> -DOUT=<header> -P version.cmake
# Writes the commit of the sources into a header, and only touches it when that changes.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND git -C ${ROOT} rev-parse HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
                ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit "unknown")
endif()
execute_process(COMMAND git -C ${ROOT} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
if(changes)
  set(dirty true)
else()
  set(dirty false)
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT
"#pragma once

namespace ariadne {
inline constexpr const char* kCommit = \"@commit@\";
inline constexpr bool kDirty = @dirty@;  // the sources differ from the commit
}  // namespace ariadne
" @ONLY)
