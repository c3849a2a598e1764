# The library that OpenDynamicsEngine is built on.
find_package(PkgConfig REQUIRED)
pkg_check_modules(ODE REQUIRED IMPORTED_TARGET ode)
target_link_libraries(test_rigid PRIVATE PkgConfig::ODE)
target_compile_options(test_rigid PRIVATE -Wdouble-promotion)
