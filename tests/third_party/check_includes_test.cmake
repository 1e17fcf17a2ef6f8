# cmake -DCHECK=<check_includes.cmake> -DWORK=<empty folder> -P check_includes_test.cmake
# The rule that keeps the direction of the dependencies: an allowed include passes, each kind of wrong one fails.

function(expect outcome name include)
  file(REMOVE_RECURSE ${WORK})
  file(WRITE ${WORK}/lower/lower.h "#pragma once\n")
  file(WRITE ${WORK}/upper/upper.h "#pragma once\n")
  file(APPEND ${WORK}/lower/lower.h "${include}\n")
  file(WRITE ${WORK}/upper/upper.cpp "#include \"lower/lower.h\"\n#include \"upper/upper.h\"\n#include <vector>\n")
  file(WRITE ${WORK}/rules.txt "lower lower\nupper upper lower\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} -DRULES=${WORK}/rules.txt -P ${CHECK}
                  RESULT_VARIABLE status ERROR_VARIABLE text OUTPUT_QUIET)
  if(outcome STREQUAL "passes" AND NOT status EQUAL 0)
    message(FATAL_ERROR "${name}: should pass, but: ${text}")
  elseif(NOT outcome STREQUAL "passes" AND NOT text MATCHES "${outcome}")
    message(FATAL_ERROR "${name}: should say '${outcome}', but: ${text}")
  endif()
endfunction()

expect("passes" "only allowed includes" "#include <string>")
expect("lower/lower.h must not include upper" "against the direction" "#include \"upper/upper.h\"")
expect("not a path from the root" "a relative path" "#include \"lower.h\"")
