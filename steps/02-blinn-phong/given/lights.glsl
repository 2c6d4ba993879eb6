// The lights and the material of step 02, as the program sends them. Given. World space, linear light.

struct Material {
  vec3 diffuse;    // kd
  vec3 specular;   // ks
  float exponent;  // n
};

struct PointLight {
  vec3 position;
  vec3 colour;
  vec3 attenuation;  // constant, linear, quadratic
};

struct SpotLight {
  vec3 position;
  vec3 direction;  // unit vector: the direction in which the light travels
  vec3 colour;
  vec3 attenuation;
  vec2 cosines;  // of the inner and the outer angle: cone_cosines
};

struct DirectionalLight {
  vec3 direction;  // unit vector: the direction in which the light travels
  vec3 colour;
};

// POINT_LIGHTS, SPOT_LIGHTS and DIRECTIONAL_LIGHTS are the numbers of lights in the scene. GLSL has no arrays of size
// zero: put each loop between #if POINT_LIGHTS > 0 and #endif.
#if POINT_LIGHTS > 0
uniform PointLight u_point_lights[POINT_LIGHTS];
#endif
#if SPOT_LIGHTS > 0
uniform SpotLight u_spot_lights[SPOT_LIGHTS];
#endif
#if DIRECTIONAL_LIGHTS > 0
uniform DirectionalLight u_directional_lights[DIRECTIONAL_LIGHTS];
#endif
uniform vec3 u_ambient;

#ifdef LIGHT_SPACE
// A later step computes light in a space of its own: below, the names of the lights stand for copies in that space.
#if POINT_LIGHTS > 0
PointLight point_light_in_world(int i) { return u_point_lights[i]; }
PointLight point_lights_there[POINT_LIGHTS];
#define u_point_lights point_lights_there
#endif
#if SPOT_LIGHTS > 0
SpotLight spot_light_in_world(int i) { return u_spot_lights[i]; }
SpotLight spot_lights_there[SPOT_LIGHTS];
#define u_spot_lights spot_lights_there
#endif
#if DIRECTIONAL_LIGHTS > 0
DirectionalLight directional_light_in_world(int i) { return u_directional_lights[i]; }
DirectionalLight directional_lights_there[DIRECTIONAL_LIGHTS];
#define u_directional_lights directional_lights_there
#endif
#endif

// Whether a light shines on this surface at all: those that are too weak to be seen on it are left out.
#ifdef POINT_LIGHTS_HERE
const int point_lights_here[POINT_LIGHTS] = int[](POINT_LIGHTS_HERE);
bool point_light_is_here(int light) { return point_lights_here[light] != 0; }
#else
bool point_light_is_here(int light) { return true; }
#endif
#ifdef SPOT_LIGHTS_HERE
const int spot_lights_here[SPOT_LIGHTS] = int[](SPOT_LIGHTS_HERE);
bool spot_light_is_here(int light) { return spot_lights_here[light] != 0; }
#else
bool spot_light_is_here(int light) { return true; }
#endif
#ifdef DIRECTIONAL_LIGHTS_HERE
const int directional_lights_here[DIRECTIONAL_LIGHTS] = int[](DIRECTIONAL_LIGHTS_HERE);
bool directional_light_is_here(int light) { return directional_lights_here[light] != 0; }
#else
bool directional_light_is_here(int light) { return true; }
#endif

// The visibility of each light at the shaded point: the fraction of its light that arrives, 0 to 1; 1 if the program
// uses no shadows, and 0 if the light is left out here. The argument is the light's index in its array. The values are
// computed before `shade` is called, so these functions may be called anywhere, also in branches.
#ifdef VISIBILITY
#if POINT_LIGHTS > 0
float point_visibility[POINT_LIGHTS];
#endif
#if SPOT_LIGHTS > 0
float spot_visibility[SPOT_LIGHTS];
#endif
#if DIRECTIONAL_LIGHTS > 0
float directional_visibility[DIRECTIONAL_LIGHTS];
#endif
#endif

float visible_from_point(int light) {
#if defined(VISIBILITY) && POINT_LIGHTS > 0
  return point_visibility[light];
#else
  return point_light_is_here(light) ? 1.0 : 0.0;
#endif
}

float visible_from_spot(int light) {
#if defined(VISIBILITY) && SPOT_LIGHTS > 0
  return spot_visibility[light];
#else
  return spot_light_is_here(light) ? 1.0 : 0.0;
#endif
}

float visible_from_directional(int light) {
#if defined(VISIBILITY) && DIRECTIONAL_LIGHTS > 0
  return directional_visibility[light];
#else
  return directional_light_is_here(light) ? 1.0 : 0.0;
#endif
}

#if POWER == 2
uniform sampler2D u_power_table;  // one row; red is x^n
#endif
