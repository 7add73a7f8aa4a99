# What CMake knows of the layers, written to layers.json for tests/layering_test.py.

# json_list(out values…): ["a", "b"].
function(json_list out)
  list(TRANSFORM ARGN REPLACE "(.+)" "\"\\1\"")
  list(JOIN ARGN ", " joined)
  set(${out} "[${joined}]" PARENT_SCOPE)
endfunction()

# declare(name KIND kind PLACES folders/ or files… PUBLIC … PRIVATE …): who owns these sources, and what they may include.
# What is PUBLIC, whoever uses this layer may include as well.
function(declare name)
  cmake_parse_arguments(ARG "" "KIND" "PLACES;PUBLIC;PRIVATE" ${ARGN})
  json_list(places ${ARG_PLACES})
  json_list(public ${ARG_PUBLIC})
  json_list(private ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY cylon_declared_layers
    "{\"name\": \"${name}\", \"kind\": \"${ARG_KIND}\", \"places\": ${places}, \"public\": ${public}, \"private\": ${private}}")
endfunction()

# headers_of(library regex): a header whose name begins so is this library's.
function(headers_of library headers)
  set_property(GLOBAL APPEND PROPERTY cylon_declared_headers "{\"library\": \"${library}\", \"headers\": \"${headers}\"}")
endfunction()

# headers_in(library folders…): the headers in these folders are this engine's, with or without the folder's name.
function(headers_in library)
  json_list(folders ${ARGN})
  set_property(GLOBAL APPEND PROPERTY cylon_declared_engines "{\"library\": \"${library}\", \"folders\": ${folders}}")
endfunction()

# forbids(files header): a rule finer than a layer; no such file reaches the header, through others neither.
function(forbids files header)
  set_property(GLOBAL APPEND PROPERTY cylon_declared_forbidden "{\"files\": \"${files}\", \"header\": \"${header}\"}")
endfunction()

function(write_declared)
  set(members "")
  foreach(member layers headers engines forbidden)
    get_property(rows GLOBAL PROPERTY cylon_declared_${member})
    list(JOIN rows ",\n    " rows)
    list(APPEND members "  \"${member}\": [\n    ${rows}\n  ]")
  endforeach()
  list(JOIN members ",\n" members)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/layers.json CONTENT "{\n${members}\n}\n" @ONLY)
endfunction()
