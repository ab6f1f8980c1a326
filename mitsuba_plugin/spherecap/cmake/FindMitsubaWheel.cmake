#[=======================================================================[.rst:
FindMitsubaWheel
----------------

Build Mitsuba 3 plugins against the ``mitsuba`` wheel from PyPI, without a Mitsuba source tree.

The wheel ships its headers and libraries, but no CMake target for ``libmitsuba``; its headers include two
others that only the ``nanobind`` package has; the compiler flags decide the layout of Dr.Jit's arrays, so
wrong ones give a plugin that loads and renders garbage; and older wheels have another ``std::string``. This module
knows all four.

.. code-block:: cmake

  list(APPEND CMAKE_MODULE_PATH "<folder of this file>")
  find_package(MitsubaWheel 3.9.1 EXACT REQUIRED)
  mitsuba_add_plugin(my_emitter my_emitter.cpp OUTPUT_DIRECTORY "${PROJECT_SOURCE_DIR}/plugins")

Input (cache variables)
  ``MitsubaWheel_PYTHON``
    Python interpreter whose environment has ``mitsuba`` and ``nanobind``. Default: ``python3``, an activated
    virtual environment first.
  ``MitsubaWheel_NANOBIND_VERSION``
    The nanobind version that the wheel was built with. Known for the wheels listed below; for any other it
    is in the ``requires`` list of Mitsuba's ``pyproject.toml`` at that release.

Result
  ``MitsubaWheel_FOUND``, ``MitsubaWheel_VERSION`` (of Mitsuba), ``MitsubaWheel_DIR`` (the installed package),
  ``MitsubaWheel_INCLUDE_DIRS``.

Target ``MitsubaWheel::mitsuba``
  Headers, libraries, language standard, flags and definitions. It also defines
  ``MITSUBA_WHEEL_VERSION`` as a string: Mitsuba itself never compares versions, and in another one a plugin may
  lack symbols, which ends the process, so something without any should compare first (``guard.cpp`` of spherecap does).

Function ``mitsuba_add_plugin(<name> <source>... [OUTPUT_DIRECTORY <dir>])``
  Builds ``<name>.so`` that exports nothing but ``init_plugin``, drops what it does not use, and contains no
  path of this machine. Mitsuba finds it if ``<dir>`` is called ``plugins`` and its parent is in
  ``mitsuba.file_resolver()``. Link further libraries with ``target_link_libraries(<name> PRIVATE ...)``.

A whole plugin, with what the module takes care of, is in ``docs/mitsuba_plugins.md`` of spherecap, where this file
comes from; it depends on nothing there, so copy it into your project, or add the folder to ``CMAKE_MODULE_PATH`` that
``python -m spherecap --cmake_dir`` prints.

Supported: Linux on x86-64, GCC or Clang. On anything else the module fails and says so.
#]=======================================================================]

include(FindPackageHandleStandardArgs)

# Mitsuba release -> nanobind release, from Mitsuba's pyproject.toml. One row per release that was tried.
set(_MitsubaWheel_KNOWN_NANOBIND "3.9.1=2.14.0" "3.8.0=2.11.0" "3.7.1=2.9.2")

# The reason for a failure, in words that say what to do; find_package prints it (if REQUIRED). No semicolon may be
# in it: it is passed on as an argument.
set(_MitsubaWheel_reason "")
set(MitsubaWheel_VERSION "")
set(MitsubaWheel_DIR "")

if(NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    string(APPEND _MitsubaWheel_reason
        "Only Linux on x86-64 is supported, not ${CMAKE_SYSTEM_NAME} on ${CMAKE_SYSTEM_PROCESSOR}. ")
endif()

if(NOT MitsubaWheel_PYTHON)
    set(Python3_FIND_VIRTUALENV FIRST)
    find_package(Python3 QUIET COMPONENTS Interpreter)
    set(MitsubaWheel_PYTHON "${Python3_EXECUTABLE}" CACHE FILEPATH
        "Python interpreter whose environment has the mitsuba and nanobind packages" FORCE)
endif()

# Asks for `name` in the interpreter's environment, without importing it (Mitsuba takes a second to import).
# Sets <out>_version and <out>_dir, or appends to the reason.
macro(_MitsubaWheel_find_package name out)
    set(${out}_version "")
    set(${out}_dir "")
    execute_process(
        COMMAND "${MitsubaWheel_PYTHON}" -c
                "import importlib.metadata as m, importlib.util as u, os
print(m.version('${name}'), os.path.dirname(u.find_spec('${name}').origin), sep=';', end='')"
        OUTPUT_VARIABLE _MitsubaWheel_answer
        ERROR_QUIET
        RESULT_VARIABLE _MitsubaWheel_failed)
    list(LENGTH _MitsubaWheel_answer _MitsubaWheel_length)
    if(NOT _MitsubaWheel_failed AND _MitsubaWheel_length EQUAL 2)
        list(GET _MitsubaWheel_answer 0 ${out}_version)
        list(GET _MitsubaWheel_answer 1 ${out}_dir)
    endif()
endmacro()

if(NOT _MitsubaWheel_reason)
    _MitsubaWheel_find_package(mitsuba _MitsubaWheel_mi)
    _MitsubaWheel_find_package(drjit _MitsubaWheel_dr)
    _MitsubaWheel_find_package(nanobind _MitsubaWheel_nb)
    set(MitsubaWheel_VERSION "${_MitsubaWheel_mi_version}")
    set(MitsubaWheel_DIR "${_MitsubaWheel_mi_dir}")

    # Which nanobind belongs to this wheel?
    if(NOT MitsubaWheel_NANOBIND_VERSION AND MitsubaWheel_VERSION)
        foreach(_MitsubaWheel_row IN LISTS _MitsubaWheel_KNOWN_NANOBIND)
            if(_MitsubaWheel_row MATCHES "^${MitsubaWheel_VERSION}=(.*)$")
                set(MitsubaWheel_NANOBIND_VERSION "${CMAKE_MATCH_1}")
            endif()
        endforeach()
    endif()

    if(NOT MitsubaWheel_VERSION)
        string(APPEND _MitsubaWheel_reason
            "'${MitsubaWheel_PYTHON}' has no mitsuba package: run '${MitsubaWheel_PYTHON} -m pip install "
            "mitsuba==${MitsubaWheel_FIND_VERSION}', or set MitsubaWheel_PYTHON to the interpreter that has it. ")
    elseif(NOT _MitsubaWheel_dr_version)
        string(APPEND _MitsubaWheel_reason
            "'${MitsubaWheel_PYTHON}' has mitsuba but no drjit package: reinstall mitsuba. ")
    elseif(NOT MitsubaWheel_NANOBIND_VERSION)
        string(APPEND _MitsubaWheel_reason
            "It is not known which nanobind Mitsuba ${MitsubaWheel_VERSION} was built with: look it up in the "
            "'requires' list of its pyproject.toml and set MitsubaWheel_NANOBIND_VERSION. ")
    elseif(NOT _MitsubaWheel_nb_version VERSION_EQUAL MitsubaWheel_NANOBIND_VERSION)
        if(NOT _MitsubaWheel_nb_version)
            set(_MitsubaWheel_nb_version "no nanobind")
        endif()
        string(APPEND _MitsubaWheel_reason
            "Mitsuba ${MitsubaWheel_VERSION} needs the headers of nanobind ${MitsubaWheel_NANOBIND_VERSION}, "
            "found ${_MitsubaWheel_nb_version}: run '${MitsubaWheel_PYTHON} -m pip install "
            "nanobind==${MitsubaWheel_NANOBIND_VERSION}'. ")
    endif()
endif()

if(NOT _MitsubaWheel_reason)
    set(MitsubaWheel_INCLUDE_DIRS
        "${MitsubaWheel_DIR}/include"
        "${_MitsubaWheel_dr_dir}/include"
        "${_MitsubaWheel_nb_dir}/include"
        "${_MitsubaWheel_nb_dir}/ext/robin_map/include") # tsl/robin_map.h, included by Dr.Jit
    set(_MitsubaWheel_headers
        mitsuba/render/emitter.h drjit/array.h nanobind/intrusive/ref.h tsl/robin_map.h)
    foreach(_MitsubaWheel_dir _MitsubaWheel_header
            IN ZIP_LISTS MitsubaWheel_INCLUDE_DIRS _MitsubaWheel_headers)
        if(NOT EXISTS "${_MitsubaWheel_dir}/${_MitsubaWheel_header}")
            string(APPEND _MitsubaWheel_reason "'${_MitsubaWheel_header}' is not in '${_MitsubaWheel_dir}'. ")
        endif()
    endforeach()

    # libmitsuba.so comes last because it needs the others.
    set(_MitsubaWheel_libraries
        "${_MitsubaWheel_dr_dir}/libdrjit-core.so"
        "${_MitsubaWheel_dr_dir}/libdrjit-extra.so"
        "${MitsubaWheel_DIR}/libmitsuba.so")
    foreach(_MitsubaWheel_library IN LISTS _MitsubaWheel_libraries)
        if(NOT EXISTS "${_MitsubaWheel_library}")
            string(APPEND _MitsubaWheel_reason "'${_MitsubaWheel_library}' is missing. ")
        endif()
    endforeach()
    if(_MitsubaWheel_reason)
        string(APPEND _MitsubaWheel_reason
            "Is this the wheel from PyPI? Try '${MitsubaWheel_PYTHON} -m pip install --force-reinstall "
            "mitsuba==${MitsubaWheel_VERSION} nanobind==${MitsubaWheel_NANOBIND_VERSION}'. ")
    endif()
endif()

if(_MitsubaWheel_reason)
    set(MitsubaWheel_USABLE FALSE)
else()
    set(MitsubaWheel_USABLE TRUE)
endif()
find_package_handle_standard_args(MitsubaWheel
    REQUIRED_VARS MitsubaWheel_USABLE MitsubaWheel_DIR
    VERSION_VAR MitsubaWheel_VERSION
    REASON_FAILURE_MESSAGE "${_MitsubaWheel_reason}")

if(MitsubaWheel_FOUND AND NOT TARGET MitsubaWheel::mitsuba)
    # Wheels up to 3.7 have the std::string of GCC before 5; else "cxx11" is in the name of a function that returns one.
    file(STRINGS "${MitsubaWheel_DIR}/libmitsuba.so" _MitsubaWheel_cxx11 REGEX "info_buildB5cxx11" LIMIT_COUNT 1)
    set(_MitsubaWheel_definitions
        MITSUBA_WHEEL_VERSION="${MitsubaWheel_VERSION}" _GLIBCXX_USE_CXX11_ABI=$<BOOL:${_MitsubaWheel_cxx11}>)
    add_library(MitsubaWheel::mitsuba INTERFACE IMPORTED)
    set_target_properties(MitsubaWheel::mitsuba PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${MitsubaWheel_INCLUDE_DIRS}"
        INTERFACE_LINK_LIBRARIES "${_MitsubaWheel_libraries}"
        INTERFACE_COMPILE_FEATURES cxx_std_17
        # What the wheel itself was built with (`mitsuba --help` prints avx2 fma f16c sse4.2). The instruction
        # set is part of the ABI: Dr.Jit's 3-vectors are padded to 16 bytes only where SSE4.2 is enabled.
        INTERFACE_COMPILE_OPTIONS "-march=haswell;-fno-strict-aliasing"
        # The backends of the wheel's variants: they select members of classes that the plugin derives from.
        INTERFACE_COMPILE_DEFINITIONS
            "MI_ENABLE_LLVM=1;MI_ENABLE_CUDA=1;MI_ENABLE_AUTODIFF=1;MI_ENABLE_EMBREE=1;${_MitsubaWheel_definitions}"
        # The wheel's libraries need each other, and find each other in these folders.
        INTERFACE_LINK_OPTIONS
            "LINKER:-rpath-link,${MitsubaWheel_DIR};LINKER:-rpath-link,${_MitsubaWheel_dr_dir}")
endif()

function(mitsuba_add_plugin name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "OUTPUT_DIRECTORY" "")
    if(NOT arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "mitsuba_add_plugin(${name}): no source file was given")
    endif()
    if(NOT arg_OUTPUT_DIRECTORY)
        set(arg_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/plugins")
    endif()

    # Mitsuba calls one function by name; whatever else stays visible may clash with another plugin's.
    set(exports "${CMAKE_CURRENT_BINARY_DIR}/${name}.exports")
    file(CONFIGURE OUTPUT "${exports}" CONTENT "{ global: init_plugin; local: *; };\n")

    add_library(${name} MODULE ${arg_UNPARSED_ARGUMENTS})
    target_link_libraries(${name} PRIVATE MitsubaWheel::mitsuba)
    target_compile_options(${name} PRIVATE -ffunction-sections -fdata-sections
        # Assertions, in the headers too, contain the name of their file.
        "-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=")
    foreach(dir IN LISTS MitsubaWheel_INCLUDE_DIRS)
        target_compile_options(${name} PRIVATE "-ffile-prefix-map=${dir}/=")
    endforeach()
    target_link_options(${name} PRIVATE
        "LINKER:--version-script,${exports}" LINKER:--exclude-libs,ALL LINKER:--gc-sections
        LINKER:--no-undefined $<$<NOT:$<CONFIG:Debug>>:LINKER:--strip-all>)
    set_target_properties(${name} PROPERTIES
        PREFIX ""
        OUTPUT_NAME "${name}"
        LIBRARY_OUTPUT_DIRECTORY "${arg_OUTPUT_DIRECTORY}"
        LINK_DEPENDS "${exports}"
        CXX_VISIBILITY_PRESET hidden
        VISIBILITY_INLINES_HIDDEN ON
        POSITION_INDEPENDENT_CODE ON
        # Mitsuba is in the process before any plugin, so its libraries are found by name: no path is needed.
        SKIP_BUILD_RPATH ON)
endfunction()
