// The published method by hand, for comparison only: Peters and Dachsbacher 2019 with the formulas that their
// supplement has, and its weaknesses: differences that cancel, and an inverse of a segment's area by a quintic.
// (Theirs is not in the supplement; this is that of benches/published.rs, good to 9e-4 of the height.)

const float PUBLISHED_PI = 3.14159265;

struct published_sample {
    vec3 direction;
    float pdf;
    float projected_pdf;
};

// x of the chord that cuts this area off the unit disk.
float published_chord(float area) {
    float near = clamp(area, 0.0, PUBLISHED_PI);
    near = min(near, PUBLISHED_PI - near);
    float quintic = fma(fma(fma(fma(fma(0.0450588, near, -0.1887698), near, 0.291167), near, -0.20133703), near,
                            0.10920828), near, 0.6557483);
    float x = 1.0 - pow(near, 2.0 / 3.0) * quintic;
    return area < 0.5 * PUBLISHED_PI ? x : -x;
}

published_sample published_sample_once(vec3 normal, vec3 centre, float radius, float u0, float u1) {
    float inv_distance = inversesqrt(dot(centre, centre));
    vec3 towards = centre * inv_distance;
    float w_z = dot(normal, towards);
    float u = inversesqrt(1.0 - w_z * w_z);
    vec3 tangent = (towards - normal * w_z) * u;
    vec3 sideways = cross(normal, tangent);
    float w_x = dot(tangent, towards);
    float r_y = radius * inv_distance, r_x = w_z * r_y, r_z = w_x * r_y;
    float v = sqrt(1.0 - r_y * r_y);
    float c_x = v * w_x, c_z = v * w_z;
    float across = 2.0 * u1 - 1.0;
    float disk_area = 0.0, ellipse_area = PUBLISHED_PI * r_x * r_y, kept = PUBLISHED_PI, t_y = 0.0;
    bool is_cut = w_z < r_y, is_below = w_z <= 0.0;
    if (is_cut) {
        float t_x = v * u;
        t_y = sqrt(1.0 - t_x * t_x);
        disk_area = acos(t_x) - t_x * t_y;
        if (!is_below) {
            float end = (t_x - c_x) / r_x;
            kept = 0.5 * PUBLISHED_PI + asin(end) + end * sqrt(1.0 - end * end);
            ellipse_area = kept * r_x * r_y;
        }
    }
    float x, y, z, density;
    if (is_cut && is_below) {
        float d_x = published_chord(u0 * disk_area);
        float d_y = across * sqrt(max(0.0, 1.0 - d_x * d_x));
        float d_z = sqrt(max(0.0, 1.0 - d_x * d_x - d_y * d_y));
        float stretch = (c_z + r_z) / t_y;
        z = d_z * stretch;
        float from_centre = z - c_z, r_z2 = r_z * r_z;
        float width = r_y * sqrt((r_z2 - from_centre * from_centre) / (r_z2 * (t_y * t_y - d_z * d_z)));
        y = d_y * width;
        x = sqrt(max(0.0, 1.0 - y * y - z * z));
        density = x / (stretch * stretch * disk_area * d_x * width);
    } else {
        float total = ellipse_area + disk_area;
        float area = u0 * total;
        if (area < ellipse_area || !is_cut) {
            float xi = -published_chord(area * kept / ellipse_area);
            x = r_x * xi + c_x;
            y = across * r_y * sqrt(max(0.0, 1.0 - xi * xi));
        } else {
            x = published_chord(total - area);
            y = across * sqrt(max(0.0, 1.0 - x * x));
        }
        z = sqrt(max(0.0, 1.0 - x * x - y * y));
        density = 1.0 / total;
    }
    return published_sample(tangent * x + sideways * y + normal * z, density * z, density);
}
