! The same step for solvers in Fortran: a cube of 8^3 particles, of which the outer layer is surface,
! and whose forces have no sum.
program fortran_step
    use meniscus
    implicit none

    integer, parameter :: edge = 8, count = edge**3, inner = (edge - 2)**3
    real(c_double), parameter :: support_radius = 2 ! the spacing is 1

    real(c_double), target :: positions(3, count), accelerations(3, count)
    integer(c_int32_t), target :: offsets(count + 1), neighbors(40 * count)
    integer(c_int8_t), target :: classes(count)
    type(meniscus_options) :: options
    type(meniscus_particles) :: fluid
    type(c_ptr) :: surface
    integer :: at_surface

    call place_particles
    call find_neighbors

    call demand(meniscus_options_init(options, c_sizeof(options)))
    options%surface_tension = 0.072_c_double
    call demand(meniscus_spacing_ratio(support_radius, 1.0_c_double, 3, options%spacing_ratio))
    call demand(meniscus_create(surface, options, 3, MENISCUS_DOUBLE))

    fluid%size = c_sizeof(fluid)
    fluid%count = count
    fluid%positions = c_loc(positions)
    fluid%support_radius = support_radius
    fluid%offsets = c_loc(offsets)
    fluid%neighbors = c_loc(neighbors)
    fluid%offset_bits = 32
    call demand(meniscus_check(surface, fluid)) ! while the solver is new
    call demand(meniscus_step(surface, fluid))
    call demand(meniscus_balance_momentum(surface, fluid))
    accelerations = 0
    call demand(meniscus_add_accelerations(surface, c_null_ptr, 1.0_c_double, &
                                           c_loc(accelerations), 3_c_size_t))
    call demand(meniscus_scatter(surface, c_loc(classes), c_null_ptr, c_null_ptr, c_null_ptr, &
                                 c_null_ptr, 0_c_size_t))
    call meniscus_destroy(surface)

    at_surface = 0
    block
        integer :: i
        do i = 1, count
            if (classes(i) == MENISCUS_AT_SURFACE) at_surface = at_surface + 1
        end do
    end block
    print '(i0, " of ", i0, " particles at the surface, version ", a)', at_surface, count, &
        meniscus_version()
    if (at_surface /= count - inner) error stop "the surface is not the outer layer"
    if (any(abs(sum(accelerations, 2)) > 1e-12_c_double * sum(abs(accelerations)))) &
        error stop "a free cube has a net force"

contains

    subroutine place_particles
        integer :: i
        do i = 0, count - 1
            positions(:, i + 1) = real([mod(i, edge), mod(i / edge, edge), i / edge**2], c_double)
        end do
    end subroutine

    ! Indices count from 0.
    subroutine find_neighbors
        integer :: i, j, found
        found = 0
        offsets(1) = 0
        do i = 1, count
            do j = 1, count
                if (i == j) cycle
                if (sum((positions(:, i) - positions(:, j))**2) >= support_radius**2) cycle
                found = found + 1
                neighbors(found) = j - 1
            end do
            offsets(i + 1) = found
        end do
    end subroutine

    subroutine demand(status)
        integer(c_int), intent(in) :: status
        if (status == MENISCUS_OK) return
        print '(a)', meniscus_last_error()
        error stop 1
    end subroutine
end program
