/* What a solver in C does: its own particles, its own lists, and the library for the rest. */
#include "c_host.h"

#include <meniscus/meniscus.h>

#include <math.h>
#include <string.h>

enum { edge = 9, particles = edge * edge * edge, max_pairs = particles * 40 };

static double positions[particles][3];
static uint32_t offsets[particles + 1];
static uint32_t neighbors[max_pairs];
static double accelerations[particles][3];

static void fill_block(void) {
    int i = 0;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x, ++i) {
                positions[i][0] = 0.5 * x;
                positions[i][1] = 0.5 * y;
                positions[i][2] = 0.5 * z;
            }
}

static void find_neighbors(double radius) {
    uint32_t count = 0;
    for (int i = 0; i < particles; ++i) {
        for (int j = 0; j < particles; ++j) {
            const double x = positions[j][0] - positions[i][0];
            const double y = positions[j][1] - positions[i][1];
            const double z = positions[j][2] - positions[i][2];
            if (i != j && x * x + y * y + z * z < radius * radius)
                neighbors[count++] = (uint32_t)j;
        }
        offsets[i + 1] = count;
    }
}

static const char* use(meniscus_surface* surface) {
    meniscus_particles fluid = {0};
    fluid.size = sizeof fluid;
    fluid.count = particles;
    fluid.positions = positions;
    fluid.support_radius = 1;
    fluid.offsets = offsets;
    fluid.neighbors = neighbors;
    fluid.offset_bits = 32;
    if (meniscus_check(surface, &fluid) != MENISCUS_OK ||
        meniscus_step(surface, &fluid) != MENISCUS_OK ||
        meniscus_balance_momentum(surface, &fluid) != MENISCUS_OK ||
        meniscus_add_accelerations(surface, NULL, 0.125, accelerations, 0) != MENISCUS_OK)
        return meniscus_last_error();

    meniscus_results found = {0};
    found.size = sizeof found;
    if (meniscus_get_results(surface, &found) != MENISCUS_OK)
        return meniscus_last_error();
    const int middle = particles / 2;
    if (found.slot_of[middle] >= 0)
        return "the middle of the block is no interior";
    if (found.slot_of[0] != 0 || found.surface_class[0] != MENISCUS_AT_SURFACE)
        return "a corner of the block is no surface";
    if (!(((const double*)found.curvature)[0] > 0))
        return "a corner of the block is not convex";
    if (!(accelerations[0][0] > 0 && accelerations[0][1] > 0 && accelerations[0][2] > 0))
        return "a corner of the block is not drawn inwards";
    double sum = 0;
    double sizes = 0;
    for (int i = 0; i < particles; ++i) {
        sum += accelerations[i][0];
        sizes += fabs(accelerations[i][0]);
    }
    return fabs(sum) < 1e-12 * sizes ? NULL : "a free block has a net force";
}

const char* run_c_host(void) {
    fill_block();
    find_neighbors(1);
    meniscus_options options;
    if (meniscus_options_init(&options, sizeof options) != MENISCUS_OK)
        return meniscus_last_error();
    options.spacing_ratio = 2;
    meniscus_surface* surface;
    if (meniscus_create(&surface, &options, 3, MENISCUS_DOUBLE) != MENISCUS_OK)
        return meniscus_last_error();
    const char* wrong = use(surface);
    meniscus_destroy(surface);
    return wrong;
}
