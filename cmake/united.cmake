# Files that are compiled as one, because what they include takes longer to compile than they do: the library takes 740 s of processor time
# file by file, 300 s in units of 18 files. That saves time alone: each file includes what it uses, and the preset `clang`, in which every
# file is compiled by itself, shows that it does. What is in the unnamed namespace of a file needs a name that no other file of its target
# gives to something else.

# GCC takes files that another includes for headers, which should not have unnamed namespaces. What shadows a name of another file is no
# mistake; the preset `clang` warns of what shadows one of its own.
set(strata_united_options -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
# GCC limits what it inlines by the size of a unit. Without this, Booleans of 20 thousand triangles take 5 % longer than compiled file by
# file.
set(strata_united_inlining $<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=200000>)

# strata_unite(TARGET GROUP FILES...): these, and none of the others that are in no group.
function(strata_unite target group)
  if(STRATA_UNITED)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
  endif()
endfunction()

# strata_unite_all(TARGET [INLINED]): units of consecutive files; INLINED: with as much inlined as file by file, which takes longer.
function(strata_unite_all target)
  if(STRATA_UNITED)
    target_compile_options(${target} PRIVATE ${strata_united_options} $<$<BOOL:${ARGN}>:${strata_united_inlining}>)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 18)
  endif()
endfunction()
