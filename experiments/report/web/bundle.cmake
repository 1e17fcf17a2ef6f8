# The 3D view of report.html: packages of npm, exactly those of package-lock.json, installed into the build tree
# without running scripts of theirs, and bundled into one C++ file. Without npm, or without its packages, the
# program is built without the view, and its pages say so.
set(web ${CMAKE_CURRENT_LIST_DIR})
set(web_build ${PROJECT_BINARY_DIR}/web)
set(viewer_bundle ${PROJECT_BINARY_DIR}/generated/viewer_bundle.cpp)
file(SHA256 ${web}/package-lock.json lock_hash)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${web}/package.json ${web}/package-lock.json)

find_program(ARIADNE_NPM npm)
find_program(ARIADNE_NODE NAMES node nodejs)
set(ARIADNE_VIEWER OFF)
if(ARIADNE_NPM AND ARIADNE_NODE)
  if(EXISTS ${web_build}/installed-${lock_hash})
    set(ARIADNE_VIEWER ON)
  else()
    file(COPY ${web}/package.json ${web}/package-lock.json DESTINATION ${web_build})
    execute_process(COMMAND ${ARIADNE_NPM} ci --ignore-scripts --no-audit --no-fund
                    WORKING_DIRECTORY ${web_build} RESULT_VARIABLE npm_failed OUTPUT_QUIET ERROR_VARIABLE npm_error)
    if(npm_failed)
      message(WARNING "npm cannot install the packages of the 3D view; report.html will have none\n${npm_error}")
    else()
      file(TOUCH ${web_build}/installed-${lock_hash})
      set(ARIADNE_VIEWER ON)
    endif()
  endif()
else()
  message(STATUS "npm is not installed: report.html will have no 3D view")
endif()

if(ARIADNE_VIEWER)
  file(GLOB viewer_sources CONFIGURE_DEPENDS ${web}/src/*)
  add_custom_command(OUTPUT ${viewer_bundle}
    COMMAND ${ARIADNE_NODE} ${web}/bundle.mjs ${web_build} ${viewer_bundle}
    DEPENDS ${viewer_sources} ${web}/bundle.mjs ${web_build}/installed-${lock_hash}
    COMMENT "Bundling the 3D view")
else()
  set(viewer_bundle ${PROJECT_BINARY_DIR}/generated/no_viewer_bundle.cpp)
  file(CONFIGURE OUTPUT ${viewer_bundle} CONTENT [[
#include "experiments/report/viewer_bundle.h"

std::span<const std::string_view> ariadne::experiments::ViewerBundle() { return {}; }
]])
endif()
target_sources(ariadne_experiments_report PRIVATE ${viewer_bundle})
set_source_files_properties(${viewer_bundle} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
