// The metallic-roughness surface of glTF with its clear coat. GGX: Walter 2007; visibility: Heitz 2014, as Lagarde and
// de Rousiers 2014 write it; what the environment sends: Karis 2014, the fit for mobile.
#ifndef UNGHOST_BRDF_GLSL
#define UNGHOST_BRDF_GLSL

const float pi = 3.14159265358979;

struct Surface {
  vec3 albedo;
  float occlusion;
  vec3 normal;
  float roughness, metalness, coat, coat_roughness;
};

float ggx(float n_h, float alpha) {
  float a2 = alpha * alpha;
  float d = (n_h * a2 - n_h) * n_h + 1;
  return a2 / (pi * d * d);
}

float smith_visibility(float n_v, float n_l, float alpha) {
  float a2 = alpha * alpha;
  float v = n_l * sqrt(n_v * n_v * (1 - a2) + a2);
  float l = n_v * sqrt(n_l * n_l * (1 - a2) + a2);
  return 0.5 / max(v + l, 1e-5);
}

float fresnel_weight(float cosine) {
  float m = clamp(1 - cosine, 0, 1);
  float m2 = m * m;
  return m2 * m2 * m;
}

/// Share of the light from `to_light` that leaves towards `to_eye`, the cosine at the surface included. A light that is no point widens the lobe to at least `source_alpha`.
vec3 reflect_light(Surface s, vec3 to_eye, vec3 to_light, float source_alpha) {
  vec3 h = normalize(to_eye + to_light);
  float n_l = clamp(dot(s.normal, to_light), 0, 1), n_v = clamp(dot(s.normal, to_eye), 1e-3, 1);
  // a normal that a map or an artist turned away from the eye would mirror a light behind it
  float faces = smoothstep(-0.1, 0.1, dot(s.normal, to_eye));
  float n_h = clamp(dot(s.normal, h), 0, 1), l_h = clamp(dot(to_light, h), 0, 1);
  float f = fresnel_weight(l_h);
  vec3 f0 = mix(vec3(0.04), s.albedo, s.metalness);
  vec3 fresnel = f0 + (1 - f0) * f;
  float alpha = max(s.roughness * s.roughness, source_alpha);
  vec3 diffuse = (1 - fresnel) * (1 - s.metalness) * s.albedo / pi;
  vec3 base = diffuse + fresnel * (faces * ggx(n_h, alpha) * smith_visibility(n_v, n_l, alpha));
  if (s.coat > 0) {
    float coat_alpha = max(s.coat_roughness * s.coat_roughness, source_alpha);
    float coat_fresnel = (0.04 + 0.96 * f) * s.coat;
    base = base * (1 - coat_fresnel) + coat_fresnel * faces * ggx(n_h, coat_alpha) * smith_visibility(n_v, n_l, coat_alpha);
  }
  return base * n_l;
}

/// Share of the environment's radiance that a specular lobe returns.
vec3 environment_share(vec3 f0, float roughness, float n_v) {
  const vec4 c0 = vec4(-1, -0.0275, -0.572, 0.022), c1 = vec4(1, 0.0425, 1.04, -0.04);
  vec4 r = roughness * c0 + c1;
  float a = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
  vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
  return f0 * ab.x + ab.y;
}

#endif
