# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run after a test program is built: one test of ctest for every suite that the
# program lists, typed and parametrised ones with all their instances.
#
# cmake -D PROGRAM= -D OUTPUT= -D PREFIX= -D LABEL= -D TIMEOUT= -P suites.cmake

execute_process(COMMAND ${PROGRAM} --gtest_list_tests
    OUTPUT_VARIABLE listed RESULT_VARIABLE code TIMEOUT 60)
if(NOT code EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${code}\n${listed}")
endif()

# Lines such as "Suite.", "Suite/0.  # TypeParam = int", "Instance/Suite."
string(REGEX MATCHALL "(^|\n)[^ \n.]+\\." names "${listed}")
list(TRANSFORM names REPLACE "\n|\\." "")
set(suites ${names})
list(TRANSFORM suites REPLACE "/[0-9]+$" "")
list(REMOVE_DUPLICATES suites)

set(script "")
foreach(suite ${suites})
    set(instances ${names})
    list(FILTER instances INCLUDE REGEX "^${suite}(/[0-9]+)?$")
    list(TRANSFORM instances APPEND ".*")
    string(REPLACE ";" ":" filter "${instances}")
    string(APPEND script "add_test([[${PREFIX}${suite}]] [[${PROGRAM}]] [[--gtest_filter=${filter}]])\n"
        "set_tests_properties([[${PREFIX}${suite}]] PROPERTIES LABELS ${LABEL} TIMEOUT ${TIMEOUT})\n")
endforeach()
file(WRITE ${OUTPUT} "${script}")
