// Plain sampling by solid angle, for comparison only: a cone around the light's centre (M. Pharr, W. Jakob, G. Humphreys,
// "Physically Based Rendering", 2016), in a frame without branches (T. Duff and others, "Building an Orthonormal Basis,
// Revisited", 2017).

struct solid_angle_sample {
    vec3 direction;
    float pdf;
};

solid_angle_sample solid_angle_sample_once(vec3 normal, vec3 centre, float radius, float u0, float u1) {
    float inv_distance2 = 1.0 / dot(centre, centre);
    vec3 towards = centre * sqrt(inv_distance2);
    float sin2 = radius * radius * inv_distance2;
    float height = sin2 / (1.0 + sqrt(max(0.0, 1.0 - sin2))); // 1 - cos
    float fallen = u0 * height;
    float across = sqrt(fallen * (2.0 - fallen)), angle = 6.2831853 * u1;
    float s = towards.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + towards.z), b = towards.x * towards.y * a;
    vec3 x = vec3(1.0 + s * towards.x * towards.x * a, s * b, -s * towards.x);
    vec3 y = vec3(b, s + towards.y * towards.y * a, -towards.y);
    vec3 direction = (x * cos(angle) + y * sin(angle)) * across + towards * (1.0 - fallen);
    return solid_angle_sample(direction, 1.0 / (6.2831853 * height));
}
