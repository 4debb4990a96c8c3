# How this project's targets are made.

set(BIMODAL_SANITIZE "" CACHE STRING "Comma-separated sanitizers: address,undefined or thread")
option(BIMODAL_WERROR "Treat warnings as errors" OFF)

find_program(BIMODAL_CCACHE ccache)
if(BIMODAL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${BIMODAL_CCACHE})
endif()

# How we compile our own code; never applied to, nor exported to, third parties.
add_library(bimodal_options INTERFACE)
target_include_directories(bimodal_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(bimodal_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion
  -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  -Wno-missing-field-initializers  # designated initializers leave the rest at its default on purpose
  $<$<BOOL:${BIMODAL_WERROR}>:-Werror>)
if(BIMODAL_SANITIZE)
  target_compile_options(bimodal_options INTERFACE
    -fsanitize=${BIMODAL_SANITIZE} -fno-omit-frame-pointer
    # Checked at every access, these two double the time of compiling; the address sanitizer
    # stops at a null pointer as well, and x86 and ARM read what is not aligned.
    -fno-sanitize=null,alignment
    -Wno-maybe-uninitialized)  # GCC 12 imagines it where a sanitizer has changed the code
  target_link_options(bimodal_options INTERFACE -fsanitize=${BIMODAL_SANITIZE})
endif()

# bimodal_precompiled(<name> <options> <header>...) compiles what most sources include once for all
# targets that say REUSE_FROM <name>.
function(bimodal_precompiled name options)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE bimodal_options ${options})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# The programs' sources only where a sanitizer compiles them once more. The commands of the release
# build are read by clang-tidy, which cannot read GCC's precompiled headers; there a missing #include
# is to be an error, and GCC 12 optimises with false alarms about what was precompiled. The tests'
# sources everywhere.
if(BIMODAL_SANITIZE)
  bimodal_precompiled(bimodal_precompiled fmt::fmt
    <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <set> <span>
    <string> <string_view> <vector> <fmt/format.h>)
endif()

function(bimodal_reuse_precompiled target)
  if(BIMODAL_SANITIZE)
    target_precompile_headers(${target} REUSE_FROM bimodal_precompiled)
  endif()
endfunction()

# bimodal_library(<name> <folder> PUBLIC ... PRIVATE ...) makes bimodal_<name>, alias bimodal::<name>,
# from every source file directly or indirectly in <folder>.
function(bimodal_library name folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "PUBLIC;PRIVATE")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  if(sources)
    add_library(bimodal_${name} STATIC ${sources})
    target_link_libraries(bimodal_${name} PUBLIC bimodal_options ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    bimodal_reuse_precompiled(bimodal_${name})
  else()  # headers only
    add_library(bimodal_${name} INTERFACE)
    target_link_libraries(bimodal_${name} INTERFACE bimodal_options ${arg_PUBLIC})
  endif()
  add_library(bimodal::${name} ALIAS bimodal_${name})
endfunction()

# bimodal_program(<name> <folder> <library>...) makes bin/<name>; all of <folder> except main.cpp is
# the library bimodal_<name>_verbs, so that tests can call the verbs.
function(bimodal_program name folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/${folder}/main.cpp)
  if(sources)
    add_library(bimodal_${name}_verbs STATIC ${sources})
    target_link_libraries(bimodal_${name}_verbs PUBLIC bimodal_options ${ARGN})
    bimodal_reuse_precompiled(bimodal_${name}_verbs)
    add_executable(${name} ${PROJECT_SOURCE_DIR}/${folder}/main.cpp)
    target_link_libraries(${name} PRIVATE bimodal_${name}_verbs)
    set_target_properties(${name} PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  endif()
endfunction()

# Festival has neither a CMake package nor a pkg-config file; its libraries are static on Debian.
function(bimodal_find_festival)
  find_path(FESTIVAL_INCLUDE festival/festival.h REQUIRED)
  find_path(SPEECH_TOOLS_INCLUDE speech_tools/EST.h REQUIRED)
  add_library(festival INTERFACE)
  target_include_directories(festival SYSTEM INTERFACE
    ${FESTIVAL_INCLUDE}/festival ${SPEECH_TOOLS_INCLUDE}/speech_tools)
  foreach(library Festival estools estbase eststring)
    find_library(FESTIVAL_${library} ${library} REQUIRED)
    target_link_libraries(festival INTERFACE ${FESTIVAL_${library}})
  endforeach()
endfunction()
