# Lists a test executable's suites for CTest: one CTest test a suite, named "Suite (number of tests)", so that what a
# process needs to start (libraries, a context, compiled programs) is paid once a suite and the counts are seen.
#   cmake -DEXECUTABLE=... -DOUTPUT=... "-DPROPERTIES=NAME;VALUE;..." -P suites.cmake
execute_process(COMMAND "${EXECUTABLE}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${EXECUTABLE} --gtest_list_tests failed: ${code}\n${listed}")
endif()
string(REGEX REPLACE "#[^\n]*" "" listed "${listed}")  # parameter values; may hold anything
string(REPLACE ";" "," listed "${listed}")
string(REPLACE "\n" ";" lines "${listed}")

set(suites "")
foreach(line IN LISTS lines)
  string(STRIP "${line}" name)
  if(line MATCHES "^[^ ].*\\.[ ]*$")
    set(suite "${name}")
    list(APPEND suites "${suite}")
    set("count_${suite}" 0)
  elseif(line MATCHES "^  ")
    math(EXPR "count_${suite}" "${count_${suite}} + 1")
  endif()
endforeach()

cmake_policy(SET CMP0057 NEW)  # if(... IN_LIST ...)
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/slow_suites.txt" slow)
set(script "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "\\.$" "" title "${suite}")
  set(labels "")
  if(title IN_LIST slow)
    set(labels "LABELS slow")
  endif()
  set(title "${title} (${count_${suite}})")
  string(APPEND script "add_test([==[${title}]==] [==[${EXECUTABLE}]==] [==[--gtest_filter=${suite}*]==] --gtest_brief=1)\n"
    "set_tests_properties([==[${title}]==] PROPERTIES ${PROPERTIES} ${labels})\n")
endforeach()
file(WRITE "${OUTPUT}" "${script}")
