# Makes `executable` a program for the machine that builds it.
function(eagerx_configure_target executable)
  # Loops over derivatives are not worth more than -O1, and the compiler takes half of the time.
  target_compile_options(${executable} PRIVATE -Wall -Wextra $<$<NOT:$<CONFIG:Debug>>:-O1>)
endfunction()
