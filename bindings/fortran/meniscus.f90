! The C interface (meniscus/meniscus.h, which says what all of it means) for Fortran 2003 and later.
! The installed file is source, since each compiler has modules of its own: compile it with your
! program and link with -lmeniscus_c. Names are those of C; arrays are handed over by c_loc() of
! targets, whose first index runs over the coordinates: positions(3, count). Indices count from 0, as
! in C: neighbors hold j - 1. examples/06_fortran.f90 is a whole step.
!
! Programs may be built with -ffpe-trap: what is calculated in the library raises nothing in them.
module meniscus
    use, intrinsic :: iso_c_binding
    implicit none
    public

    enum, bind(c) ! status
        enumerator :: MENISCUS_OK = 0, MENISCUS_BAD_ARGUMENT = 1, MENISCUS_OUT_OF_MEMORY = 2, &
            MENISCUS_FAILURE = 3
    end enum
    enum, bind(c) ! precision
        enumerator :: MENISCUS_FLOAT = 0, MENISCUS_DOUBLE = 1
    end enum
    enum, bind(c) ! coverage
        enumerator :: MENISCUS_SAMPLED = 0, MENISCUS_EXACT = 1
    end enum
    enum, bind(c) ! verification
        enumerator :: MENISCUS_VERIFY = 0, MENISCUS_DROP = 1
    end enum
    enum, bind(c) ! curvature
        enumerator :: MENISCUS_CLOSED_CURVATURE = 0, MENISCUS_MAPPED_CURVATURE = 1
    end enum
    enum, bind(c) ! force
        enumerator :: MENISCUS_PAPER_FORCE = 0, MENISCUS_CALIBRATED_FORCE = 1
    end enum
    enum, bind(c) ! class of a particle
        enumerator :: MENISCUS_INTERIOR = 0, MENISCUS_COVERED = 1, MENISCUS_AT_SURFACE = 2
    end enum

    type, bind(c) :: meniscus_second_line
        type(c_ptr) :: features(2) = c_null_ptr
        real(c_double) :: k = 0, d = 0
        integer(c_int) :: surface_above = 0
    end type

    type, bind(c) :: meniscus_curvature_map
        real(c_double) :: coefficients(4) = 0
        real(c_double) :: min = 0, max = 0
        integer(c_int) :: averaged = 1
    end type

    ! Set by meniscus_options_init or meniscus_options_paper, then changed.
    type, bind(c) :: meniscus_options
        integer(c_size_t) :: size = 0
        real(c_double) :: k = 0, d = 0
        real(c_double) :: boundary_weight = 0
        real(c_double) :: radius_ratio = 0
        integer(c_size_t) :: samples = 0
        integer(c_int64_t) :: seed = 0
        real(c_double) :: fade = 0
        real(c_double) :: tau = 0
        real(c_double) :: covariance_share = 0
        real(c_double) :: surface_tension = 0
        real(c_double) :: spacing_ratio = 0
        real(c_double) :: contact_angle = 0
        real(c_double) :: ambient_pressure = 0
        type(c_ptr) :: second_line = c_null_ptr
        type(c_ptr) :: curvature_map = c_null_ptr
        integer(c_int) :: coverage = 0
        integer(c_int) :: verification = 0
        integer(c_int) :: curvature = 0
        integer(c_int) :: force = 0
        integer(c_int) :: normal_passes = 0
        integer(c_int) :: curvature_passes = 0
        integer(c_int) :: threads = 0
    end type

    ! A new one is empty; set size to c_sizeof() of it, then count, positions, a radius and lists.
    type, bind(c) :: meniscus_particles
        integer(c_size_t) :: size = 0
        integer(c_size_t) :: count = 0
        type(c_ptr) :: positions = c_null_ptr
        integer(c_size_t) :: stride = 0
        type(c_ptr) :: masses = c_null_ptr
        real(c_double) :: support_radius = 0
        type(c_ptr) :: support_radii = c_null_ptr
        type(c_ptr) :: ids = c_null_ptr
        type(c_ptr) :: offsets = c_null_ptr
        type(c_ptr) :: neighbors = c_null_ptr
        integer(c_int) :: offset_bits = 32
        integer(c_size_t) :: boundary_count = 0
        type(c_ptr) :: boundary_positions = c_null_ptr
        type(c_ptr) :: boundary_offsets = c_null_ptr
        type(c_ptr) :: boundary_neighbors = c_null_ptr
        type(c_ptr) :: boundary_weights = c_null_ptr
        type(c_ptr) :: boundary_contact_angles = c_null_ptr
        type(c_ptr) :: candidates = c_null_ptr
        integer(c_size_t) :: wall_count = 0
        type(c_ptr) :: wall_distances = c_null_ptr
        type(c_ptr) :: wall_normals = c_null_ptr
        type(c_ptr) :: wall_contact_angles = c_null_ptr
    end type

    type, bind(c) :: meniscus_results
        integer(c_size_t) :: size = 0
        integer(c_size_t) :: slots = 0
        integer(c_size_t) :: count = 0
        type(c_ptr) :: particle = c_null_ptr
        type(c_ptr) :: slot_of = c_null_ptr
        type(c_ptr) :: surface_class = c_null_ptr
        type(c_ptr) :: uncovered_fraction = c_null_ptr
        type(c_ptr) :: normal = c_null_ptr
        type(c_ptr) :: curvature = c_null_ptr
        type(c_ptr) :: force = c_null_ptr
    end type

    interface
        function meniscus_options_init(options, size) bind(c) result(status)
            import :: c_int, c_size_t, meniscus_options
            type(meniscus_options), intent(inout) :: options
            integer(c_size_t), value :: size
            integer(c_int) :: status
        end function

        function meniscus_options_paper(options, size) bind(c) result(status)
            import :: c_int, c_size_t, meniscus_options
            type(meniscus_options), intent(inout) :: options
            integer(c_size_t), value :: size
            integer(c_int) :: status
        end function

        function meniscus_create(surface, options, dimension, precision) bind(c) result(status)
            import :: c_int, c_ptr, meniscus_options
            type(c_ptr), intent(out) :: surface
            type(meniscus_options), intent(in) :: options
            integer(c_int), value :: dimension, precision
            integer(c_int) :: status
        end function

        subroutine meniscus_destroy(surface) bind(c)
            import :: c_ptr
            type(c_ptr), value :: surface
        end subroutine

        function meniscus_reserve(surface, particles, neighbors) bind(c) result(status)
            import :: c_int, c_ptr, c_size_t
            type(c_ptr), value :: surface
            integer(c_size_t), value :: particles, neighbors
            integer(c_int) :: status
        end function

        function meniscus_set_samples(surface, samples) bind(c) result(status)
            import :: c_int, c_ptr, c_size_t
            type(c_ptr), value :: surface
            integer(c_size_t), value :: samples
            integer(c_int) :: status
        end function

        function meniscus_set_samples_for_time_step(surface, time_step, sampling_density, minimum) &
            bind(c) result(status)
            import :: c_double, c_int, c_ptr, c_size_t
            type(c_ptr), value :: surface
            real(c_double), value :: time_step, sampling_density
            integer(c_size_t), value :: minimum
            integer(c_int) :: status
        end function

        function meniscus_set_line(surface, k, d) bind(c) result(status)
            import :: c_double, c_int, c_ptr
            type(c_ptr), value :: surface
            real(c_double), value :: k, d
            integer(c_int) :: status
        end function

        function meniscus_set_surface_tension(surface, surface_tension) bind(c) result(status)
            import :: c_double, c_int, c_ptr
            type(c_ptr), value :: surface
            real(c_double), value :: surface_tension
            integer(c_int) :: status
        end function

        function meniscus_set_contact_angle(surface, contact_angle) bind(c) result(status)
            import :: c_double, c_int, c_ptr
            type(c_ptr), value :: surface
            real(c_double), value :: contact_angle
            integer(c_int) :: status
        end function

        function meniscus_set_fade(surface, fade) bind(c) result(status)
            import :: c_double, c_int, c_ptr
            type(c_ptr), value :: surface
            real(c_double), value :: fade
            integer(c_int) :: status
        end function

        function meniscus_set_smoothing(surface, normal_passes, curvature_passes) bind(c) &
            result(status)
            import :: c_int, c_ptr
            type(c_ptr), value :: surface
            integer(c_int), value :: normal_passes, curvature_passes
            integer(c_int) :: status
        end function

        function meniscus_spacing_ratio(support_radius, volume, dimension, spacing_ratio) bind(c) &
            result(status)
            import :: c_double, c_int
            real(c_double), value :: support_radius, volume
            integer(c_int), value :: dimension
            real(c_double), intent(out) :: spacing_ratio
            integer(c_int) :: status
        end function

        function meniscus_capillary_time_step(surface_tension, density, spacing, time_step) &
            bind(c) result(status)
            import :: c_double, c_int
            real(c_double), value :: surface_tension, density, spacing
            real(c_double), intent(out) :: time_step
            integer(c_int) :: status
        end function

        function meniscus_step(surface, particles) bind(c) result(status)
            import :: c_int, c_ptr, meniscus_particles
            type(c_ptr), value :: surface
            type(meniscus_particles), intent(in) :: particles
            integer(c_int) :: status
        end function

        function meniscus_check(surface, particles) bind(c) result(status)
            import :: c_int, c_ptr, meniscus_particles
            type(c_ptr), value :: surface
            type(meniscus_particles), intent(in) :: particles
            integer(c_int) :: status
        end function

        function meniscus_balance_momentum(surface, particles) bind(c) result(status)
            import :: c_int, c_ptr, meniscus_particles
            type(c_ptr), value :: surface
            type(meniscus_particles), intent(in) :: particles
            integer(c_int) :: status
        end function

        function meniscus_get_results(surface, results) bind(c) result(status)
            import :: c_int, c_ptr, meniscus_results
            type(c_ptr), value :: surface
            type(meniscus_results), intent(inout) :: results
            integer(c_int) :: status
        end function

        ! c_null_ptr for what is not wanted.
        function meniscus_scatter(surface, surface_class, uncovered_fraction, normal, curvature, &
            force, stride) bind(c) result(status)
            import :: c_int, c_ptr, c_size_t
            type(c_ptr), value :: surface, surface_class, uncovered_fraction, normal, curvature, &
                force
            integer(c_size_t), value :: stride
            integer(c_int) :: status
        end function

        function meniscus_add_accelerations(surface, masses, mass, accelerations, stride) bind(c) &
            result(status)
            import :: c_double, c_int, c_ptr, c_size_t
            type(c_ptr), value :: surface, masses
            real(c_double), value :: mass
            type(c_ptr), value :: accelerations
            integer(c_size_t), value :: stride
            integer(c_int) :: status
        end function
    end interface

    interface ! C's strings, of which the two functions below make Fortran's
        function meniscus_c_version() bind(c, name="meniscus_version") result(text)
            import :: c_ptr
            type(c_ptr) :: text
        end function

        function meniscus_c_last_error() bind(c, name="meniscus_last_error") result(text)
            import :: c_ptr
            type(c_ptr) :: text
        end function

        function meniscus_c_length(text) bind(c, name="strlen") result(length)
            import :: c_ptr, c_size_t
            type(c_ptr), value :: text
            integer(c_size_t) :: length
        end function
    end interface
    private :: meniscus_c_version, meniscus_c_last_error, meniscus_c_length, fortran_text

contains

    function meniscus_version() result(text)
        character(len=:), allocatable :: text
        text = fortran_text(meniscus_c_version())
    end function

    function meniscus_last_error() result(text)
        character(len=:), allocatable :: text
        text = fortran_text(meniscus_c_last_error())
    end function

    function fortran_text(from) result(text)
        type(c_ptr), intent(in) :: from
        character(len=:), allocatable :: text
        character(kind=c_char), pointer :: letters(:)
        integer :: n
        call c_f_pointer(from, letters, [meniscus_c_length(from)])
        allocate (character(len=size(letters)) :: text)
        do n = 1, size(letters)
            text(n:n) = letters(n)
        end do
    end function
end module
