# Compiles SOURCE with CXX for a graphics processor and checks what the code asks of others: functions of the kernel and
# of mathematics. No exceptions (they do not compile), virtual calls, locks or files. What allocates is the memory of the
# barriers that a rock has just met.
list(FILTER SYSTEM EXCLUDE REGEX "/lib/gcc/")  # clang has its own
list(TRANSFORM SYSTEM PREPEND -isystem)
list(TRANSFORM ROOMS PREPEND -I)
# Without the system's own target, its headers take the processor from the definition; the pause is that of a spin lock.
execute_process(COMMAND ${CXX} -std=c++20 -O1 -DNDEBUG -ffp-contract=off -fno-exceptions -fno-rtti --target=nvptx64-nvidia-cuda
    -march=sm_70 -nostdinc++ ${SYSTEM} ${ROOMS} -D_GNU_SOURCE -D__x86_64__ "-D__builtin_ia32_pause()=(void)0"
    -S ${SOURCE} -o ${FOLDER}/rock_run.ptx
  COMMAND_ERROR_IS_FATAL ANY)

file(READ ${FOLDER}/rock_run.ptx code)
string(REGEX MATCHALL "\\.extern \\.func[^;]*" declared "${code}")
list(LENGTH declared count)
if(count LESS 10)
  message(FATAL_ERROR "${count} outside functions: that is not the code of a rock's run")
endif()
set(mathematics "a?(sin|cos|tan)|atan2|sqrt|cbrt|exp|expm1|log|log1p|pow")
set(of_barriers_met "_Znwm|_ZdlPvm?|_ZSt20__throw_length_errorPKc|_ZSt17__throw_bad_allocv|_ZSt28__throw_bad_array_new_lengthv")
foreach(function IN LISTS declared)
  string(REGEX REPLACE "^\\.extern \\.func *(\\([^)]*\\))?[ \n]*([A-Za-z0-9_$]+).*$" "\\2" name "${function}")
  if(NOT name MATCHES "^(_ZNK?5talus.*|${mathematics}|${of_barriers_met}|abort)$")
    list(APPEND foreign ${name})
  endif()
endforeach()
if(foreign)
  message(FATAL_ERROR "The kernel calls ${foreign}: neither its own nor mathematics")
endif()
