# A compiler cache is used where there is one. A later clone in another folder finds what this one has compiled: paths
# below the source folder count as relative, and a precompiled header counts by the file .sum beside it, see below.
find_program(VITRINE_CCACHE ccache)
if(VITRINE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_PCH_EXTSUM=1 CCACHE_SLOPPINESS=pch_defines,time_macros ${VITRINE_CCACHE})
endif()

# What every target of this tree is compiled with: vitrine_options, linked PRIVATE by each.
add_library(vitrine_options INTERFACE)
target_include_directories(vitrine_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(vitrine_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow> -Wnon-virtual-dtor -Wold-style-cast
  -Wno-missing-field-initializers $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)  # designated initialisers leave out what keeps its default
# Headers precompiled once for all targets need the same macros in each: fmt's, and those of -pthread.
target_compile_options(vitrine_options INTERFACE -pthread)
target_link_libraries(vitrine_options INTERFACE fmt::fmt)
if(VITRINE_WERROR)
  target_compile_options(vitrine_options INTERFACE -Werror)
endif()
if(VITRINE_SANITIZE)
  target_compile_options(vitrine_options INTERFACE
    -fsanitize=${VITRINE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(vitrine_options INTERFACE -fsanitize=${VITRINE_SANITIZE})
  # Three checks stand at each access through a pointer or `this`, and make code that computes up to three times slower.
  # ASan ends on most of what they find, but not on misaligned accesses. Fuzzing, which reads foreign bytes, keeps them.
  if(VITRINE_SANITIZE MATCHES undefined AND NOT VITRINE_FUZZ)
    target_compile_options(vitrine_options INTERFACE -fno-sanitize=null,alignment,object-size)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")  # GCC defines these macros itself
    if(VITRINE_SANITIZE MATCHES address)
      target_compile_definitions(vitrine_options INTERFACE __SANITIZE_ADDRESS__)
    elseif(VITRINE_SANITIZE MATCHES thread)
      target_compile_definitions(vitrine_options INTERFACE __SANITIZE_THREAD__)
    endif()
  endif()
endif()

if(VITRINE_FUZZ)
  target_compile_options(vitrine_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# One set of precompiled headers for all targets, which are compiled with the same flags.
add_library(vitrine_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
target_link_libraries(vitrine_precompiled PRIVATE vitrine_options)
target_precompile_headers(vitrine_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)
# Two builds of the same header differ in their bytes. With this file beside it ccache tells them by what they are made
# of (CCACHE_PCH_EXTSUM in CMakePresets.json), so that a build in another folder finds what this one has compiled. Of
# clang's builds only one in a folder of the same path does: its arguments name the header by its absolute path.
file(SHA256 ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp precompiled_sum)
string(APPEND precompiled_sum " ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} fmt ${fmt_VERSION}\n")
foreach(ending gch pch)  # of gcc's and of clang's precompiled headers
  file(WRITE ${PROJECT_BINARY_DIR}/CMakeFiles/vitrine_precompiled.dir/cmake_pch.hxx.${ending}.sum "${precompiled_sum}")
endforeach()

# The outermost sources: tests, benchmarks, the command lines of the programs. In builds with sanitizers their own code
# is not optimised and is without UBSan: defects are looked for in the modules, which keep both. It compiles in a fifth
# of the time: 6 s instead of 33 s of CPU for the largest test.
add_library(vitrine_quick_options INTERFACE)
target_link_libraries(vitrine_quick_options INTERFACE vitrine_options)
set(VITRINE_QUICK_PRECOMPILED vitrine_precompiled)
if(VITRINE_SANITIZE)
  target_compile_options(vitrine_quick_options INTERFACE -O0 -fno-sanitize=undefined)
  set(VITRINE_QUICK_PRECOMPILED vitrine_quick_precompiled)
  add_library(vitrine_quick_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(vitrine_quick_precompiled PRIVATE vitrine_quick_options)
  target_precompile_headers(vitrine_quick_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)
  foreach(ending gch pch)
    file(WRITE ${PROJECT_BINARY_DIR}/CMakeFiles/vitrine_quick_precompiled.dir/cmake_pch.hxx.${ending}.sum
      "${precompiled_sum}")
  endforeach()
endif()

# A module is an object-like static library of one folder, named vitrine_<folder>.
# With WHOLE_FOLDER all other sources of the folder and its sub-folders follow those named: a new one needs no line.
# With WAITS the sources are not optimised in builds with sanitizers, and compile in two thirds of the time: for modules
# that wait for others more than they compute.
#   vitrine_module(base_geometry SOURCES a.cpp b.cpp USES vitrine::x PRIVATE_USES lib)
function(vitrine_module name)
  cmake_parse_arguments(arg "WHOLE_FOLDER;WAITS" "" "SOURCES;USES;PRIVATE_USES" ${ARGN})
  if(arg_WHOLE_FOLDER)
    file(GLOB_RECURSE others RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *.cpp)
    list(APPEND arg_SOURCES ${others})
    list(REMOVE_DUPLICATES arg_SOURCES)  # keeps the first of each
  endif()
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC ${arg_USES} PRIVATE vitrine_options ${arg_PRIVATE_USES})
  if(arg_WAITS AND VITRINE_SANITIZE)
    target_compile_options(${name} PRIVATE -O0)
    target_precompile_headers(${name} REUSE_FROM ${VITRINE_QUICK_PRECOMPILED})
  else()
    target_precompile_headers(${name} REUSE_FROM vitrine_precompiled)
  endif()
  if(VITRINE_UNITY)
    read_together(${name} ${arg_SOURCES})
  endif()
endfunction()

# Compiles a target's sources in batches, each as one source: the headers and what is made of templates come once a
# batch. No two sources of a batch declare the same file-local name.
function(read_together name)
  execute_process(COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/cmake/batches.py 1500 ${ARGN}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE batches COMMAND_ERROR_IS_FATAL ANY)
  foreach(batch IN LISTS batches)
    string(REPLACE "," ";" sources "${batch}")
    list(GET sources 0 first)
    set_source_files_properties(${sources} PROPERTIES UNITY_GROUP ${first})
  endforeach()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # vitrine_options leaves out -Wshadow here: file-local names of one source are hidden in others, which is no mistake.
  # GCC warns of types of unnamed namespaces where a batch includes their source.
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# A program that prints figures.
#   vitrine_bench(packing SOURCES packing.cpp moves.cpp USES player_layout)
function(vitrine_bench name)
  cmake_parse_arguments(arg "EXCLUDE_FROM_ALL" "" "SOURCES;USES" ${ARGN})
  if(VITRINE_SANITIZE)  # nobody measures with sanitizers; read all the same, so that they go with the tree
    add_library(${name} OBJECT ${arg_SOURCES})
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-emit-llvm -Xclang -disable-llvm-passes>)
  else()
    add_executable(${name} ${arg_SOURCES})
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ${arg_EXCLUDE_FROM_ALL})
  endif()
  target_link_libraries(${name} PRIVATE vitrine_quick_options ${arg_USES} fmt::fmt)
  target_precompile_headers(${name} REUSE_FROM ${VITRINE_QUICK_PRECOMPILED})
  if(VITRINE_UNITY)
    read_together(${name} ${arg_SOURCES})
  endif()
endfunction()

# A test file is one ctest test; all files of one call share an executable. Labels: unit, gl, media, pipeline,
# and beside them tsan for what has threads. Test cases of the doctest suite `real` read VITRINE_MEDIA. The files that
# hold some are named by REAL, too, and give a second test, real.FILE; with the label `real` a file holds nothing else.
# Without VITRINE_MEDIA ctest lists those tests as disabled.
#   vitrine_tests(layout_test LABEL unit tsan SOURCES energy_test.cpp cells_test.cpp USES player_layout)
function(vitrine_tests name)
  cmake_parse_arguments(arg "" "TIMEOUT" "LABEL;SOURCES;REAL;USES" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  add_executable(${name} ${arg_SOURCES} $<TARGET_OBJECTS:tests_main>)
  target_link_libraries(${name} PRIVATE vitrine_quick_options doctest::doctest ${arg_USES})
  target_precompile_headers(${name} REUSE_FROM ${VITRINE_QUICK_PRECOMPILED})
  if(VITRINE_UNITY)
    read_together(${name} ${arg_SOURCES})
  endif()
  foreach(source IN LISTS arg_SOURCES)
    get_filename_component(stem ${source} NAME_WE)
    set(tests "")
    if(NOT "real" IN_LIST arg_LABEL)
      add_test(NAME ${name}.${stem} COMMAND ${name} --source-file=*/${stem}.cpp --test-suite-exclude=real)
      set_tests_properties(${name}.${stem} PROPERTIES LABELS "${arg_LABEL}")
      list(APPEND tests ${name}.${stem})
    endif()
    if("real" IN_LIST arg_LABEL OR source IN_LIST arg_REAL)
      add_test(NAME real.${stem} COMMAND ${name} --source-file=*/${stem}.cpp --test-suite=real)
      set_tests_properties(real.${stem} PROPERTIES LABELS real DISABLED $<NOT:$<BOOL:${VITRINE_HAS_MEDIA}>>)
      list(APPEND tests real.${stem})
    endif()
    set_tests_properties(${tests} PROPERTIES TIMEOUT ${arg_TIMEOUT} ENVIRONMENT "${VITRINE_TEST_ENVIRONMENT}")
  endforeach()
  if("real" IN_LIST arg_LABEL OR arg_REAL)
    target_compile_definitions(${name} PRIVATE VITRINE_MEDIA="${VITRINE_MEDIA}")
  endif()
  if("tsan" IN_LIST arg_LABEL)
    set_property(GLOBAL APPEND PROPERTY VITRINE_TSAN_TARGETS ${name})
  endif()
endfunction()

if(IS_DIRECTORY ${VITRINE_MEDIA})
  set(VITRINE_HAS_MEDIA TRUE)
else()
  set(VITRINE_HAS_MEDIA FALSE)
endif()

# `intercept_tls_get_addr=0`: otherwise the search for leaks crashes now and then at the end of a test that passed.
# The sanitizer of clang 14 takes a library's thread-local block that happens to lie 16 bytes into a page for one of
# a glibc before 2.25, and reads its address and size from words that hold something else. With it, the sanitizer
# does not know these blocks and finds no pointers in them.
set(VITRINE_TEST_ENVIRONMENT
  "ASAN_OPTIONS=detect_leaks=1:detect_odr_violation=0:intercept_tls_get_addr=0"
  "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/lsan.supp:print_suppressions=0"
  "UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1"
  "TSAN_OPTIONS=halt_on_error=1:suppressions=${PROJECT_SOURCE_DIR}/tests/tsan.supp")
