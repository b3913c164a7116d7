// meniscus_bench TABLE [FILES...]: prints any table of docs/ that is measured (--help lists them).
#include "support/tables.hpp"

int main(int argument_count, char** arguments) {
    using namespace meniscus;
    return print_tables(argument_count, arguments,
                        {{"Methods of this project beside those of others", compared_tables()},
                         accuracy_tables(),
                         training_time_tables(),
                         detector_threshold_tables(),
                         sampling_tables(),
                         label_speed_tables(),
                         label_scaling_tables(),
                         classification_tables(),
                         normal_circle_tables(),
                         normal_saddle_tables(),
                         normal_ratio_tables(),
                         curvature_cloud_tables(),
                         curvature_map_tables(),
                         force_tables(),
                         surface_speed_tables(),
                         scene_tables(),
                         solver_tables(),
                         contact_angle_tables(),
                         step_speed_tables(),
                         droplet_tables()});
}
