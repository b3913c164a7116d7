/* A solver in C: surface tension on a block of fluid, which its corners must feel first. */
#include <meniscus/meniscus.h>

#include <stdio.h>

enum { edge = 8, count = edge * edge * edge, max_neighbors = 40 };

static float positions[count][3];
static float accelerations[count][3];
static uint32_t offsets[count + 1];
static uint32_t neighbors[count * max_neighbors];

static const float support_radius = 1;
static const float spacing = 0.5F;

static void place_particles(void) {
    for (int i = 0; i < count; ++i) {
        positions[i][0] = spacing * (float)(i % edge);
        positions[i][1] = spacing * (float)(i / edge % edge);
        positions[i][2] = spacing * (float)(i / edge / edge);
    }
}

static void find_neighbors(void) {
    uint32_t found = 0;
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t j = 0; j < count; ++j) {
            float squared = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const float step = positions[j][axis] - positions[i][axis];
                squared += step * step;
            }
            if (j != i && squared < support_radius * support_radius)
                neighbors[found++] = j;
        }
        offsets[i + 1] = found;
    }
}

static int failed(void) {
    fprintf(stderr, "c_solver: %s\n", meniscus_last_error());
    return 1;
}

int main(void) {
    place_particles();
    find_neighbors();

    /* Once. */
    meniscus_options options;
    meniscus_surface* surface;
    if (meniscus_options_init(&options, sizeof options) != MENISCUS_OK)
        return failed();
    options.spacing_ratio = support_radius / spacing;
    if (meniscus_create(&surface, &options, 3, MENISCUS_FLOAT) != MENISCUS_OK)
        return failed();

    /* Each step. */
    meniscus_particles fluid = {0};
    fluid.size = sizeof fluid;
    fluid.count = count;
    fluid.positions = positions;
    fluid.support_radius = support_radius;
    fluid.offsets = offsets;
    fluid.neighbors = neighbors;
    fluid.offset_bits = 32;
    if (meniscus_step(surface, &fluid) != MENISCUS_OK ||
        meniscus_balance_momentum(surface, &fluid) != MENISCUS_OK ||
        meniscus_add_accelerations(surface, NULL, 0.125, accelerations, 0) != MENISCUS_OK)
        return failed();

    meniscus_destroy(surface);
    printf("meniscus %s: corner drawn by %g m/s^2\n", meniscus_version(),
           (double)accelerations[0][0]);
    return accelerations[0][0] > 0 && accelerations[count - 1][0] < 0 ? 0 : 1;
}
