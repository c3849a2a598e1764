// eagerx/scene.hpp, eagerx/picture.hpp: scenes as messages, and their pixels.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <eagerx/picture.hpp>
#include <eagerx/random.hpp>
#include <eagerx/scene.hpp>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace eagerx {
namespace {

using Drawing = Array<float, 12, 16>;
using PainterType = picture::Painter<256>;

/// The pixels of a scene, one channel or three.
std::vector<std::uint8_t> paint(const float* scene, std::size_t rows, int width, int height,
                                int channels) {
  static const auto kPainter = std::make_unique<PainterType>();
  // Earlier contents of the image have no effect.
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height * channels), 77);
  kPainter->paint(scene, rows, {pixels.data(), width, height, channels});
  return pixels;
}
std::vector<std::uint8_t> grey(const Drawing& scene, int width = 64, int height = 64) {
  return paint(scene.data, 12, width, height, 1);
}
/// How much of a black shape on white there is, in pixels.
double area(const std::vector<std::uint8_t>& pixels) {
  double sum = 0.0;
  for (const std::uint8_t p : pixels) sum += (255.0 - p) / 255.0;
  return sum;
}
std::uint64_t hash(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t h = 0xcbf29ce484222325U;
  for (const std::uint8_t byte : bytes) h = (h ^ byte) * 0x100000001b3U;
  return h;
}

/// White, 64 high and wide: a pixel is a metre.
Drawing empty() {
  Drawing message{};
  SceneWriter(message).view({}, 64.0F, 0xffffff);
  return message;
}

TEST(Scene, HasItsNumbersInItsRows) {
  Drawing message = filled<Drawing>(9.0F);
  SceneWriter scene(message);
  scene.circle({1.0F, 2.0F}, 3.0F, stroke(0xff8001, 0.5F, 0.25F));
  scene.on_screen();
  scene.number({0.1F, 0.2F}, 0.3F, "u = # V", -4.5F, 2, 0x000001, Align::right);
  EXPECT_EQ(scene.rows(), 2U);
  const SceneRow circle = SceneRow::read(message.data);
  EXPECT_EQ(circle.shape, Shape::circle);
  EXPECT_FALSE(circle.on_screen);
  EXPECT_EQ(circle.ink.colour, 0xff8001U);
  EXPECT_EQ(circle.ink.opacity, 0.25F);
  EXPECT_EQ(circle.ink.width, 0.5F);
  EXPECT_EQ(circle.n[2], 3.0F);
  const SceneRow text = SceneRow::read(message.data + 16);
  EXPECT_TRUE(text.on_screen);
  std::string read;
  for (std::size_t i = 0; i < kSceneCharacters && text.character(i) != 0; ++i)
    read.push_back(static_cast<char>(text.character(i)));
  EXPECT_EQ(read, "u = # V");
  EXPECT_EQ(SceneRow::read(message.data + 32).shape, Shape::none);
}

TEST(Scene, IsDrawnOnWhereItEnds) {
  const Drawing base = empty();
  Drawing message{};
  SceneWriter scene(message, base);
  scene.circle({}, 1.0F, fill(0));
  EXPECT_EQ(scene.rows(), 2U);
  EXPECT_EQ(message[0], base[0]);
  EXPECT_EQ(SceneRow::read(message.data + 16).shape, Shape::circle);
}

TEST(Scene, LeavesOutWhatHasNoRoom) {
  Array<float, 2, 16> small{};
  SceneWriter scene(small);
  for (int i = 0; i < 5; ++i) scene.circle({}, static_cast<float>(i), fill(0));
  EXPECT_EQ(scene.rows(), 2U);
  EXPECT_EQ(small[16 + 6], 1.0F);
}

TEST(Picture, CoversAsMuchAsAShapeHas) {
  const struct {
    const char* name;
    void (*draw)(SceneWriter<Drawing>&);
    double area, error;
  } cases[] = {
      {"rectangle",
       [](auto& s) {
         s.rectangle({0.3F, -1.7F}, 10.5F, 20.25F, fill(0));
       },
       10.5 * 20.25, 0.5},
      {"turned", [](auto& s) { s.rectangle({}, 20.0F, 10.0F, fill(0), 0.7F); }, 200.0, 0.5},
      {"disc", [](auto& s) { s.circle({}, 20.0F, fill(0)); }, 400.0 * std::numbers::pi, 3.0},
      {"ring", [](auto& s) { s.circle({}, 20.0F, stroke(0, 2.0F)); }, 80.0 * std::numbers::pi, 1.5},
      {"line",
       [](auto& s) {
         s.line({-20.0F, 3.0F}, {20.0F, 3.0F}, stroke(0, 2.0F));
       },
       80.0 + std::numbers::pi, 0.5},
      {"triangle",
       [](auto& s) {
         s.polygon({{0.0F, 0.0F}, {0.0F, 20.0F}, {10.0F, 0.0F}}, fill(0));
       },
       100.0, 0.5},
      {"beyond the borders", [](auto& s) { s.circle({}, 1000.0F, fill(0)); }, 64.0 * 64.0, 0.0},
      {"half outside",
       [](auto& s) {
         s.rectangle({-32.0F, 0.0F}, 20.0F, 10.0F, fill(0));
       },
       100.0, 0.5},
      {"half outside, right",
       [](auto& s) {
         s.rectangle({32.0F, 0.0F}, 20.0F, 10.0F, fill(0), 0.2F);
       },
       100.0, 0.7},
      {"above",
       [](auto& s) {
         s.circle({0.0F, 200.0F}, 20.0F, fill(0));
       },
       0.0, 0.0},
  };
  for (const auto& each : cases) {
    Drawing message = empty();
    SceneWriter scene(message, empty());
    each.draw(scene);
    EXPECT_NEAR(area(grey(message)), each.area, each.error) << each.name;
  }
}

TEST(Picture, PaintsWhatLiesOnItselfOnce) {
  Drawing message{};
  SceneWriter scene(message, empty());
  scene.polyline({{-20.0F, 0.0F}, {20.0F, 0.0F}, {-20.0F, 0.0F}}, stroke(0, 4.0F, 0.5F));
  const auto pixels = grey(message);
  EXPECT_EQ(pixels[32 * 64 + 32], 128);
}

TEST(Picture, HasRightOnTheRightAndUpAbove) {
  Drawing message{};
  SceneWriter scene(message, empty());
  scene.rectangle({20.0F, 10.0F}, 4.0F, 4.0F, fill(0));
  const auto pixels = grey(message);
  EXPECT_EQ(pixels[22 * 64 + 52], 0);
  EXPECT_EQ(pixels[42 * 64 + 52], 255);
}

TEST(Picture, ColoursAndOpacityAreMixed) {
  Drawing message{};
  SceneWriter scene(message, empty());
  scene.rectangle({}, 10.0F, 10.0F, fill(0xff0000, 0.5F));
  const auto pixels = paint(message.data, 12, 64, 64, 3);
  const std::size_t middle = 3 * (32 * 64 + 32);
  EXPECT_EQ(pixels[middle], 255);
  EXPECT_NEAR(pixels[middle + 1], 127, 1);
  EXPECT_NEAR(pixels[middle + 2], 127, 1);
}

std::string written(float value, int decimals) {
  picture::Line line;
  line.add_number(value, decimals);
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) text.push_back(static_cast<char>(line[i]));
  return text;
}
TEST(Picture, NumbersAreRounded) {
  EXPECT_EQ(written(0.0F, 0), "0");
  EXPECT_EQ(written(-0.75F, 2), "-0.75");
  EXPECT_EQ(written(12.345F, 1), "12.3");
  EXPECT_EQ(written(0.06F, 1), "0.1");
  EXPECT_EQ(written(-0.001F, 2), "0.00");
  EXPECT_EQ(written(999.96F, 1), "1000.0");
  EXPECT_EQ(written(1e20F, 0), "***");
  EXPECT_EQ(written(std::nanf(""), 3), "nan");
}

TEST(Picture, TheNearerShapeOfSpaceIsSeen) {
  for (const bool turned : {false, true}) {
    Drawing message{};
    SceneWriter scene(message);
    scene.camera({0.0F, -3.0F, 0.0F}, {}, 0.8F, 0xffffff);
    const auto add = [&](bool near) {
      scene.sphere({0.0F, near ? -1.0F : 1.0F, 0.0F}, near ? 0.1F : 0.5F,
                   near ? 0x00ff00 : 0xff0000);
    };
    add(turned), add(!turned);
    const auto pixels = paint(message.data, 12, 64, 64, 3);
    const std::size_t middle = 3 * (32 * 64 + 32);
    EXPECT_EQ(pixels[middle], 0);
    EXPECT_GT(pixels[middle + 1], 150);
  }
}

TEST(Picture, NothingBehindTheCameraIsSeen) {
  Drawing message{};
  SceneWriter scene(message);
  scene.camera({0.0F, -3.0F, 0.0F}, {}, 0.8F, 0xffffff);
  scene.box({{0.0F, -5.0F, 0.0F}}, {1.0F, 1.0F, 1.0F}, 0);
  scene.sphere({0.0F, -3.0F, 0.0F}, 1.0F, 0);
  scene.capsule({{0.0F, -4.0F, 0.0F}}, 0.5F, 1.0F, 0);
  scene.segment({0.0F, -4.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, points(0, 3.0F));
  EXPECT_EQ(area(grey(message)), 0.0);
}

TEST(Picture, FacetsAreFlatPiecesInSpace) {
  const auto seen = [](const Point3(&corners)[4]) {
    Drawing message{};
    SceneWriter scene(message);
    scene.camera({0.0F, -3.0F, 0.0F}, {}, 0.8F, 0xffffff);
    scene.facet(corners, 0x000000);
    return area(grey(message));
  };
  // 64 pixels are 0.8 rad, and a meter is 3 m away.
  const double side = 32.0 / std::tan(0.4) / 3.0, square = side * side;
  EXPECT_NEAR(seen({{-0.5F, 0, -0.5F}, {0.5F, 0, -0.5F}, {0.5F, 0, 0.5F}, {-0.5F, 0, 0.5F}}),
              square, 0.01 * square);
  EXPECT_NEAR(seen({{-0.5F, 0, -0.5F}, {0.5F, 0, -0.5F}, {0.5F, 0, 0.5F}, {0.5F, 0, 0.5F}}),
              0.5 * square, 0.01 * square);
  EXPECT_NEAR(seen({{-0.5F, 0, 0.5F}, {0.5F, 0, 0.5F}, {0.5F, 0, -0.5F}, {-0.5F, 0, -0.5F}}),
              square, 0.01 * square)
      << "from behind, too";
  EXPECT_EQ(seen({{-0.5F, -4, -0.5F}, {0.5F, -4, -0.5F}, {0.5F, 0, 0.5F}, {-0.5F, 0, 0.5F}}), 0.0)
      << "partly behind the camera";
}

TEST(Picture, FacetsAreLitOnTheSideThatIsSeen) {
  const auto light = [](const Point3(&corners)[4]) {
    Drawing message{};
    SceneWriter scene(message);
    scene.camera({0.0F, -1.0F, 3.0F}, {}, 0.8F, 0x000000);
    scene.facet(corners, 0x808080);
    return grey(message)[32 * 64 + 32];
  };
  const int above = light({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  EXPECT_EQ(light({{-1, 1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}}), above);
  EXPECT_LT(light({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}), above) << "upright";
}

/// One of everything.
Drawing everything() {
  Drawing message{};
  SceneWriter scene(message);
  scene.camera({1.2F, -1.5F, 0.9F}, {0.0F, 0.0F, 0.2F}, 0.7F, 0xe4ecf1);
  scene.plane({}, 2.0F, 0.25F, 0xdad6ca);
  scene.box({{0.0F, 0.0F, 0.3F}, 0.98F, 0.0F, 0.0F, 0.199F}, {0.5F, 0.25F, 0.12F}, 0x4a78a8);
  scene.sphere({0.4F, 0.3F, 0.1F}, 0.1F, 0xc0553b);
  scene.capsule({{0.25F, -0.13F, 0.15F}, 0.954F, 0.3F, 0.0F, 0.0F}, 0.04F, 0.22F, 0xe0a030);
  scene.cylinder({{-0.4F, -0.1F, 0.1F}, 0.924F, 0.383F, 0.0F, 0.0F}, 0.1F, 0.2F, 0x5a9a68);
  scene.segment({}, {0.0F, 0.0F, 0.8F}, points(0x333333, 2.0F));
  scene.on_screen();
  scene.arrow({0.1F, 0.1F}, {0.9F, 0.2F}, 0.1F, stroke(0xc0392b, 0.02F, 0.7F));
  scene.polygon({{0.05F, 0.5F}, {0.2F, 0.55F}, {0.1F, 0.7F}}, points(0x884499, 3.0F));
  scene.rectangle({0.8F, 0.8F}, 0.2F, 0.1F, fill(0x3d8c6a, 0.8F), 0.4F, 0.03F);
  scene.number({0.5F, 0.9F}, 0.05F, "gGqQ8&@ # m", 3.14159F, 3, 0x222222, Align::middle);
  scene.circle({0.3F, 0.3F}, 0.1F, stroke(0x224466, 0.01F));
  return message;
}

// The same in tests/firmware, on boards. A change of these is one of all recorded pictures.
TEST(Picture, HasTheSamePixelsEverywhere) {
  const Drawing message = everything();
  EXPECT_EQ(hash(paint(message.data, 12, 160, 120, 3)), 10362177785749545618U);
  EXPECT_EQ(hash(paint(message.data, 12, 97, 64, 1)), 10170641900886394426U);
}

TEST(Picture, NumbersOfAnyKindDoNoHarm) {
  constexpr float kOdd[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::max(),
                            std::numeric_limits<float>::denorm_min(),
                            -1e9F,
                            1e9F,
                            -1.0F,
                            0.0F,
                            1e-30F,
                            5e6F,
                            0.5F};
  std::uint64_t seed = 1;
  const auto next = [&seed](std::uint64_t below) {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    return (seed >> 33U) % below;
  };
  for (int i = 0; i < 3000; ++i) {
    Drawing message = everything();
    for (int k = 0; k < 8; ++k) message[next(12 * 16)] = kOdd[next(std::size(kOdd))];
    if (i % 3 == 0) message[next(12) * 16] = static_cast<float>(next(80));
    const int width = 16 + static_cast<int>(next(60)), height = 16 + static_cast<int>(next(60));
    const auto first = paint(message.data, 12, width, height, 3);
    // Nothing is left of a picture for the next.
    if (i % 10 == 0) {
      EXPECT_EQ(first, paint(message.data, 12, width, height, 3));
    }
  }
}

}  // namespace
}  // namespace eagerx
