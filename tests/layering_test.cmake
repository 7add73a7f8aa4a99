# Fails when a file includes what its layer must not know.  Run: cmake -DROOT=<repo> -P tests/layering_test.cmake
# Debian keeps every library's headers in one folder, so that the link graph alone stops none of them.
cmake_minimum_required(VERSION 3.25)

# ---- Libraries, by their headers; a header of none of these is the standard library's --------------
set(lib_Eigen     "^Eigen/")
set(lib_fmt       "^fmt/")
set(lib_json      "^nlohmann/")
set(lib_toml      "^toml[+][+]/")
set(lib_obj       "^tiny_?obj_?loader")
set(lib_boost     "^boost/")
set(lib_flint     "^(flint/|arb|acb|mag[.]h)")
set(lib_tbb       "^(tbb|oneapi)/")
set(lib_cli11     "^CLI/")
set(lib_sqlite    "^sqlite3")
set(lib_httplib   "^httplib")
set(lib_gtest     "^(gtest|gmock)/")
set(lib_benchmark "^benchmark/")
set(lib_bullet    "^(bullet/|bt[A-Z]|Bullet|LinearMath/)")
set(lib_ode       "^(ode/|ode[.]h|drawstuff/)")
set(lib_others    "^(mujoco/|dart/|Simbody|simbody/|SimTK|Jolt/|PxPhysics|rapier)")
set(libraries Eigen fmt json toml obj boost flint tbb cli11 sqlite httplib gtest benchmark bullet ode others)

# ---- The build graph: row(files MAY what of ours, NEVER among that, USES libraries) ------------------
# The first row that matches a file judges it; a file that matches none is an error as well.
set(rows 0)
function(row files)
  cmake_parse_arguments(ARG "" "MAY;NEVER" "USES" ${ARGN})
  set(row_${rows}_files "${files}" PARENT_SCOPE)
  set(row_${rows}_may "${ARG_MAY}" PARENT_SCOPE)
  set(row_${rows}_never "${ARG_NEVER}" PARENT_SCOPE)
  set(row_${rows}_uses "${ARG_USES}" PARENT_SCOPE)
  math(EXPR rows "${rows} + 1")
  set(rows ${rows} PARENT_SCOPE)
endfunction()

# 1. The subject does not know that it is examined.
row("^engine/" MAY "^engine/" USES Eigen tbb)
# 6. A verdict knows numbers alone.
row("^harness/core/verdict" MAY "^harness/core/verdict[.]h$" USES fmt)
# 8. A tolerance does not know the run that it judges.
row("^harness/core/claim" MAY "^harness/core/" NEVER "/(simulator|recording|measure)[.]h$" USES Eigen fmt)
# 5. No engine is asked for its own energy.
row("^harness/core/(observable|measure|gap|event)" MAY "^harness/core/" NEVER "/simulator[.]h$" USES Eigen fmt)
row("^harness/core/" MAY "^harness/core/" USES Eigen fmt)
row("^harness/process/" MAY "^harness/(process|core)/" USES Eigen fmt json)
row("^harness/statistics/" MAY "^harness/statistics/" USES boost)
row("^harness/study/" MAY "^(harness/(study|process|core|statistics)|scenarios)/" USES Eigen fmt json)
row("^harness/view/" MAY "^((harness/(view|process|core)|scenarios)/|reports/web_bundle[.]h$)" USES Eigen fmt json httplib)
row("^harness/cli/" MAY "^(harness|scenarios|reports|reference/certified)/" USES Eigen fmt json cli11)
# 2. An oracle that shares code with its subject is no oracle.
row("^reference/exact/" MAY "^(reference/exact|harness/core)/" NEVER "/(simulator|recording)[.]h$"
    USES Eigen fmt boost flint)
row("^reference/certified/" MAY "^(reference/certified|harness/core)/" NEVER "/(simulator|recording)[.]h$"
    USES Eigen fmt flint)
# 3, 7. An adapter gets a Scene, never the exam, and knows no other adapter.  A foreign header stays in the
# adapter's sources <engine>.cc, <engine>_*.cc and their private headers <engine>_*.h.
row("^reference/simulators/in_house[._]" MAY "^(reference/simulators/in_house[._]|harness/core/|engine/)"
    USES Eigen fmt)
row("^reference/simulators/bullet([.]cc|_)" MAY "^(reference/simulators/bullet[._]|harness/core/)"
    USES Eigen fmt bullet)
row("^reference/simulators/ode([.]cc|_)" MAY "^(reference/simulators/ode[._]|harness/core/)" USES Eigen fmt ode)
row("^reference/simulators/" MAY "^harness/core/" USES Eigen fmt)
row("^reference/workers/" MAY "^harness/(process|core)/" USES Eigen fmt json)
# 4. A scenario never says who runs it.
row("^scenarios/" MAY "^(scenarios|reference/(exact|certified)|harness/core)/" NEVER "/simulator[.]h$"
    USES Eigen fmt json toml obj)
# 6. A report is rebuilt from stored rows without simulating.
row("^reports/" MAY "^(reports|harness/core)/" NEVER "/simulator[.]h$" USES Eigen fmt json sqlite)
# Nothing depends on these; even they leave a foreign engine, and what an adapter has private, to the adapter.
row("^(tests|bench)/" MAY "^(engine|harness|reference|scenarios|reports|tests|bench)/"
    NEVER "^reference/simulators/(bullet|ode)_"
    USES Eigen fmt json toml obj boost flint tbb cli11 sqlite httplib gtest benchmark)

# Sets `out` to what is wrong with a line of a file, or to "".
function(judge file line out)
  set(${out} "" PARENT_SCOPE)
  if(NOT line MATCHES "^[ \t]*#[ \t]*include[ \t]*([<\"])([^>\"]+)")
    return()
  endif()
  set(quote "${CMAKE_MATCH_1}")
  set(header "${CMAKE_MATCH_2}")
  math(EXPR last "${rows} - 1")
  foreach(n RANGE ${last})
    if(file MATCHES "${row_${n}_files}")
      foreach(library ${libraries})
        if(header MATCHES "${lib_${library}}")
          if(NOT library IN_LIST row_${n}_uses)
            set(${out} "${file} must not use ${library}: ${header}" PARENT_SCOPE)
          endif()
          return()
        endif()
      endforeach()
      set(ours FALSE)
      if(quote STREQUAL "\"" OR header MATCHES "^(engine|harness|reference|scenarios|reports|tests|bench)/")
        set(ours TRUE)
      endif()
      if(ours AND NOT header MATCHES "${row_${n}_may}")
        set(${out} "${file} must not know ${header}" PARENT_SCOPE)
      elseif(ours AND row_${n}_never AND header MATCHES "${row_${n}_never}")
        set(${out} "${file} must not know ${header}" PARENT_SCOPE)
      endif()
      return()
    endif()
  endforeach()
  set(${out} "${file} is in no layer" PARENT_SCOPE)
endfunction()

# ---- Negative controls, on every run: a rule that catches nothing is no rule ------------------------
function(must_refuse file header)
  judge("${file}" "#include ${header}" wrong)
  if(NOT wrong)
    message(SEND_ERROR "the test is blind: it lets ${file} include ${header}")
  endif()
endfunction()
function(must_allow file header)
  judge("${file}" "#include ${header}" wrong)
  if(wrong)
    message(SEND_ERROR "the test is too strict: ${wrong}")
  endif()
endfunction()

must_refuse("engine/world.cc" "\"harness/core/scene.h\"")                              # 1
must_refuse("engine/world.cc" "<harness/core/scene.h>")                                # 1, in other quotes
must_refuse("engine/world.cc" "<fmt/format.h>")                                        # 1, by a library
must_refuse("engine/world.cc" "\"../harness/core/scene.h\"")                           # 1, by a relative path
must_refuse("reference/exact/heavy_top.cc" "\"engine/world.h\"")                       # 2
must_refuse("reference/exact/heavy_top.cc" "\"reference/simulators/in_house.h\"")      # 2
must_refuse("reference/simulators/ode/ode.cc" "\"scenarios/loader.h\"")                    # 3
must_refuse("reference/simulators/in_house/in_house.cc" "\"reference/exact/heavy_top.h\"")      # 3
must_refuse("reference/workers/main.cc" "\"scenarios/loader.h\"")                      # 3
must_refuse("reference/workers/main.cc" "\"reference/exact/catalogue.h\"")             # 3
must_refuse("scenarios/loader.cc" "\"engine/world.h\"")                                # 4
must_refuse("scenarios/loader.cc" "\"reference/simulators/ode.h\"")                    # 4
must_refuse("harness/core/observable.cc" "\"harness/core/simulator.h\"")               # 5
must_refuse("harness/core/measure.h" "\"harness/core/simulator.h\"")                   # 5
must_refuse("harness/results/verdict.cc" "\"harness/core/scene.h\"")                      # 6
must_refuse("reports/html.cc" "\"harness/process/worker.h\"")                          # 6
must_refuse("reports/html.cc" "\"reference/simulators/ode.h\"")                        # 6
must_refuse("reference/simulators/ode/ode.cc" "\"reference/simulators/bullet.h\"")         # 7
must_refuse("reference/simulators/ode/ode.cc" "\"engine/world.h\"")                        # 7
must_refuse("reference/simulators/bullet/bullet.cc" "<ode/ode.h>")                            # 7
must_refuse("reference/simulators/ode.h" "<ode/ode.h>")                                # 7, not in its face
must_refuse("harness/core/claim.h" "\"harness/core/recording.h\"")                     # 8
must_refuse("reference/simulators/ode/ode_settings.cc" "\"reference/simulators/bullet/bullet_settings.h\"")  # 7
must_refuse("tests/harness/ode_test.cc" "\"reference/simulators/ode/ode_settings.h\"")       # 7
must_refuse("tests/harness/ode_test.cc" "<ode/ode.h>")
must_refuse("tests/harness/ode_test.cc" "\"ode/ode.h\"")
must_refuse("bench/step.cc" "<btBulletDynamicsCommon.h>")
must_refuse("harness/core/scene.cc" "\"scenarios/loader.h\"")
must_refuse("harness/study/trade.cc" "\"reports/html.h\"")
must_refuse("harness/tracking/statistics/holm.cc" "\"harness/results/verdict.h\"")
must_refuse("harness/cli/commands/main.cc" "\"engine/world.h\"")
must_refuse("harness/new_layer/thing.cc" "<vector>")
must_allow("engine/world.cc" "<Eigen/Core>")
must_allow("engine/world.cc" "<vector>")
must_allow("harness/core/observable.cc" "\"harness/core/recording.h\"")
must_allow("reference/simulators/in_house/in_house.cc" "\"engine/world.h\"")
must_allow("reference/simulators/ode/ode.cc" "<ode/ode.h>")
must_allow("reference/simulators/ode/ode.cc" "\"reference/simulators/ode/ode_settings.h\"")
must_allow("harness/cli/commands/main.cc" "\"reports/html.h\"")
must_allow("tests/engine/world_test.cc" "\"engine/world.h\"")

# ---- The tree -----------------------------------------------------------------------------------------
set(checked 0)
foreach(folder engine harness reference scenarios reports tests bench)
  file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.hpp
       ${ROOT}/${folder}/*.cc ${ROOT}/${folder}/*.cpp ${ROOT}/${folder}/*.inc)
  foreach(source IN LISTS sources)
    file(STRINGS ${ROOT}/${source} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      judge("${source}" "${line}" wrong)
      if(wrong)
        message(SEND_ERROR "${wrong}")
      endif()
      math(EXPR checked "${checked} + 1")
    endforeach()
  endforeach()
endforeach()
if(checked EQUAL 0)
  message(SEND_ERROR "no include found under '${ROOT}': -DROOT must be the repository")
endif()
message(STATUS "${checked} includes checked")
