# Data files that are built into the library, so that a program needs no path to find them.
# mocap_resource(<function> <file> [<header>]): std::string <function>(), declared in the header, is the
# file's text. The file's path is absolute or from the package.
set(MOCAP_RESOURCE_SOURCES "")
function(mocap_resource function file)
  get_filename_component(path ${file} ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(READ ${path} RESOURCE_TEXT)
  set(RESOURCE_FUNCTION ${function})
  set(RESOURCE_HEADER resources/resources.h)
  if(ARGN)
    set(RESOURCE_HEADER ${ARGN})
  endif()
  set(source ${PROJECT_BINARY_DIR}/resources/${function}.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/resource.cpp.in ${source} @ONLY)
  set(MOCAP_RESOURCE_SOURCES ${MOCAP_RESOURCE_SOURCES} ${source} PARENT_SCOPE)
endfunction()
