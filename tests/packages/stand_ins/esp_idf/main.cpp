// ESP-IDF starts the program.
extern "C" void app_main();

int main() {
  app_main();
  return 0;
}
