#include "report/render/shade.h"

#include <algorithm>
#include <cmath>

#include "report/render.h"

namespace gabarit {
namespace {

struct Look {
  Light light;
  PageNormal normal;
};

constexpr Vec3f key_light{-0.41F, 0.58F, 0.704F};
constexpr Vec3f fill_light{0.80F, 0.10F, 0.592F};
constexpr Vec3f half_way{-0.222F, 0.314F, 0.923F};  // between the key light and the eye

// How bright a white facet with this normal (toward the eye) is, before the sheen.
float brightness(const Vec3f& n) {
  const float sky = 0.46F + 0.12F * n.y;
  const float key = 0.66F * std::max(0.0F, dot(n, key_light));
  const float fill = 0.16F * std::max(0.0F, dot(n, fill_light));
  const float grazing = (1 - n.z) * (1 - n.z) * (1 - n.z);
  return (sky + key + fill) * (1 - 0.35F * grazing);
}

// Strong colours carry a meaning and stay what they are: 1 for grey, 0 for a pure colour.
float paleness(Rgb c) {
  const int most = std::max({c.r, c.g, c.b});
  return most == 0 ? 1.0F : static_cast<float>(std::min({c.r, c.g, c.b})) / static_cast<float>(most);
}

// Past this a channel would be cut off and the hue change.
float most_brightness(Rgb c) {
  const float most = std::max({c.r, c.g, c.b, std::uint8_t{1}});
  return 65025.0F / (most * most);
}

float sheen(const Vec3f& n) {
  float s = std::max(0.0F, dot(n, half_way));
  for (int i = 0; i < 5; ++i) s *= s;  // to the 32nd power
  return 0.14F * s;
}

std::uint16_t channel(std::uint8_t base, float bright, float shine, float strength) {
  const float full = static_cast<float>(base) * static_cast<float>(base);
  const float lit = full * bright + (65025.0F - full * bright) * shine;
  const float faint = 65025.0F - (65025.0F - lit) * strength;
  return static_cast<std::uint16_t>(std::lround(std::clamp(faint, 0.0F, 65025.0F)));
}

std::int8_t packed(float component) {
  return static_cast<std::int8_t>(std::lround(std::clamp(component, -1.0F, 1.0F) * 127.0F));
}

bool is_faint(const Drawing& drawing, FacetId f) {
  return !drawing.emphasis.empty() && drawing.emphasis[f] == 0;
}

Look look_of(const Facets& facets, FacetId f) {
  const Drawing& drawing = *facets.drawing;
  Vec3f n = facets.screen->page_direction(facet_normal(*drawing.mesh, f));
  if (n.z < 0) n = -n;
  if (n == Vec3f{}) n = {0, 0, 1};
  const float strength = is_faint(drawing, f) ? 0.35F : 1.0F;
  const Rgb base = drawing.facet_colours.empty() ? drawing.plain : drawing.facet_colours[f];
  const float bright = std::min(brightness(n), most_brightness(base));
  const float shine = sheen(n) * paleness(base);
  return {{channel(base.r, bright, shine, strength), channel(base.g, bright, shine, strength),
           channel(base.b, bright, shine, strength)},
          {packed(n.x), packed(n.y), packed(n.z)}};
}

std::uint16_t mixed(std::uint16_t a, std::uint16_t b) { return static_cast<std::uint16_t>((3 * a + b) / 4); }

// An emphasised facet seen through the faint skin in front of it.
Light behind(Light light, Light skin) {
  return {mixed(light.r, skin.r), mixed(light.g, skin.g), mixed(light.b, skin.b)};
}

}  // namespace

void shade(const Facets& facets, Tile& tile) {
  const Light paper = light_of(facets.drawing->background);
  FacetId last = no_facet;
  FacetId last_skin = no_facet;
  Look look;
  Look skin;
  for (std::size_t i = 0; i < samples_in_tile; ++i) {
    const FacetId f = tile.front.facet[i];
    tile.cover[i] = Cover::paper;
    tile.light[i] = paper;
    if (f == no_facet) continue;
    tile.cover[i] = is_faint(*facets.drawing, f) ? Cover::faint : Cover::facet;
    if (f != last) look = look_of(facets, f), last = f;
    tile.light[i] = look.light;
    tile.normal[i] = look.normal;
    if (tile.skin.empty() || tile.skin[i] == no_facet) continue;
    if (tile.skin[i] != last_skin) skin = look_of(facets, tile.skin[i]), last_skin = tile.skin[i];
    tile.light[i] = behind(look.light, skin.light);
    tile.cover[i] = Cover::faint;
  }
}

}  // namespace gabarit
