# Files that are compiled as one, because what they include takes longer to compile than they do. That saves time alone: each file
# includes what it uses, and the preset `clang`, in which every file is compiled by itself, shows that it does.

# strata_unite(TARGET GROUP FILES...)
function(strata_unite target group)
  if(STRATA_UNITED)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
  endif()
endfunction()
