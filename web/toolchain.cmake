# WebAssembly with WASI's C library: clang of the Python package ziglang, and what tools/web makes of libc++ (STRATA_WEB_PREFIX), as the
# libc++ that Zig would link has no exceptions. They are WebAssembly's own, in the form that browsers have had since 2022.
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES STRATA_ZIG STRATA_WEB_PREFIX)
set(CMAKE_C_COMPILER ${STRATA_ZIG}/zig clang)
set(CMAKE_CXX_COMPILER ${STRATA_ZIG}/zig clang --driver-mode=g++)
set(CMAKE_AR ${STRATA_WEB_PREFIX}/bin/ar)
set(CMAKE_RANLIB ${STRATA_WEB_PREFIX}/bin/ranlib)

set(features "-mcpu=generic -mexception-handling -mbulk-memory -msign-ext -mnontrapping-fptoint -mmutable-globals")
set(both "--target=wasm32-wasip1 ${features} -fexceptions -fwasm-exceptions -nostdinc")
set(zig_lib ${STRATA_ZIG}/lib)
set(libc "-isystem ${zig_lib}/include")
foreach(folder wasm-wasi-musl generic-musl wasm32-wasi-any any-wasi-any)
  string(APPEND libc " -isystem ${zig_lib}/libc/include/${folder}")
endforeach()
# What a configured libc++ has in its <__config_site>.
set(libcxx "-isystem ${zig_lib}/libcxx/include -isystem ${zig_lib}/libcxxabi/include")
foreach(setting ABI_VERSION=1 ABI_NAMESPACE=__1 HAS_THREADS=0 HAS_MONOTONIC_CLOCK=1 HAS_TERMINAL=0 HAS_MUSL_LIBC=1 HAS_FILESYSTEM=1
    HAS_VENDOR_AVAILABILITY_ANNOTATIONS=0 HAS_RANDOM_DEVICE=1 HAS_LOCALIZATION=1 HAS_UNICODE=1 HAS_WIDE_CHARACTERS=1
    HAS_TIME_ZONE_DATABASE=0 HAS_NO_STD_MODULES=1 PSTL_BACKEND_SERIAL=1 HARDENING_MODE=_LIBCPP_HARDENING_MODE_NONE
    ASSERTION_SEMANTIC_DEFAULT=_LIBCPP_ASSERTION_SEMANTIC_IGNORE
    ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION=1)
  string(APPEND libcxx " -D_LIBCPP_${setting}")
endforeach()
set(CMAKE_C_FLAGS_INIT "${both} ${libc}")
set(CMAKE_CXX_FLAGS_INIT "${both} ${libcxx} ${libc}")

# Zig's own driver links: it makes the C library.
set(CMAKE_CXX_LINK_EXECUTABLE "${STRATA_ZIG}/zig c++ -target wasm32-wasi -mcpu=generic+exception_handling -mexec-model=reactor -nostdlib++ \
<LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")

set(CMAKE_FIND_ROOT_PATH ${STRATA_WEB_PREFIX})
set(CMAKE_PREFIX_PATH ${STRATA_WEB_PREFIX})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
