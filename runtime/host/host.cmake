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
          ${eagerx_host_folder}/base/json_reader.cpp
          ${eagerx_host_folder}/base/supervisor.cpp
          ${eagerx_host_folder}/base/nearest.cpp ${eagerx_host_folder}/base/thread_pool.cpp ${eagerx_host_folder}/base/text_file.cpp
          ${eagerx_host_folder}/base/utf8.cpp
  FOLDERS ${eagerx_host_folder}/base
  LINK eagerx::runtime Threads::Threads
  OPTIONS -fPIC ${eagerx_host_options})
eagerx_compiled_library(
  eagerx_expression UNITY
  SOURCES ${eagerx_host_folder}/expression/calculation.cpp ${eagerx_host_folder}/expression/functions.cpp
          ${eagerx_host_folder}/expression/grammar.cpp ${eagerx_host_folder}/expression/text.cpp
          ${eagerx_host_folder}/expression/typed.cpp
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
          ${eagerx_host_folder}/identify/delays.cpp ${eagerx_host_folder}/identify/deviations.cpp
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
          ${eagerx_host_folder}/foxglove/scene_schema.cpp
          ${eagerx_host_folder}/foxglove/scene_update.cpp ${eagerx_host_folder}/foxglove/server.cpp
          ${eagerx_host_folder}/foxglove/server_message.cpp ${eagerx_host_folder}/foxglove/server_text.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_publish eagerx_trace eagerx_web_sockets
  OPTIONS ${eagerx_host_plain_options})
# The same with cyclonedds-dev, and idlc of cyclonedds-tools, which makes C of messages.idl.
find_package(CycloneDDS QUIET)
find_program(EAGERX_IDLC idlc)
mark_as_advanced(CycloneDDS_DIR EAGERX_IDLC)
set(eagerx_dds_arguments SOURCES ${eagerx_host_folder}/dds/no_dds.cpp)
if(CycloneDDS_FOUND AND EAGERX_IDLC)
  idlc_generate(TARGET eagerx_dds_messages FILES ${eagerx_host_folder}/dds/messages.idl FEATURES case-sensitive
                WARNINGS no-implicit-extensibility NO_TYPE_INFO)
  set(eagerx_dds_messages ${CMAKE_CURRENT_BINARY_DIR}/messages.c)
  # As C++, because programs have no compiler of C.
  set_source_files_properties(${eagerx_dds_messages} PROPERTIES LANGUAGE CXX SKIP_UNITY_BUILD_INCLUSION ON
                                                                COMPILE_OPTIONS "-w;-D_Alignof=alignof")
  get_target_property(eagerx_dds_include CycloneDDS::ddsc INTERFACE_INCLUDE_DIRECTORIES)
  find_file(EAGERX_DDS_VERSION dds/version.h PATHS ${eagerx_dds_include} NO_DEFAULT_PATH)
  mark_as_advanced(EAGERX_DDS_VERSION)
  set(eagerx_dds_arguments
      GENERATED ${eagerx_dds_messages}
      FROM ${eagerx_host_folder}/dds/messages.idl ${EAGERX_DDS_VERSION}
      SOURCES ${eagerx_host_folder}/dds/dds_sink.cpp ${eagerx_host_folder}/dds/joint_exchange.cpp
              ${eagerx_host_folder}/dds/library.cpp ${eagerx_host_folder}/dds/participant.cpp)
endif()
eagerx_compiled_library(
  eagerx_dds UNITY ${eagerx_dds_arguments} ${eagerx_host_folder}/dds/network.cpp ${eagerx_host_folder}/dds/topics.cpp
  FOLDERS ${eagerx_host_folder} ${eagerx_host_folder}/../eagerx
  LINK eagerx_publish eagerx_trace ${CMAKE_DL_LIBS}
  OPTIONS ${eagerx_host_plain_options})
get_target_property(eagerx_dds_is_kept eagerx_dds IMPORTED)
if(TARGET eagerx_dds_messages AND NOT eagerx_dds_is_kept)
  add_dependencies(eagerx_dds eagerx_dds_messages_generate)
  target_include_directories(eagerx_dds SYSTEM PRIVATE ${CMAKE_CURRENT_BINARY_DIR} ${eagerx_dds_include})
  target_compile_definitions(eagerx_dds PRIVATE EAGERX_DDSC="$<TARGET_SONAME_FILE_NAME:CycloneDDS::ddsc>")
endif()
eagerx_compiled_library(
  eagerx_key UNITY
  SOURCES ${eagerx_host_folder}/key/key_file.cpp ${eagerx_host_folder}/key/session.cpp ${eagerx_host_folder}/key/sodium.cpp
  FOLDERS ${eagerx_host_folder}/base ${eagerx_host_folder}/key
  LINK eagerx_base ${CMAKE_DL_LIBS}
  OPTIONS ${eagerx_host_plain_options})
