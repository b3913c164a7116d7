/* Calls each function of the C interface once, and says what came of it. Exit status 0 where all
 * went well, 3 where a call answered that memory or the machine fell short, in words; 4 for any
 * other answer. For failed_calls.py. */
#include <meniscus/meniscus.h>

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { edge = 5, particles = edge * edge * edge, max_pairs = particles * 40 };

static double positions[particles][3];
static uint32_t offsets[particles + 1];
static uint32_t neighbors[max_pairs];
static double vectors[particles][3];
static double numbers[particles];
static uint8_t classes[particles];

static void fill_block(void) {
    for (int i = 0; i < particles; ++i) {
        positions[i][0] = 0.5 * (i % edge);
        positions[i][1] = 0.5 * (i / edge % edge);
        positions[i][2] = 0.5 * (i / edge / edge);
    }
    uint32_t count = 0;
    for (int i = 0; i < particles; ++i) {
        for (int j = 0; j < particles; ++j) {
            double squared = 0;
            for (int axis = 0; axis < 3; ++axis)
                squared += (positions[j][axis] - positions[i][axis]) *
                           (positions[j][axis] - positions[i][axis]);
            if (i != j && squared < 1)
                neighbors[count++] = (uint32_t)j;
        }
        offsets[i + 1] = count;
    }
}

static int worst = 0;

/* 1 where the call went well. */
static int went_well(const char* name, int status) {
    if (status == MENISCUS_OK)
        return 1;
    const int fell_short = status == MENISCUS_OUT_OF_MEMORY || status == MENISCUS_FAILURE;
    const int has_words = strlen(meniscus_last_error()) > 0;
    const int exit_status = fell_short && has_words ? 3 : 4;
    printf("%s: %d: %s\n", name, status, meniscus_last_error());
    worst = exit_status > worst ? exit_status : worst;
    return 0;
}
#define CALL(FUNCTION, ...) went_well(#FUNCTION, FUNCTION(__VA_ARGS__))

static void use(meniscus_surface* surface) {
    meniscus_particles fluid = {0};
    fluid.size = sizeof fluid;
    fluid.count = particles;
    fluid.positions = positions;
    fluid.support_radius = 1;
    fluid.offsets = offsets;
    fluid.neighbors = neighbors;
    fluid.offset_bits = 32;
    meniscus_results found = {0};
    found.size = sizeof found;
    if (CALL(meniscus_check, surface, &fluid) && CALL(meniscus_reserve, surface, particles, 40) &&
        CALL(meniscus_set_samples, surface, 32) &&
        CALL(meniscus_set_samples_for_time_step, surface, 1e-3, 32000, 16) &&
        CALL(meniscus_set_line, surface, 75, 13) &&
        CALL(meniscus_set_surface_tension, surface, 0.05) &&
        CALL(meniscus_set_contact_angle, surface, 60) && CALL(meniscus_set_fade, surface, 0) &&
        CALL(meniscus_set_smoothing, surface, 1, 1) && CALL(meniscus_step, surface, &fluid) &&
        CALL(meniscus_balance_momentum, surface, &fluid) &&
        CALL(meniscus_get_results, surface, &found) &&
        CALL(meniscus_scatter, surface, classes, numbers, vectors, numbers, vectors, 3))
        CALL(meniscus_add_accelerations, surface, NULL, 0.125, vectors, 3);
}

int main(void) {
    fill_block();
    double number = 0;
    meniscus_options options;
    CALL(meniscus_spacing_ratio, 1, 0.125, 3, &number);
    CALL(meniscus_capillary_time_step, 0.05, 1000, 0.5, &number);
    CALL(meniscus_options_paper, &options, sizeof options);
    CALL(meniscus_options_init, &options, sizeof options);
    options.spacing_ratio = 2;
    options.threads = 2;
    meniscus_surface* surface;
    if (CALL(meniscus_create, &surface, &options, 3, MENISCUS_DOUBLE))
        use(surface);
    meniscus_destroy(surface);
    return worst;
}
