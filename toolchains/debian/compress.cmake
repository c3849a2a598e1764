# cpack runs this on what it is about to pack: manual pages and the changelog are compressed, without a time in them.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share/man/*.1
     ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share/doc/eagerx-gen/changelog)
execute_process(COMMAND gzip --best --no-name ${pages} COMMAND_ERROR_IS_FATAL ANY)
