// What stands for your hardware here: a motor with a mass on its shaft, and an encoder that fails
// now and then.
#pragma once

class Motor {
 public:
  /// rad; NaN while the encoder fails, 5 of every 400 times.
  float read_encoder() {
    const bool fails = reads_++ % 400 >= 395;
    return fails ? __builtin_nanf("") : angle_;
  }

  /// For one period of the controller.
  void apply(float voltage) { move(angle_, speed_, voltage); }

  float angle() const { return angle_; }

  /// 2 ms with a voltage in V; angle in rad, speed in rad/s. Euler's method.
  static constexpr void move(float& angle, float& speed, float voltage) {
    constexpr float kPeriod = 0.002F;  // s
    constexpr float kGain = 20.0F;     // rad/s² per V
    constexpr float kDamping = 4.0F;   // 1/s
    angle += kPeriod * speed;
    speed += kPeriod * (kGain * voltage - kDamping * speed);
  }

 private:
  float angle_ = 0.0F;  // rad
  float speed_ = 0.0F;  // rad/s
  unsigned reads_ = 0;
};
