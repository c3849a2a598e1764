// Zephyr's devices: a watchdog.
#pragma once

struct device {
  const char* name;
  bool is_ready;
};
#define DEVICE_DT_GET(node) (&world_##node)
inline bool device_is_ready(const device* of) {
  return of->is_ready;
}
