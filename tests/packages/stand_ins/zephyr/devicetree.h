// A devicetree with the alias watchdog0, if the application's overlay for the board makes it.
#pragma once

#include <zephyr/device.h>

#define DT_ALIAS(name) name
#ifdef DT_HAS_WATCHDOG0
#define DT_NODE_HAS_STATUS(node, status) 1
#else
#define DT_NODE_HAS_STATUS(node, status) 0
#endif
#define world_DT_ALIAS(name) world_##name
inline constexpr device world_watchdog0{"watchdog@40003000", true};
