# The parts of linux-sim that do not depend on a graph: libraries, built once for all programs of a build tree, or of the
# machine (runtime/host/compiled_library.cmake).
function(eagerx_linux_sim_libraries)
  set(here ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  include(${here}/../../runtime/host/host.cmake)
  set(folders ${here} ${here}/../common ${here}/../../runtime)
  # GCC 12's -Wrestrict is wrong about its own std::string (GCC bug 105329).
  set(options -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
  if(NOT TARGET eagerx_linux_sim)
    set(names
        action_file app channel_names describe faults files float_environment identify keys link_port link_tcp measures option_table options
        pacer progress reconnect recorder replay_log run_watch session spaces split state_record state_settings summary table_writer
        task_record)
    list(APPEND names external/external_agent external/external_rows)
    list(APPEND names publish/destination publish/parameters publish/publishing publish/recording publish/remote
         publish/remote_watch)
    list(APPEND names dds/graph_of dds/remote_agent)
    list(TRANSFORM names PREPEND ${here}/)
    list(TRANSFORM names APPEND .cpp)
    eagerx_compiled_library(
      eagerx_linux_sim UNITY
      SOURCES ${names} ${here}/../common/fault.cpp
      FOLDERS ${folders}
      LINK eagerx_base eagerx_expression eagerx_trace eagerx_identify eagerx_publish eagerx_foxglove eagerx_dds eagerx_key ${CMAKE_DL_LIBS}
      OPTIONS ${options})
  endif()
  # A library of its own: nothing of it is in the program of a graph that shows nothing.
  if(NOT TARGET eagerx_pictures)
    set(names film pictures png window)
    list(TRANSFORM names PREPEND ${here}/pictures/)
    list(TRANSFORM names APPEND .cpp)
    eagerx_compiled_library(
      eagerx_pictures UNITY
      SOURCES ${names}
      FOLDERS ${folders}
      LINK eagerx_linux_sim ${CMAKE_DL_LIBS}
      OPTIONS ${options})
  endif()
endfunction()
