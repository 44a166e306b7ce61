# SPDX-License-Identifier: MIT
# Writes SCRIPT, which tells ctest of one test for each source file of the GoogleTest program
# PROGRAM, named after it: core/tree/light_tree runs all of tests/core/tree/light_tree_test.cpp in
# one process. TESTS: the folder tests; PROPERTIES: of each, as set_tests_properties() takes them;
# LONG: regular expression of those that take long and start first, so that no core waits for them.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_output=json:${SCRIPT}.json
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${SCRIPT}.json lines REGEX "^ *\"(name|file)\":")

set(files "")
set(found 0)
set(name "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^ *\"[a-z]+\": \"(.*)\",?$" "\\1" value "${line}")
  string(REPLACE "\\/" "/" value "${value}")
  if(line MATCHES "^ *\"name\"")
    # A name that no file follows is that of a suite, whose tests follow.
    if(name)
      set(suite "${name}")
    endif()
    set(name "${value}")
  else()
    file(REAL_PATH "${value}" file BASE_DIRECTORY ${BUILD})
    file(RELATIVE_PATH file ${TESTS} ${file})
    string(REGEX REPLACE "(_test)?\\.[a-z]+$" "" file ${file})
    list(APPEND files ${file})
    list(APPEND "tests of ${file}" "${suite}.${name}")
    math(EXPR found "${found} + 1")
    set(name "")
  endif()
endforeach()

file(READ ${SCRIPT}.json json)
string(JSON expected GET "${json}" tests)
if(NOT found EQUAL expected)
  message(FATAL_ERROR "${PROGRAM} has ${expected} tests, of which ${found} were found")
endif()

set(script "")
list(REMOVE_DUPLICATES files)
foreach(file IN LISTS files)
  list(JOIN "tests of ${file}" : filter)
  set(cost 1)
  if(file MATCHES "${LONG}")
    set(cost 100)
  endif()
  string(APPEND script
    "add_test([=[${file}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${filter}]=])\n"
    "set_tests_properties([=[${file}]=] PROPERTIES COST ${cost} ${PROPERTIES})\n")
endforeach()
file(WRITE ${SCRIPT} "${script}")
