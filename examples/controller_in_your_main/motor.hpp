// Replaces your hardware: a motor with a mass on its shaft, and an encoder that sometimes
// fails.
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

  /// 2 ms with a voltage in V; angle in rad, speed in rad/s. Euler's method. `Real`: float, or the
  /// type of a simulation, such as one for many motors at once.
  template <class Real>
  static constexpr void move(Real& angle, Real& speed, Real voltage) {
    constexpr auto kPeriod = Real(0.002F);  // s
    constexpr auto kGain = Real(20.0F);     // rad/s² per V
    constexpr auto kDamping = Real(4.0F);   // 1/s
    angle += kPeriod * speed;
    speed += kPeriod * (kGain * voltage - kDamping * speed);
  }

 private:
  float angle_ = 0.0F;  // rad
  float speed_ = 0.0F;  // rad/s
  unsigned reads_ = 0;
};
