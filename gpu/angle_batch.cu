#include "gpu/angle_batch.h"
#include "gpu/angles.h"
#include "gpu/buffer.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

struct AngleBatch {
  View<const double> x;
  View<AngleValues> values;

  GABARIT_HD void operator()(std::int64_t i) const {
    const SineCosine turn = sine_cosine(x[i]);
    const HyperbolicSineCosine bend = hyperbolic_sine_cosine(x[i]);
    values[i] = {turn.sine, turn.cosine, angle_of(x[i], 1), arc_cosine(x[i] / (1 + std::fabs(x[i]))),
                 bend.sine, bend.cosine};
  }
};

}  // namespace

std::vector<AngleValues> angle_values(const Device& device, std::span<const double> x) {
  const Buffer<double> there(device, x);
  auto values = Buffer<AngleValues>::of_size(device, there.size());
  parallel_for(device, there.size(), AngleBatch{there.view(), values.view()});
  return std::move(values).read();
}

}  // namespace gabarit
