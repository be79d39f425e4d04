# Data files that are built into the library, so that a program needs no path to find them.
# mocap_resource(<function> <file>): std::string <function>() is the file's text.
set(MOCAP_RESOURCE_SOURCES "")
function(mocap_resource function file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
  file(READ ${PROJECT_SOURCE_DIR}/${file} RESOURCE_TEXT)
  set(RESOURCE_FUNCTION ${function})
  set(source ${PROJECT_BINARY_DIR}/resources/${function}.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/resource.cpp.in ${source} @ONLY)
  set(MOCAP_RESOURCE_SOURCES ${MOCAP_RESOURCE_SOURCES} ${source} PARENT_SCOPE)
endfunction()
