# Test files are compiled several at a time (cmake/batch.py): a first build takes a quarter less.  After a change of one file
# its batch is compiled, in 15 to 35 s in place of 7; -DCYLON_BATCHES=OFF compiles each file alone, as clang-tidy wants it
# (./test lint).  So are the engine's sources, as they are: no two of them may give one name, in an unnamed namespace, to two
# things.
option(CYLON_BATCHES "Compile test files, and the engine's, in batches" ON)
set(files_in_a_batch 8)

# in_batches(out name own_names sources…): what to compile in place of the sources.  The files of a batch are of one folder, whose
# fixtures they share; a file with options of its own is compiled alone.  OWN_NAMES: unnamed namespaces become a namespace for
# each file; "": they stay as they are.
function(in_batches out name own_names)
  set(made "")
  set(folders "")
  foreach(source ${ARGN})
    get_source_file_property(own_options ${source} COMPILE_OPTIONS)
    if(own_options)
      list(APPEND made ${source})
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    list(APPEND folders ${folder})
    list(APPEND files_of_${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/batches)
  foreach(folder ${folders})
    list(LENGTH files_of_${folder} count)
    if(NOT CYLON_BATCHES OR count EQUAL 1)
      list(APPEND made ${files_of_${folder}})
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${name}_of_${folder}" stem)
    set(first 0)
    while(first LESS count)
      list(SUBLIST files_of_${folder} ${first} ${files_in_a_batch} files)
      list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/)
      set(batch ${PROJECT_BINARY_DIR}/batches/${stem}_${first}.cc)
      set(names "as-they-are")
      if(own_names)
        set(names ${stem}_${first})
      endif()
      add_custom_command(OUTPUT ${batch} COMMAND ${PROJECT_SOURCE_DIR}/cmake/batch.py ${batch} ${names} ${files}
                         DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/batch.py COMMENT "Writing ${stem}_${first}.cc")
      # A batch is no header: a type of an unnamed namespace in a class of the same file is none that others see.
      set_source_files_properties(${batch} PROPERTIES COMPILE_OPTIONS -Wno-subobject-linkage)
      list(APPEND made ${batch})
      math(EXPR first "${first} + ${files_in_a_batch}")
    endwhile()
  endforeach()
  set(${out} ${made} PARENT_SCOPE)
endfunction()
