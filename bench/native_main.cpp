// meniscus_bench_native: the tables of what a host compiles into its own loop, compiled for the
// machine that it is built on.
#include "support/tables.hpp"

int main(int argument_count, char** arguments) {
    return meniscus::print_tables(argument_count, arguments, {meniscus::surface_speed_tables()});
}
