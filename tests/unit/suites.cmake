# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Run after a test program is built: one test of ctest for every suite that the
# program lists, typed and parametrised ones with all their instances.
#
# cmake -D PROGRAM= -D OUTPUT= -D PREFIX= -D LABEL= -D TIMEOUT= -D LONG=A,B -P suites.cmake

cmake_minimum_required(VERSION 3.18)

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

string(REPLACE "," ";" long "${LONG}")
set(script "")
foreach(suite ${suites})
    set(instances ${names})
    list(FILTER instances INCLUDE REGEX "^${suite}(/[0-9]+)?$")
    list(TRANSFORM instances APPEND ".*")
    string(REPLACE ";" ":" filter "${instances}")
    set(cost 1)
    if(suite IN_LIST long)
        set(cost 100)
    endif()
    string(APPEND script "add_test([[${PREFIX}${suite}]] [[${PROGRAM}]] [[--gtest_filter=${filter}]])\n"
        "set_tests_properties([[${PREFIX}${suite}]] PROPERTIES LABELS ${LABEL} TIMEOUT ${TIMEOUT} "
        "COST ${cost} PROCESSOR_AFFINITY ON)\n")
endforeach()
file(WRITE ${OUTPUT} "${script}")
