// Zephyr's, on Linux.
#pragma once

#include <cstdio>

#define printk(...) std::printf(__VA_ARGS__)
