# Libraries for programs that run on Linux, see README.md. Included by the targets of such programs, which are compiled
# wherever they are wanted, and by this project for the generator: both link the same sources.
include(${CMAKE_CURRENT_LIST_DIR}/compiled_library.cmake)
if(TARGET eagerx_trace)
  return()
endif()
# GCC 12's -Wrestrict is wrong about its own std::string (GCC bug 105329).
set(eagerx_host_options -Wall -Wextra $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Only base (its threads) throws; the others take an eighth less time to compile.
set(eagerx_host_plain_options ${eagerx_host_options} -fno-exceptions)
set(eagerx_host_folder ${CMAKE_CURRENT_LIST_DIR})
find_package(Threads REQUIRED)
# For programs and for shared libraries.
eagerx_compiled_library(
  eagerx_base UNITY
  SOURCES ${eagerx_host_folder}/base/claim.cpp ${eagerx_host_folder}/base/exhaustion.cpp ${eagerx_host_folder}/base/files.cpp ${eagerx_host_folder}/base/handover.cpp ${eagerx_host_folder}/base/index.cpp
          ${eagerx_host_folder}/base/interrupt.cpp ${eagerx_host_folder}/base/json.cpp
          ${eagerx_host_folder}/base/supervisor.cpp
          ${eagerx_host_folder}/base/nearest.cpp ${eagerx_host_folder}/base/thread_pool.cpp ${eagerx_host_folder}/base/text_file.cpp
          ${eagerx_host_folder}/base/utf8.cpp
  FOLDERS ${eagerx_host_folder}/base
  LINK eagerx::runtime Threads::Threads
  OPTIONS -fPIC ${eagerx_host_options})
eagerx_compiled_library(
  eagerx_expression UNITY
  SOURCES ${eagerx_host_folder}/expression/calculation.cpp ${eagerx_host_folder}/expression/grammar.cpp
          ${eagerx_host_folder}/expression/text.cpp ${eagerx_host_folder}/expression/typed.cpp
  FOLDERS ${eagerx_host_folder}/base ${eagerx_host_folder}/expression ${eagerx_host_folder}/../eagerx
  LINK eagerx_base
  OPTIONS ${eagerx_host_plain_options})
eagerx_compiled_library(
  eagerx_trace UNITY
  SOURCES ${eagerx_host_folder}/trace/channel_name.cpp ${eagerx_host_folder}/trace/dtype.cpp
          ${eagerx_host_folder}/trace/json_text.cpp ${eagerx_host_folder}/trace/log_clock.cpp
          ${eagerx_host_folder}/trace/log_file.cpp ${eagerx_host_folder}/trace/mcap.cpp
          ${eagerx_host_folder}/trace/mcap_reader.cpp ${eagerx_host_folder}/trace/replay.cpp ${eagerx_host_folder}/trace/scene_line.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_base
  OPTIONS ${eagerx_host_plain_options})
eagerx_compiled_library(
  eagerx_identify UNITY
  SOURCES ${eagerx_host_folder}/identify/experiment.cpp ${eagerx_host_folder}/identify/identification.cpp
          ${eagerx_host_folder}/identify/deviations.cpp
          ${eagerx_host_folder}/identify/least_squares.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_trace
  OPTIONS ${eagerx_host_plain_options})
eagerx_compiled_library(
  eagerx_publish UNITY
  SOURCES ${eagerx_host_folder}/publish/address.cpp ${eagerx_host_folder}/publish/datagrams.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_trace
  OPTIONS ${eagerx_host_plain_options})
eagerx_compiled_library(
  eagerx_telemetry UNITY
  SOURCES ${eagerx_host_folder}/telemetry/decoder.cpp ${eagerx_host_folder}/telemetry/layout.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_trace
  OPTIONS ${eagerx_host_plain_options})
# A library of its own, so that the others are the same whether there is libwebsockets-dev or not. What it calls is looked for
# when a program speaks with somebody.
set(eagerx_web_socket_sources no_web_socket)
find_file(EAGERX_LIBWEBSOCKETS libwebsockets.h)
mark_as_advanced(EAGERX_LIBWEBSOCKETS)
if(EAGERX_LIBWEBSOCKETS AND NOT CMAKE_CROSSCOMPILING)
  set(eagerx_web_socket_sources client library relay server)
endif()
list(TRANSFORM eagerx_web_socket_sources PREPEND ${eagerx_host_folder}/web_socket/)
list(TRANSFORM eagerx_web_socket_sources APPEND .cpp)
eagerx_compiled_library(
  eagerx_web_sockets UNITY
  SOURCES ${eagerx_web_socket_sources} ${eagerx_host_folder}/web_socket/client_bytes.cpp ${eagerx_host_folder}/web_socket/listener.cpp
  FOLDERS ${eagerx_host_folder}
  LINK eagerx_base ${CMAKE_DL_LIBS}
  OPTIONS ${eagerx_host_plain_options})
eagerx_compiled_library(
  eagerx_foxglove UNITY
  SOURCES ${eagerx_host_folder}/foxglove/access.cpp ${eagerx_host_folder}/foxglove/client_message.cpp
          ${eagerx_host_folder}/foxglove/json_reader.cpp ${eagerx_host_folder}/foxglove/scene_schema.cpp
          ${eagerx_host_folder}/foxglove/scene_update.cpp ${eagerx_host_folder}/foxglove/server.cpp
          ${eagerx_host_folder}/foxglove/server_message.cpp ${eagerx_host_folder}/foxglove/server_text.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_publish eagerx_trace eagerx_web_sockets
  OPTIONS ${eagerx_host_plain_options})
eagerx_compiled_library(
  eagerx_dds UNITY
  SOURCES ${eagerx_host_folder}/dds/dds_sink.cpp ${eagerx_host_folder}/dds/library.cpp ${eagerx_host_folder}/dds/messages.cpp
          ${eagerx_host_folder}/dds/participant.cpp ${eagerx_host_folder}/dds/topics.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_publish eagerx_trace ${CMAKE_DL_LIBS}
  OPTIONS ${eagerx_host_plain_options})
eagerx_compiled_library(
  eagerx_key UNITY
  SOURCES ${eagerx_host_folder}/key/key_file.cpp ${eagerx_host_folder}/key/session.cpp ${eagerx_host_folder}/key/sodium.cpp
  FOLDERS ${eagerx_host_folder}/base ${eagerx_host_folder}/key
  LINK eagerx_base ${CMAKE_DL_LIBS}
  OPTIONS ${eagerx_host_plain_options})
