# ariadne_module(<folder> USES <folders> LINKS <libraries>)
#
# Makes one static library of the .cpp files of a folder (an interface library where there are none), and
# declares which other folders it may include. The declaration is also a rule: the target check_includes
# fails the build where a file includes a folder that its own does not use, directly or through another.
set_property(GLOBAL PROPERTY ARIADNE_MODULES "")

function(ariadne_module folder)
  cmake_parse_arguments(ARG "" "" "USES;LINKS" ${ARGN})
  string(REPLACE "/" "_" target "ariadne_${folder}")
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_link_libraries(${target} ${scope} ariadne_flags ${ARG_LINKS})
  foreach(used IN LISTS ARG_USES)
    string(REPLACE "/" "_" used_target "ariadne_${used}")
    target_link_libraries(${target} ${scope} ${used_target})
  endforeach()

  set_property(GLOBAL APPEND PROPERTY ARIADNE_MODULES ${folder})
  set(visible ${folder})
  foreach(used IN LISTS ARG_USES)
    get_property(seen_by_used GLOBAL PROPERTY ARIADNE_VISIBLE_${used})
    if(NOT seen_by_used)
      message(FATAL_ERROR "${folder} uses ${used}, which is not declared before it")
    endif()
    list(APPEND visible ${seen_by_used})
  endforeach()
  list(REMOVE_DUPLICATES visible)
  set_property(GLOBAL PROPERTY ARIADNE_VISIBLE_${folder} "${visible}")
endfunction()

# Writes the rules down and adds the check to every build.
function(ariadne_check_includes)
  get_property(modules GLOBAL PROPERTY ARIADNE_MODULES)
  set(rules "")
  set(files "")
  foreach(folder IN LISTS modules)
    get_property(visible GLOBAL PROPERTY ARIADNE_VISIBLE_${folder})
    list(JOIN visible " " visible)
    string(APPEND rules "${folder} ${visible}\n")
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
    list(APPEND files ${sources})
  endforeach()
  file(WRITE ${PROJECT_BINARY_DIR}/include_rules.txt "${rules}")
  add_custom_command(
    OUTPUT ${PROJECT_BINARY_DIR}/include_rules.checked
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DRULES=${PROJECT_BINARY_DIR}/include_rules.txt
            -P ${PROJECT_SOURCE_DIR}/third_party/check_includes.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/include_rules.checked
    DEPENDS ${files} ${PROJECT_BINARY_DIR}/include_rules.txt ${PROJECT_SOURCE_DIR}/third_party/check_includes.cmake
    COMMENT "Checking that includes follow the direction of the dependencies")
  add_custom_target(check_includes ALL DEPENDS ${PROJECT_BINARY_DIR}/include_rules.checked)
endfunction()
