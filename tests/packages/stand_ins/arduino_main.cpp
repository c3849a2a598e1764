// A sketch as the Arduino IDE compiles it: its text after Arduino.h and the prototypes of its
// functions, and a main program.
#include <Arduino.h>

void setup();
void loop();

#include SKETCH

int main() {
  setup();
#ifdef LOOPS
  for (;;) {
    loop();
    world::pass(1);
  }
#endif
  return 0;
}
