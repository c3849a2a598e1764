// What the Arduino IDE makes of a sketch: its text behind Arduino.h, and a main program.
#include <Arduino.h>

#include SKETCH

int main() {
  setup();
  return 0;
}
