# Puts the flags that the cores' platform.txt and boards.txt, or their Makefile, compile a sketch with into `flags`, for
# `run`. $trees has a folder for each repository.
pico() { # CHIP BOARD VARIANT FLAG...: arduino-pico
  local core=$trees/arduino-pico
  flags=(arm-none-eabi-g++ "${@:4}" -DUSBD_VID=0x2e8a -DUSBD_PID=0x000f -DUSBD_MAX_POWER_MA=250 -DUSB_MANUFACTURER='""'
    -DUSB_PRODUCT='""' -DLWIP_IPV6=0 -DLWIP_IPV4=1 -DLWIP_IGMP=1 -DLWIP_CHECKSUM_CTRL_PER_NETIF=1 "-DARDUINO_VARIANT=\"$3\""
    -DPICO_FLASH_SIZE_BYTES=4194304 -DFS_START=0 -DFS_END=0 "@$core/lib/platform_def.txt" "@$core/lib/$1/platform_def.txt"
    -ffunction-sections -fdata-sections -fno-exceptions "-iprefix$core/" "@$core/lib/$1/platform_inc.txt"
    "@$core/lib/core_inc.txt" "-I$core/include" "-I$core/cores/rp2040" "-I$core/variants/$3" -fno-rtti -std=gnu++23 -Os
    -Wno-volatile -DF_CPU=125000000 -DARDUINO=10819 "-DARDUINO_$2" "-DBOARD_NAME=\"$2\"" -DARDUINO_ARCH_RP2040)
}
stm32() { # SERIES VARIANT PRODUCT BOARD HEADER FLAG...: stm32duino
  local core=$trees/Arduino_Core_STM32 cmsis=$trees/CMSIS_5/CMSIS/Core/Include
  local device=$core/system/Drivers/CMSIS/Device/ST/$1 hal=$core/system/Drivers/${1}_HAL_Driver
  flags=(arm-none-eabi-g++ "${@:6}" -mthumb -DVECT_TAB_OFFSET=0 -DUSE_HAL_DRIVER -DUSE_FULL_LL_DRIVER -DEXTENDED_PIN_MODE -Os
    -DNDEBUG -ffunction-sections -fdata-sections -fno-threadsafe-statics --param max-inline-insns-single=500 -fno-rtti
    -fno-exceptions -fno-use-cxa-atexit -std=gnu++17 "-I$core/cores/arduino/avr" "-I$core/cores/arduino/stm32"
    "-I$trees/ArduinoCore-API/api" "-I$core/libraries/SrcWrapper/inc" "-I$core/libraries/SrcWrapper/inc/LL" "-I$hal/Inc"
    "-I$hal/Src" "-I$core/system/$1" "-I$core/libraries/USBDevice/inc" "-I$cmsis" "-I$device/Include"
    "-I$device/Source/Templates/gcc" "-I$core/cores/arduino" "-I$core/variants/$1/$2" "-I$core/libraries/IWatchdog/src" "-D$1"
    -DARDUINO=10819 "-DARDUINO_$4" -DARDUINO_ARCH_STM32 "-DBOARD_NAME=\"$4\"" "-DVARIANT_H=\"$5\"" "-D$3"
    -DHAL_UART_MODULE_ENABLED)
}
teensy() { # BOARD: Teensy's core
  flags=(arm-none-eabi-g++ -mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16 -mthumb -Os -ffunction-sections -fdata-sections
    -fno-exceptions -fno-rtti -felide-constructors -std=gnu++17 -D__IMXRT1062__ -DARDUINO=10813 -DTEENSYDUINO=159
    "-DARDUINO_$1" -DF_CPU=600000000 -DUSB_SERIAL -DLAYOUT_US_ENGLISH "-I$trees/cores/teensy4")
}
esp_idf() { # ESP-IDF for its target `linux`, with sdkconfig.h of this folder
  local components=$trees/esp-idf/components kernel=$trees/esp-idf/components/freertos
  flags=(c++ -O0 -DESP_PLATFORM "-I$here")
  local folder
  for folder in esp_hw_support/include/linux esp_timer/include esp_system/include esp_common/include log/include \
    heap/include linux/include esp_hw_support/include esp_hw_support/etm/include esp_rom/include esp_rom/linux \
    soc/linux/include hal/include; do
    flags+=("-I$components/$folder")
  done
  for folder in config/include config/include/freertos config/linux/include FreeRTOS-Kernel/include \
    FreeRTOS-Kernel/portable/linux/include FreeRTOS-Kernel/portable/linux/include/freertos esp_additions/include; do
    flags+=("-I$kernel/$folder")
  done
}
