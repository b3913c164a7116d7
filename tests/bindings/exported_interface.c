/* Prints what programs that were built with meniscus.h rely on: sizes of its structs, where members
 * lie, and enumerators. exported_interface.txt holds what it printed when that was last changed on
 * purpose; exported_interface_test.py compares. */
#include <meniscus/meniscus.h>

#include <stdio.h>

#define STRUCT(type) printf("struct %s: %zu bytes\n", #type, sizeof(type))
#define MEMBER(type, name)                                                                         \
    printf("  %s at %zu, %zu bytes\n", #name, offsetof(type, name), sizeof(((type*)0)->name))
#define ENUMERATOR(name) printf("%s = %d\n", #name, (int)name)

int main(void) {
    STRUCT(meniscus_second_line);
    MEMBER(meniscus_second_line, features);
    MEMBER(meniscus_second_line, k);
    MEMBER(meniscus_second_line, d);
    MEMBER(meniscus_second_line, surface_above);
    STRUCT(meniscus_curvature_map);
    MEMBER(meniscus_curvature_map, coefficients);
    MEMBER(meniscus_curvature_map, min);
    MEMBER(meniscus_curvature_map, max);
    MEMBER(meniscus_curvature_map, averaged);
    STRUCT(meniscus_options);
    MEMBER(meniscus_options, size);
    MEMBER(meniscus_options, k);
    MEMBER(meniscus_options, d);
    MEMBER(meniscus_options, boundary_weight);
    MEMBER(meniscus_options, radius_ratio);
    MEMBER(meniscus_options, samples);
    MEMBER(meniscus_options, seed);
    MEMBER(meniscus_options, fade);
    MEMBER(meniscus_options, tau);
    MEMBER(meniscus_options, covariance_share);
    MEMBER(meniscus_options, surface_tension);
    MEMBER(meniscus_options, spacing_ratio);
    MEMBER(meniscus_options, contact_angle);
    MEMBER(meniscus_options, ambient_pressure);
    MEMBER(meniscus_options, second_line);
    MEMBER(meniscus_options, curvature_map);
    MEMBER(meniscus_options, coverage);
    MEMBER(meniscus_options, verification);
    MEMBER(meniscus_options, curvature);
    MEMBER(meniscus_options, force);
    MEMBER(meniscus_options, normal_passes);
    MEMBER(meniscus_options, curvature_passes);
    MEMBER(meniscus_options, threads);
    STRUCT(meniscus_particles);
    MEMBER(meniscus_particles, size);
    MEMBER(meniscus_particles, count);
    MEMBER(meniscus_particles, positions);
    MEMBER(meniscus_particles, stride);
    MEMBER(meniscus_particles, masses);
    MEMBER(meniscus_particles, support_radius);
    MEMBER(meniscus_particles, support_radii);
    MEMBER(meniscus_particles, ids);
    MEMBER(meniscus_particles, offsets);
    MEMBER(meniscus_particles, neighbors);
    MEMBER(meniscus_particles, offset_bits);
    MEMBER(meniscus_particles, boundary_count);
    MEMBER(meniscus_particles, boundary_positions);
    MEMBER(meniscus_particles, boundary_offsets);
    MEMBER(meniscus_particles, boundary_neighbors);
    MEMBER(meniscus_particles, boundary_weights);
    MEMBER(meniscus_particles, boundary_contact_angles);
    MEMBER(meniscus_particles, candidates);
    MEMBER(meniscus_particles, wall_count);
    MEMBER(meniscus_particles, wall_distances);
    MEMBER(meniscus_particles, wall_normals);
    MEMBER(meniscus_particles, wall_contact_angles);
    STRUCT(meniscus_results);
    MEMBER(meniscus_results, size);
    MEMBER(meniscus_results, slots);
    MEMBER(meniscus_results, count);
    MEMBER(meniscus_results, particle);
    MEMBER(meniscus_results, slot_of);
    MEMBER(meniscus_results, surface_class);
    MEMBER(meniscus_results, uncovered_fraction);
    MEMBER(meniscus_results, normal);
    MEMBER(meniscus_results, curvature);
    MEMBER(meniscus_results, force);
    ENUMERATOR(MENISCUS_OK);
    ENUMERATOR(MENISCUS_BAD_ARGUMENT);
    ENUMERATOR(MENISCUS_OUT_OF_MEMORY);
    ENUMERATOR(MENISCUS_FAILURE);
    ENUMERATOR(MENISCUS_FLOAT);
    ENUMERATOR(MENISCUS_DOUBLE);
    ENUMERATOR(MENISCUS_SAMPLED);
    ENUMERATOR(MENISCUS_EXACT);
    ENUMERATOR(MENISCUS_VERIFY);
    ENUMERATOR(MENISCUS_DROP);
    ENUMERATOR(MENISCUS_CLOSED_CURVATURE);
    ENUMERATOR(MENISCUS_MAPPED_CURVATURE);
    ENUMERATOR(MENISCUS_PAPER_FORCE);
    ENUMERATOR(MENISCUS_CALIBRATED_FORCE);
    ENUMERATOR(MENISCUS_INTERIOR);
    ENUMERATOR(MENISCUS_COVERED);
    ENUMERATOR(MENISCUS_AT_SURFACE);
    return 0;
}
