// One way into the heap, or what comes with it, for each image. None of them may link.
#ifdef USES_new
int* volatile sink;
int main() {
  sink = new int(1);
  return 0;
}
#endif
#ifdef USES_vector
#include <vector>
int main(int count, char**) {
  const std::vector<int> values(static_cast<unsigned>(count));
  return values.back();
}
#endif
#ifdef USES_printf
#include <cstdio>
int main() {
  return std::printf("%f\n", 1.0);
}
#endif
#ifdef USES_malloc
#include <cstdlib>
void* volatile sink;
int main() {
  sink = std::malloc(1);
  return 0;
}
#endif
#ifdef USES_throwing
int main(int count, char**) {
  if (count > 1) throw count;
  return 0;
}
#endif
#ifdef USES_guarded_static
int first();
__attribute__((noinline)) int value() {
  static int once = first();
  return once;
}
int main() {
  return value();
}
int first() {
  return static_cast<int>(reinterpret_cast<unsigned long>(&value));
}
#endif
#ifdef USES_plain_guard
int first();
__attribute__((noinline)) int value() {
  static int once = first();
  return once;
}
int main() {
  return value();
}
int first() {
  return static_cast<int>(reinterpret_cast<unsigned long>(&value));
}
#endif
#ifdef USES_type_name
#include <typeinfo>
struct Shape {
  virtual int corners() const { return 0; }
};
struct Square : Shape {
  int corners() const override { return 4; }
};
Square square;
Shape* volatile shape = &square;
int main() {
  const Shape& seen = *shape;
  return typeid(seen).hash_code() != 0 ? seen.corners() : 1;
}
#endif
