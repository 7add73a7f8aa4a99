# The web pages' script and style, bundled and embedded.
set(bundle ${PROJECT_BINARY_DIR}/web)
file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS reports/web/src/*)
add_custom_command(
  OUTPUT ${bundle}/cylon.js ${bundle}/cylon.css ${bundle}/csp.txt
  COMMAND ${PROJECT_SOURCE_DIR}/cmake/web_bundle.sh ${bundle}
  DEPENDS ${web_sources} reports/web/package.json reports/web/package-lock.json reports/web/tsconfig.json
          reports/web/build.mjs cmake/web_bundle.sh
  COMMENT "Bundling the web pages" VERBATIM)
add_library(web_bundle STATIC reports/web/embed.cc ${bundle}/cylon.js)
declare(web_bundle KIND layer PLACES reports/web/ reports/web_bundle.h)
set_source_files_properties(reports/web/embed.cc PROPERTIES
  OBJECT_DEPENDS "${bundle}/cylon.js;${bundle}/cylon.css;${bundle}/csp.txt")
target_compile_definitions(web_bundle PRIVATE CYLON_WEB_BUNDLE="${bundle}")
target_include_directories(web_bundle PUBLIC ${PROJECT_SOURCE_DIR})
target_link_libraries(web_bundle PRIVATE warnings)
