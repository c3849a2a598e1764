# The libraries that the package brings.
set(eagerx_brought base expression trace identify publish web_sockets foxglove dds key linux_sim pictures environments)
list(TRANSFORM eagerx_brought PREPEND eagerx_)
