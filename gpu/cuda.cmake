# Finds nvcc. Kernels are .cu files; where it is not found they are compiled as C++.
include(CheckLanguage)
if(GABARIT_CUDA)
  if(NOT DEFINED CMAKE_CUDA_COMPILER AND EXISTS /usr/local/cuda/bin/nvcc)
    set(CMAKE_CUDA_COMPILER /usr/local/cuda/bin/nvcc)
  endif()
  check_language(CUDA)
endif()
if(GABARIT_CUDA AND CMAKE_CUDA_COMPILER)
  if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    set(CMAKE_CUDA_ARCHITECTURES 80-virtual 90)
  endif()
  enable_language(CUDA)
  find_package(CUDAToolkit REQUIRED)
  set(GABARIT_HAS_CUDA ON)
endif()

# CMake 3.25 knows no C++20 for CUDA 13: the flag is given by hand. Contraction stays off on both sides: the
# same bits everywhere. Neither of the last two flags changes a bit of any result; both let loops with square
# roots and choices become vector instructions.
function(gabarit_kernels target)
  target_sources(${target} PRIVATE ${ARGN})
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_DEFINITIONS GABARIT_DEVICE_SOURCE=1)
  if(GABARIT_HAS_CUDA)
    set_target_properties(${target} PROPERTIES
      CUDA_ARCHITECTURES "${CMAKE_CUDA_ARCHITECTURES}" CUDA_STANDARD_REQUIRED OFF)
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANGUAGE:CUDA>:-std=c++20;--fmad=false;--expt-relaxed-constexpr;-Xcompiler=-ffp-contract=off>
      $<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-fno-math-errno;-Xcompiler=-fno-trapping-math>)
  else()
    set_source_files_properties(${ARGN} PROPERTIES LANGUAGE CXX
      COMPILE_OPTIONS "-x;c++;-fno-math-errno;-fno-trapping-math")
  endif()
endfunction()
