#include "model/bernstein.h"

#include <algorithm>
#include <cmath>

namespace gabarit {
namespace {

constexpr int deepest = 46;  // halvings: 1e-14 of the interval

int sign(double x) { return (x > 0) - (x < 0); }

int changes_of_sign(const std::vector<double>& c) {
  int changes = 0, last = 0;
  for (const double x : c) {
    if (x == 0) continue;
    changes += last * sign(x) < 0 ? 1 : 0;
    last = sign(x);
  }
  return changes;
}

// De Casteljau at the middle: `c` becomes the left half.
std::vector<double> split(std::vector<double>& c) {
  std::vector<double> right(c.size());
  const std::size_t n = c.size();
  std::vector<double> row = c;
  for (std::size_t k = 0; k < n; ++k) {
    c[k] = row[0], right[n - 1 - k] = row[n - 1 - k];
    for (std::size_t i = 0; i + k + 1 < n; ++i) row[i] = (row[i] + row[i + 1]) / 2;
  }
  return right;
}

double binomial(std::size_t n, std::size_t k) {
  double b = 1;
  for (std::size_t i = 1; i <= k; ++i) b *= static_cast<double>(n - k + i) / static_cast<double>(i);
  return b;
}

Pole mixed(const Pole& a, const Pole& b, double t) {
  const double s = 1 - t;
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z, s * a.w + t * b.w};
}

}  // namespace

void SignChanges::add(std::vector<double> coefficients, double from, double to, double noise) {
  for (double& c : coefficients) c = std::abs(c) > noise ? c : 0;
  walk(coefficients, from, to, 0);
}

void SignChanges::walk(std::vector<double>& c, double from, double to, int depth) {
  const double middle = from + (to - from) / 2;
  if (changes_of_sign(c) == 0 || depth == deepest) {
    const auto not_zero = [](double x) { return x != 0; };
    const auto first = std::find_if(c.begin(), c.end(), not_zero);
    if (first == c.end()) return;
    const int begins = sign(*first), ends = sign(*std::find_if(c.rbegin(), c.rend(), not_zero));
    if (last_sign_ * begins < 0) at_.push_back(from);
    if (begins * ends < 0) at_.push_back(middle);
    last_sign_ = ends;
    return;
  }
  std::vector<double> right = split(c);
  walk(c, from, middle, depth + 1);
  walk(right, middle, to, depth + 1);
}

// Pole j is the blossom of the span at (from, …, from, to, …, to) with `to` j times.
std::vector<Pole> bezier_poles(const Brep& brep, const Curve& curve, int span) {
  const double* const knots = brep.knots.data() + curve.first_knot;
  const Pole* const poles = brep.poles.data() + curve.first_pole + (span - curve.degree);
  const auto p = static_cast<std::size_t>(curve.degree);
  std::vector<Pole> bezier(p + 1);
  for (std::size_t j = 0; j <= p; ++j) {
    std::vector<Pole> row(poles, poles + p + 1);
    for (std::size_t r = 1; r <= p; ++r) {
      const double t = r <= j ? knots[span + 1] : knots[span];
      for (std::size_t i = 0; i + r <= p; ++i) {
        const double low = knots[span - curve.degree + static_cast<int>(i + r)];
        const double high = knots[span + 1 + static_cast<int>(i)];
        row[i] = mixed(row[i], row[i + 1], (t - low) / (high - low));
      }
    }
    bezier[j] = row[0];
  }
  return bezier;
}

std::vector<double> quotient_slope(const std::vector<double>& a, const std::vector<double>& b) {
  const std::size_t p = a.size() - 1;
  std::vector<double> slope(2 * p, 0.0);
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j <= p; ++j) {
      const double factor =
          static_cast<double>(p) * binomial(p - 1, i) * binomial(p, j) / binomial(2 * p - 1, i + j);
      slope[i + j] += factor * ((a[i + 1] - a[i]) * b[j] - a[j] * (b[i + 1] - b[i]));
    }
  }
  return slope;
}

}  // namespace gabarit
