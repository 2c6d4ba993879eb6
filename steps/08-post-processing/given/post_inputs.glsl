// Uniforms of step 08's shaders. Given.
#ifndef POST_INPUTS
#define POST_INPUTS

// Bloom: half of a Gaussian filter, u_weights[k] for a distance of k pixels, 0 <= k <= LAST_WEIGHT.
#ifndef LAST_WEIGHT
#define LAST_WEIGHT 0
#endif
uniform float u_weights[LAST_WEIGHT + 1];

uniform float u_table_size;  // grid points along each axis of the table of colours

#endif
