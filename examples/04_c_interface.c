/* The same step for solvers in C: a cube of 8^3 particles, of which the outer layer is surface, and
 * whose forces have no sum. */
#include <meniscus/meniscus.h>

#include <math.h>
#include <stdio.h>

enum { edge = 8, count = edge * edge * edge, inner = edge - 2, max_neighbors = 40 };

static double positions[count][3];
static double forces[count][3];
static uint8_t classes[count];
static uint32_t offsets[count + 1];
static uint32_t neighbors[count * max_neighbors];

static const double support_radius = 2; /* the spacing is 1 */

static void place_particles(void) {
    for (int i = 0; i < count; ++i) {
        positions[i][0] = i % edge;
        positions[i][1] = i / edge % edge;
        positions[i][2] = i / edge / edge;
    }
}

static void find_neighbors(void) {
    uint32_t found = 0;
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t j = 0; j < count; ++j) {
            double squared = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double step = positions[j][axis] - positions[i][axis];
                squared += step * step;
            }
            if (j != i && squared < support_radius * support_radius)
                neighbors[found++] = j;
        }
        offsets[i + 1] = found;
    }
}

static int failed(void) {
    fprintf(stderr, "%s\n", meniscus_last_error());
    return 1;
}

int main(void) {
    place_particles();
    find_neighbors();

    meniscus_options options;
    meniscus_surface* surface;
    if (meniscus_options_init(&options, sizeof options) != MENISCUS_OK)
        return failed();
    options.surface_tension = 0.072;
    options.spacing_ratio = support_radius;
    if (meniscus_create(&surface, &options, 3, MENISCUS_DOUBLE) != MENISCUS_OK)
        return failed();

    meniscus_particles fluid = {0};
    fluid.size = sizeof fluid;
    fluid.count = count;
    fluid.positions = positions;
    fluid.support_radius = support_radius;
    fluid.offsets = offsets;
    fluid.neighbors = neighbors;
    fluid.offset_bits = 32;
    if (meniscus_check(surface, &fluid) != MENISCUS_OK || /* while the solver is new */
        meniscus_step(surface, &fluid) != MENISCUS_OK ||
        meniscus_balance_momentum(surface, &fluid) != MENISCUS_OK ||
        meniscus_scatter(surface, classes, NULL, NULL, NULL, forces, 0) != MENISCUS_OK)
        return failed();
    meniscus_destroy(surface);

    int at_surface = 0;
    double sum = 0;
    double size = 0;
    for (int i = 0; i < count; ++i) {
        at_surface += classes[i] == MENISCUS_AT_SURFACE ? 1 : 0;
        sum += forces[i][0];
        size += fabs(forces[i][0]);
    }
    printf("%d of %d particles at the surface, net force %.1e of all\n", at_surface, (int)count,
           fabs(sum) / size);
    return at_surface == count - inner * inner * inner && fabs(sum) < 1e-12 * size ? 0 : 1;
}
