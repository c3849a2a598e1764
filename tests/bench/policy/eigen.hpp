// The networks with Eigen's fixed-size products, weights by column as Eigen has them by
// default, and its own tanh.
#pragma once

#include <Eigen/Dense>

#include "sampler.hpp"

namespace bench {

template <int A, int B, bool Relu, int Order = Eigen::ColMajor>
struct EigenMlp {
  template <int Rows, int Columns>
  using Weights = Eigen::Matrix<float, Rows, Columns, Rows == 1 ? Eigen::RowMajor : Order>;
  template <int Rows>
  using Vector = Eigen::Matrix<float, Rows, 1>;

  Weights<A, 3> w1;
  Weights<B, A> w2;
  Weights<1, B> w3;
  Vector<A> b1;
  Vector<B> b2;

  EigenMlp() {
    Sampler sampler;
    const auto next = [&] { return sampler.next(); };
    w1 = Weights<A, 3>::NullaryExpr(next);
    w2 = Weights<B, A>::NullaryExpr(next);
    w3 = Weights<1, B>::NullaryExpr(next);
    b1 = Vector<A>::NullaryExpr(next);
    b2 = Vector<B>::NullaryExpr(next);
  }

  template <class Values>
  static Values activated(const Values& y) {
    if constexpr (Relu) return y.cwiseMax(0.0F);
    return y.array().tanh().matrix();
  }
  [[gnu::noinline]] void run(const float (&x)[3], float (&y)[1]) const {
    const Eigen::Map<const Eigen::Vector3f> in(x);
    Vector<A> h1 = b1;
    h1.noalias() += w1 * in;
    h1 = activated(h1);
    Vector<B> h2 = b2;
    h2.noalias() += w2 * h1;
    h2 = activated(h2);
    const Eigen::Array<float, 1, 1> out = (w3 * h2).array().tanh();
    y[0] = out(0);
  }
};

}  // namespace bench
