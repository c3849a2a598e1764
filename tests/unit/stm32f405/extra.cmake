# The drivers are for boards, and the devices on the pins are those of the emulated adapter.
target_compile_options(test_stm32f405 PRIVATE -Wdouble-promotion)
target_sources(test_stm32f405 PRIVATE ${PROJECT_SOURCE_DIR}/targets/emulated-ftdi/pendulum_rig.cpp)
